#include "graph/faces/tile_rotations.h"

#include "common/parallel.h"
#include "graph/faces/cyclic_order.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

constexpr std::size_t TILES_PER_PIECE = 16;

// 256 times the logarithm to base 2, linear between powers of two: the same on every machine.
std::int32_t
logarithm (std::int32_t x)
{
  std::int32_t exponent = 0;
  while (x >> exponent > 1)
    ++exponent;
  return 256 * (exponent - 1) + static_cast<std::int32_t> ((static_cast<std::int64_t> (x) << 8) >> exponent);
}

// Finds the rotations of single tiles, and keeps its memory.
class RotationFinder
{
public:
  RotationFinder (const ContactRows& rows, const MeetingPoints& meetings, TileRotations& rotations)
    : rows_ (rows), meetings_ (meetings), rotations_ (rotations)
  {}

  void find (pcl::index_t tile)
  {
    tile_ = tile;
    begin_ = rows_.starts[tile];
    size_ = rows_.size (tile);
    if (size_ <= CyclicOrder::MOST_THINGS)
      findBest ();
    else
      findHeavy ();
    store ();
    findCosts ();
  }

private:
  // Calls visit (a, b), a < b, for every meeting point of the tile with its a-th and b-th neighbours.
  template <typename Visit>
  void visitPairs (const Visit& visit)
  {
    meetings_.visit (tile_, [&] (const pcl::index_t* begin, const pcl::index_t* end) {
      seen_.clear ();
      for (const pcl::index_t* other = begin; other != end; ++other)
        if (const std::size_t contact = rows_.find (tile_, *other); contact != ContactRows::NONE)
          seen_.push_back (static_cast<std::uint32_t> (contact - begin_));
      for (std::size_t i = 1; i < seen_.size (); ++i)
        for (std::size_t j = 0; j < i; ++j)
          visit (std::min (seen_[i], seen_[j]), std::max (seen_[i], seen_[j]));
    });
  }

  void findBest ()
  {
    points_.assign (size_ * size_, 0);
    visitPairs ([this] (std::uint32_t a, std::uint32_t b) { ++points_[a * size_ + b]; });
    cyclic_.reset (size_);
    for (std::uint32_t a = 0; a < size_; ++a)
      for (std::uint32_t b = a + 1; b < size_; ++b)
        cyclic_.set (a, b,
                     followWeight (points_[a * size_ + b],
                                   rows_.strength (rows_.tile[begin_ + a], rows_.tile[begin_ + b])));
    order_ = cyclic_.find ();
  }

  void findHeavy ()
  {
    pairs_.clear ();
    visitPairs ([this] (std::uint32_t a, std::uint32_t b) { pairs_.push_back ({a, b, 1}); });
    std::sort (pairs_.begin (), pairs_.end (), isBefore);
    std::size_t distinct = 0;
    for (const FollowWeight& pair : pairs_)
      if (distinct > 0 && !isBefore (pairs_[distinct - 1], pair))
        ++pairs_[distinct - 1].weight;
      else
        pairs_[distinct++] = pair;
    pairs_.resize (distinct);
    order_ = joinHeaviestFirst (size_, pairs_);
  }

  static bool isBefore (const FollowWeight& p, const FollowWeight& q)
  {
    return p.a != q.a ? p.a < q.a : p.b < q.b;
  }

  std::int32_t meetingPoints (std::uint32_t a, std::uint32_t b) const
  {
    if (a > b)
      std::swap (a, b);
    if (size_ <= CyclicOrder::MOST_THINGS)
      return points_[a * size_ + b];
    const auto found = std::lower_bound (pairs_.begin (), pairs_.end (), FollowWeight{a, b, 0}, isBefore);
    return found != pairs_.end () && found->a == a && found->b == b ? found->weight : 0;
  }

  void store ()
  {
    for (std::size_t i = 0; i < size_; ++i) {
      const std::size_t place = begin_ + i;
      rotations_.contact_at[place] = begin_ + order_[i];
      rotations_.place_of[begin_ + order_[i]] = place;
      rotations_.meeting_points[place] = size_ < 2 ? 0 : meetingPoints (order_[i], after (i));
      rotations_.arc[place] = begin_;
    }
  }

  // Of parts of at least two neighbours that leave as many outside.
  void findCosts ()
  {
    if (size_ < 4 || size_ > CyclicOrder::MOST_THINGS)
      return;
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = i + 2; j < size_ && j - i <= size_ - 2; ++j) {
        const std::int32_t cost =
          cyclic_.weight (order_[i], after (i)) + cyclic_.weight (order_[j], after (j)) -
          cyclic_.weight (order_[i], order_[j]) - cyclic_.weight (after (i), after (j));
        for (const std::size_t end : {i, j})
          rotations_.cost_of_turning[begin_ + end] =
            std::min (rotations_.cost_of_turning[begin_ + end], cost);
      }
  }

  std::uint32_t after (std::size_t i) const { return order_[i + 1 < size_ ? i + 1 : 0]; }

  const ContactRows& rows_;
  const MeetingPoints& meetings_;
  TileRotations& rotations_;
  pcl::index_t tile_ = 0;
  std::size_t begin_ = 0; ///< of the contacts of the tile
  std::size_t size_ = 0;
  std::vector<std::uint32_t> seen_;
  std::vector<std::int32_t> points_; ///< meeting points of pairs of few neighbours
  std::vector<FollowWeight> pairs_;  ///< those of many, in ascending order
  CyclicOrder cyclic_;
  std::vector<std::uint32_t> order_;
};

} // namespace

std::int32_t
followWeight (std::int32_t meeting_points, std::int32_t boundary_points)
{
  return 5 * logarithm (1 + meeting_points) + 2 * logarithm (1 + boundary_points);
}

TileRotations::TileRotations (const ContactRows& rows, const MeetingPoints& meetings)
  : contact_at (rows.tile.size ()), place_of (rows.tile.size ()), meeting_points (rows.tile.size ()),
    cost_of_turning (rows.tile.size (), std::numeric_limits<std::int32_t>::max ()), arc (rows.tile.size ()),
    whole (rows.tiles (), 1)
{
  parallelRanges (
    rows.tiles (),
    [&] (std::size_t begin, std::size_t end) {
      RotationFinder finder (rows, meetings, *this);
      for (std::size_t tile = begin; tile < end; ++tile)
        finder.find (static_cast<pcl::index_t> (tile));
    },
    TILES_PER_PIECE);
}

void
TileRotations::breakIntoArcs (const ContactRows& rows, std::int32_t free_to_turn)
{
  const auto isEnd = [&] (std::size_t place) { return cost_of_turning[place] < free_to_turn; };
  for (std::size_t tile = 0; tile < rows.tiles (); ++tile) {
    const std::size_t begin = rows.starts[tile];
    const std::size_t end = rows.starts[tile + 1];
    std::size_t first = end;
    while (first > begin && !isEnd (first - 1))
      --first;
    if (first == begin)
      continue;
    // The first arc begins at the first place.
    whole[tile] = 0;
    const auto rotate = [&] (auto& values) {
      const auto at = [&values] (std::size_t i) { return values.begin () + static_cast<std::ptrdiff_t> (i); };
      std::rotate (at (begin), at (first), at (end));
    };
    rotate (contact_at);
    rotate (meeting_points);
    rotate (cost_of_turning);
    std::size_t current = begin;
    for (std::size_t place = begin; place < end; ++place) {
      place_of[contact_at[place]] = place;
      arc[place] = current;
      if (isEnd (place))
        current = place + 1;
    }
  }
}

std::size_t
TileRotations::reverseArc (const ContactRows& rows, const MeetingPoints& meetings, pcl::index_t tile,
                           std::size_t first)
{
  const std::size_t begin = rows.starts[tile];
  std::size_t end = first + 1;
  while (end < rows.starts[tile + 1] && arc[end] == first)
    ++end;
  std::reverse (contact_at.begin () + static_cast<std::ptrdiff_t> (first),
                contact_at.begin () + static_cast<std::ptrdiff_t> (end));
  const auto update = [&] (std::size_t place) {
    place_of[contact_at[place]] = place;
    const std::size_t next = place + 1 < rows.starts[tile + 1] ? place + 1 : begin;
    meeting_points[place] = meetings.count (tile, rows.tile[contact_at[place]], rows.tile[contact_at[next]]);
  };
  update (first > begin ? first - 1 : rows.starts[tile + 1] - 1);
  for (std::size_t place = first; place < end; ++place)
    update (place);
  return end;
}

} // namespace manifold
} // namespace pcl
