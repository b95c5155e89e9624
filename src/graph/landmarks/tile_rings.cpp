#include "graph/landmarks/tile_rings.h"

#include "common/parallel.h"

#include <tbb/enumerable_thread_specific.h>

#include <cstddef>

namespace pcl {
namespace manifold {

namespace {

constexpr std::size_t TILES_PER_TASK = 64;
constexpr int RINGS = 2;

// Of the tiles around one tile; keeps its memory.
class TileRings
{
public:
  explicit TileRings (const ContactRows& rows) : rows_ (rows), steps_ (rows.tiles (), OUTSIDE) {}

  bool areDoubtful (pcl::index_t tile)
  {
    tiles_.assign (1, tile);
    steps_[tile] = 0;
    bool doubtful = false;
    std::size_t begin = 0;
    for (int step = 1; step <= RINGS && !doubtful; ++step) {
      const std::size_t end = tiles_.size ();
      for (; begin < end; ++begin)
        visitNeighbors (tiles_[begin], OUTSIDE, step);
      doubtful = !hangsTogether (begin, step);
    }
    for (const pcl::index_t seen : tiles_)
      steps_[seen] = OUTSIDE;
    return doubtful;
  }

private:
  static constexpr int OUTSIDE = -1;

  // Adds those neighbours of a tile to the tiles that are at some steps, and puts them at others.
  void visitNeighbors (pcl::index_t tile, int at, int put)
  {
    for (std::size_t contact = rows_.starts[tile]; contact < rows_.starts[tile + 1]; ++contact)
      if (int& steps = steps_[rows_.tile[contact]]; steps == at) {
        steps = put;
        tiles_.push_back (rows_.tile[contact]);
      }
  }

  // Whether the tiles from one on, all at the same steps, do; they are listed twice after that.
  bool hangsTogether (std::size_t begin, int step)
  {
    constexpr int COUNTED = RINGS + 1;
    const std::size_t end = tiles_.size ();
    if (begin == end)
      return false;
    steps_[tiles_[begin]] = COUNTED;
    tiles_.push_back (tiles_[begin]);
    for (std::size_t i = end; i < tiles_.size (); ++i)
      visitNeighbors (tiles_[i], step, COUNTED);
    const bool all = tiles_.size () - end == end - begin;
    tiles_.resize (end);
    return all;
  }

  const ContactRows& rows_;
  std::vector<int> steps_;
  std::vector<pcl::index_t> tiles_;
};

} // namespace

std::vector<std::uint8_t>
findDoubtfulTiles (const ContactRows& rows)
{
  std::vector<std::uint8_t> doubtful (rows.tiles ());
  tbb::enumerable_thread_specific<TileRings> rings ([&rows] { return TileRings (rows); });
  parallelFor (
    rows.tiles (),
    [&] (std::size_t i) { doubtful[i] = rings.local ().areDoubtful (static_cast<pcl::index_t> (i)) ? 1 : 0; },
    TILES_PER_TASK);
  return doubtful;
}

} // namespace manifold
} // namespace pcl
