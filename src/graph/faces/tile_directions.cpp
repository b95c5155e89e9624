#include "graph/faces/tile_directions.h"

#include "common/parallel.h"
#include "common/parity_forest.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cstdlib>

namespace pcl {
namespace manifold {

namespace {

// A meeting point of two adjacent tiles and one that follows them in both rotations tells so much, one of a
// tile that is not adjacent to them a tenth of it.
constexpr std::int64_t EVIDENCE = 1600;
constexpr std::int64_t FAINT = 10;

// What tells less is as good as nothing.
constexpr std::int64_t LEAST_EVIDENCE = EVIDENCE / 5;

// What is known of the directions of two adjacent tiles.
struct Comparison
{
  std::size_t contact; ///< of the smaller tile
  std::size_t twin;    ///< of the other one
  std::int64_t evidence = 0;
  bool opposite = false;
};

// Where a tile is in a rotation, as seen from another one in it.
struct Side
{
  std::int64_t steps = 0; ///< the fewer, the surer; 0 = neither before nor behind it
  bool behind = false;
};

class DirectionFinder
{
public:
  DirectionFinder (const ContactRows& rows, const TileRotations& rotations)
    : rows_ (rows), rotations_ (rotations)
  {}

  void compare (pcl::index_t first, Comparison& comparison) const
  {
    const pcl::index_t second = rows_.tile[comparison.contact];
    std::int64_t balance = 0;
    // Every tile that is next to the other end in one of both rotations, once.
    visitNext (first, comparison.contact, [&] (std::size_t contact, std::int32_t meeting_points) {
      balance += tell (comparison, first, second, contact, meeting_points);
    });
    visitNext (second, comparison.twin, [&] (std::size_t contact, std::int32_t meeting_points) {
      const std::size_t seen_from_first = rows_.find (first, rows_.tile[contact]);
      if (seen_from_first != ContactRows::NONE &&
          sideOf (first, comparison.contact, seen_from_first).steps > 1)
        balance += tell (comparison, first, second, seen_from_first, meeting_points);
    });
    comparison.evidence = std::abs (balance);
    comparison.opposite = balance < 0;
  }

private:
  // What a contact of the first tile tells: more than 0 that both go the same way.
  std::int64_t tell (const Comparison& comparison, pcl::index_t first, pcl::index_t second,
                     std::size_t contact, std::int32_t meeting_points) const
  {
    const std::size_t other = rows_.find (second, rows_.tile[contact]);
    if (other == ContactRows::NONE)
      return 0;
    const Side here = sideOf (first, comparison.contact, contact);
    const Side there = sideOf (second, comparison.twin, other);
    if (here.steps == 0 || there.steps == 0)
      return 0;
    std::int64_t evidence = EVIDENCE / 4 * (4 * static_cast<std::int64_t> (meeting_points) + 1);
    if (rows_.adjacent[contact] == 0 || rows_.adjacent[other] == 0)
      evidence /= FAINT;
    evidence /= here.steps * there.steps;
    return here.behind != there.behind ? evidence : -evidence;
  }

  // Calls visit for the contacts next to one in the rotation of a tile, if they are of the same arc.
  template <typename Visit>
  void visitNext (pcl::index_t tile, std::size_t contact, const Visit& visit) const
  {
    const std::size_t place = rotations_.place_of[contact];
    const std::size_t begin = rows_.starts[tile];
    const std::size_t end = rows_.starts[tile + 1];
    const std::size_t next = place + 1 < end ? place + 1 : begin;
    const std::size_t before = place > begin ? place - 1 : end - 1;
    visit (rotations_.contact_at[next], rotations_.meeting_points[place]);
    if (before != next)
      visit (rotations_.contact_at[before], rotations_.meeting_points[before]);
  }

  Side sideOf (pcl::index_t tile, std::size_t from, std::size_t contact) const
  {
    const auto a = static_cast<std::int64_t> (rotations_.place_of[from]);
    const auto b = static_cast<std::int64_t> (rotations_.place_of[contact]);
    if (rotations_.whole[tile] == 0) {
      const bool together =
        rotations_.arc[rotations_.place_of[from]] == rotations_.arc[rotations_.place_of[contact]];
      return together ? Side{std::abs (b - a), b > a} : Side{};
    }
    const auto size = static_cast<std::int64_t> (rows_.size (tile));
    const std::int64_t steps = b < a ? b - a + size : b - a;
    if (2 * steps == size)
      return {};
    return {std::min (steps, size - steps), 2 * steps < size};
  }

  const ContactRows& rows_;
  const TileRotations& rotations_;
};

std::vector<Comparison>
compareAll (const ContactRows& rows, const TileRotations& rotations)
{
  std::vector<Comparison> comparisons;
  std::vector<pcl::index_t> first;
  for (std::size_t tile = 0; tile < rows.tiles (); ++tile)
    for (std::size_t contact = rows.starts[tile]; contact < rows.starts[tile + 1]; ++contact)
      if (rows.adjacent[contact] != 0 && rows.tile[contact] > static_cast<pcl::index_t> (tile)) {
        first.push_back (static_cast<pcl::index_t> (tile));
        comparisons.push_back ({contact, rows.find (rows.tile[contact], first.back ())});
      }
  const DirectionFinder finder (rows, rotations);
  parallelFor (comparisons.size (), [&] (std::size_t i) { finder.compare (first[i], comparisons[i]); });
  return comparisons;
}

// Turns the arcs of tiles that do not agree with the first one of their tile.
// \return per place whether it is in such an arc
std::vector<std::uint8_t>
turnArcs (const ContactRows& rows, const MeetingPoints& meetings, TileRotations& rotations,
          ParityForest& forest)
{
  std::vector<std::uint8_t> turned (rows.tile.size (), 0);
  for (std::size_t tile = 0; tile < rows.tiles (); ++tile) {
    const std::size_t begin = rows.starts[tile];
    for (std::size_t place = begin; place < rows.starts[tile + 1]; ++place) {
      const std::size_t arc = rotations.arc[place];
      if (arc == begin || arc != place ||
          forest.unite (static_cast<std::uint32_t> (begin), static_cast<std::uint32_t> (arc), false) ||
          forest.find (static_cast<std::uint32_t> (begin)).second ==
            forest.find (static_cast<std::uint32_t> (arc)).second)
        continue;
      const std::size_t end = rotations.reverseArc (rows, meetings, static_cast<pcl::index_t> (tile), arc);
      std::fill (turned.begin () + static_cast<std::ptrdiff_t> (arc),
                 turned.begin () + static_cast<std::ptrdiff_t> (end), 1);
    }
  }
  return turned;
}

} // namespace

std::vector<std::uint8_t>
alignRotations (const ContactRows& rows, const MeetingPoints& meetings, TileRotations& rotations)
{
  std::vector<Comparison> comparisons = compareAll (rows, rotations);
  tbb::parallel_sort (comparisons.begin (), comparisons.end (),
                      [] (const Comparison& a, const Comparison& b) {
                        return a.evidence != b.evidence ? a.evidence > b.evidence : a.contact < b.contact;
                      });

  // Arcs are known by their first places.
  ParityForest forest (rows.tile.size ());
  const auto arcAt = [&] (std::size_t contact) {
    return static_cast<std::uint32_t> (rotations.arc[rotations.place_of[contact]]);
  };
  const auto isKnown = [] (const Comparison& comparison) { return comparison.evidence >= LEAST_EVIDENCE; };
  for (const Comparison& comparison : comparisons)
    if (isKnown (comparison))
      forest.unite (arcAt (comparison.contact), arcAt (comparison.twin), comparison.opposite);
  const std::vector<std::uint8_t> turned = turnArcs (rows, meetings, rotations, forest);

  std::vector<std::uint8_t> opposite (rows.tile.size (), 0);
  for (const Comparison& comparison : comparisons) {
    const std::size_t places[2] = {rotations.place_of[comparison.contact],
                                   rotations.place_of[comparison.twin]};
    bool result = comparison.opposite != (turned[places[0]] != turned[places[1]]);
    if (!isKnown (comparison)) {
      const std::uint32_t a = static_cast<std::uint32_t> (rows.starts[rows.tile[comparison.twin]]);
      const std::uint32_t b = static_cast<std::uint32_t> (rows.starts[rows.tile[comparison.contact]]);
      forest.unite (a, b, false);
      result = forest.find (a).second != forest.find (b).second;
    }
    opposite[comparison.contact] = opposite[comparison.twin] = result ? 1 : 0;
  }
  return opposite;
}

} // namespace manifold
} // namespace pcl
