#include "graph/faces/meeting_points.h"

#include "common/parallel.h"

#include <algorithm>
#include <array>

namespace pcl {
namespace manifold {

namespace {

constexpr std::size_t VERTICES_PER_PIECE = 4096;
constexpr std::size_t FEWEST_TILES = 3;

// The meeting points among some vertices in a row.
struct Piece
{
  std::vector<pcl::index_t> seen;
  std::vector<std::size_t> sizes;
};

// The distinct tiles that a vertex sees.
class SeenTiles
{
public:
  SeenTiles (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& tiles, pcl::index_t vertex)
  {
    const pcl::index_t own = tiles[vertex];
    if (own < 0)
      return;
    tiles_[size_++] = own;
    // Neighbours in a row often are in the same tile.
    pcl::index_t last = own;
    for (const pcl::index_t* w = graph.begin (vertex); w != graph.end (vertex); ++w) {
      const pcl::index_t tile = tiles[*w];
      if (tile == last || tile < 0)
        continue;
      last = tile;
      if (!add (tile)) {
        size_ = 0;
        return;
      }
    }
  }

  std::size_t size () const { return size_; }

  const pcl::index_t* begin () const { return tiles_.data (); }

  const pcl::index_t* end () const { return tiles_.data () + size_; }

private:
  // False if there are too many.
  bool add (pcl::index_t tile)
  {
    if (std::find (begin (), end (), tile) != end ())
      return true;
    if (size_ == tiles_.size ())
      return false;
    tiles_[size_++] = tile;
    return true;
  }

  std::array<pcl::index_t, MeetingPoints::MOST_TILES> tiles_;
  std::size_t size_ = 0;
};

} // namespace

MeetingPoints::MeetingPoints (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& tiles,
                              std::size_t landmarks)
{
  std::vector<Piece> pieces ((tiles.size () + VERTICES_PER_PIECE - 1) / VERTICES_PER_PIECE);
  parallelFor (
    pieces.size (),
    [&] (std::size_t p) {
      const std::size_t end = std::min (tiles.size (), (p + 1) * VERTICES_PER_PIECE);
      for (std::size_t v = p * VERTICES_PER_PIECE; v < end; ++v) {
        const SeenTiles seen (graph, tiles, static_cast<pcl::index_t> (v));
        if (seen.size () < FEWEST_TILES)
          continue;
        pieces[p].seen.insert (pieces[p].seen.end (), seen.begin (), seen.end ());
        pieces[p].sizes.push_back (seen.size ());
      }
    },
    1);
  starts_.push_back (0);
  for (const Piece& piece : pieces) {
    seen_.insert (seen_.end (), piece.seen.begin (), piece.seen.end ());
    for (const std::size_t size : piece.sizes)
      starts_.push_back (starts_.back () + size);
  }
  groupByTile (landmarks);
}

void
MeetingPoints::groupByTile (std::size_t landmarks)
{
  starts_of_tile_.assign (landmarks + 1, 0);
  for (const pcl::index_t tile : seen_)
    ++starts_of_tile_[tile + 1];
  for (std::size_t t = 0; t < landmarks; ++t)
    starts_of_tile_[t + 1] += starts_of_tile_[t];
  of_tile_.resize (seen_.size ());
  std::vector<std::size_t> ends (starts_of_tile_.begin (), starts_of_tile_.end () - 1);
  for (std::size_t point = 0; point + 1 < starts_.size (); ++point)
    for (std::size_t i = starts_[point]; i < starts_[point + 1]; ++i)
      of_tile_[ends[seen_[i]]++] = static_cast<std::uint32_t> (point);
}

std::int32_t
MeetingPoints::count (pcl::index_t a, pcl::index_t b, pcl::index_t c) const
{
  std::int32_t points = 0;
  visit (a, [&] (const pcl::index_t* begin, const pcl::index_t* end) {
    points += std::find (begin, end, b) != end && std::find (begin, end, c) != end ? 1 : 0;
  });
  return points;
}

} // namespace manifold
} // namespace pcl
