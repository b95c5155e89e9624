#pragma once

#include <pcl/manifold/graph_voronoi.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Per tile what it touches, in compressed rows: the contacts of tile t are starts[t] to starts[t + 1] - 1,
 * by ascending number of the other tile. So every pair of tiles that touch is there twice. */
struct ContactRows
{
  static constexpr std::size_t NONE = ~std::size_t (0);

  std::vector<std::size_t> starts; ///< one more than tiles
  std::vector<pcl::index_t> tile;  ///< the other tile
  std::vector<std::int32_t> boundary_points;
  std::vector<std::uint8_t> adjacent;

  /** \param[in] contacts in ascending order, as tileContacts gives them */
  ContactRows (std::size_t tiles, const std::vector<TileContact>& contacts);

  /** Leaves those tiles adjacent of which one is among so many that the other one touches by most boundary
   * points; of equal ones, those with the smaller numbers. */
  void limitAdjacency (std::size_t most);

  std::size_t tiles () const { return starts.size () - 1; }

  std::size_t size (pcl::index_t of) const { return starts[of + 1] - starts[of]; }

  /** The contact of a tile with another one, or NONE. */
  std::size_t find (pcl::index_t of, pcl::index_t other) const;

  /** The boundary points of two tiles, 0 if they do not touch. */
  std::int32_t strength (pcl::index_t a, pcl::index_t b) const
  {
    const std::size_t contact = find (a, b);
    return contact == NONE ? 0 : boundary_points[contact];
  }
};

} // namespace manifold
} // namespace pcl
