#include "graph/faces/long_faces.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

// Longer walks are no faces, however they are cut.
constexpr std::size_t LONGEST_TO_CUT = 256;

constexpr std::size_t NOT_THERE = ~std::size_t (0);

} // namespace

LongFaces::LongFaces (const ContactRows& rows, std::size_t maximum_length)
  : rows_ (rows), maximum_length_ (maximum_length), is_chord_ (rows.tile.size (), 0),
    position_ (rows.tiles (), NOT_THERE)
{}

void
LongFaces::cut (Tiles face, std::vector<Tiles>& faces, std::vector<Tiles>& holes)
{
  std::vector<Tiles> parts;
  parts.push_back (std::move (face));
  while (!parts.empty ()) {
    Tiles part = std::move (parts.back ());
    parts.pop_back ();
    if (part.size () <= maximum_length_) {
      faces.push_back (std::move (part));
      continue;
    }
    const std::size_t chord = part.size () <= LONGEST_TO_CUT ? strongestChord (part) : ContactRows::NONE;
    if (chord == ContactRows::NONE) {
      holes.push_back (std::move (part));
      continue;
    }
    const pcl::index_t to = rows_.tile[chord];
    const auto end = std::find (part.begin (), part.end (), to);
    const auto begin =
      std::find_if (part.begin (), end, [&] (pcl::index_t from) { return rows_.find (from, to) == chord; });
    is_chord_[chord] = is_chord_[rows_.find (to, *begin)] = 1;
    chords_.push_back ({std::min (*begin, to), std::max (*begin, to)});
    parts.emplace_back (begin, end + 1);
    part.erase (begin + 1, end);
    parts.push_back (std::move (part));
  }
}

// The contact that has most boundary points of those between tiles of a face that are no edges yet, seen from
// that one of both tiles that comes first.
std::size_t
LongFaces::strongestChord (const Tiles& face)
{
  for (std::size_t i = face.size (); i-- > 0;)
    position_[face[i]] = i;
  std::size_t strongest = ContactRows::NONE;
  for (std::size_t i = 0; i < face.size (); ++i) {
    if (position_[face[i]] != i)
      continue;
    for (std::size_t contact = rows_.starts[face[i]]; contact < rows_.starts[face[i] + 1]; ++contact) {
      const std::size_t j = position_[rows_.tile[contact]];
      if (j != NOT_THERE && i < j && rows_.adjacent[contact] == 0 && is_chord_[contact] == 0 &&
          (strongest == ContactRows::NONE ||
           rows_.boundary_points[contact] > rows_.boundary_points[strongest]))
        strongest = contact;
    }
  }
  for (const pcl::index_t tile : face)
    position_[tile] = NOT_THERE;
  return strongest;
}

} // namespace manifold
} // namespace pcl
