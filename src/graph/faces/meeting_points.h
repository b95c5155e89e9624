#pragma once

#include <pcl/manifold/neighborhood_graph.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The vertices of the graph Voronoi diagram: those of the graph that see at least three tiles, their own and
 * those of their neighbours. They are around the corners of the tiles, and tell which tiles follow each other
 * along the border of a third one.
 *
 * Vertices that see very many tiles are left out: they tell nothing. */
class MeetingPoints
{
public:
  static constexpr std::size_t MOST_TILES = 8;

  /** Parallel in the current arena. */
  MeetingPoints (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& tiles,
                 std::size_t landmarks);

  /** Calls visit (begin, end) with the tiles that each meeting point of a tile sees, that tile among them,
   * every one once and in no particular order. */
  template <typename Visit>
  void visit (pcl::index_t tile, const Visit& visit) const
  {
    for (std::size_t i = starts_of_tile_[tile]; i < starts_of_tile_[tile + 1]; ++i) {
      const std::uint32_t point = of_tile_[i];
      visit (seen_.data () + starts_[point], seen_.data () + starts_[point + 1]);
    }
  }

  /** How many points see all of three distinct tiles. */
  std::int32_t count (pcl::index_t a, pcl::index_t b, pcl::index_t c) const;

private:
  void groupByTile (std::size_t landmarks);

  std::vector<std::size_t> starts_; ///< per point where its tiles start
  std::vector<pcl::index_t> seen_;
  std::vector<std::size_t> starts_of_tile_; ///< per tile where its points start
  std::vector<std::uint32_t> of_tile_;
};

} // namespace manifold
} // namespace pcl
