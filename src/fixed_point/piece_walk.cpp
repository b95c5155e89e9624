#include "fixed_point/piece_walk.h"

#include "fixed_point/facet_duals.h"
#include "fixed_point/facet_flags.h"
#include "fixed_point/predicates.h"
#include "voronoi/voronoi_cell.h"

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

constexpr std::int32_t INFINITE = DelaunayComplex::INFINITE_VERTEX;
constexpr std::int32_t NO_SAMPLE = -1;

} // namespace

const std::vector<Facet>&
PieceWalk::find (const Piece& piece, std::int32_t start)
{
  begin (piece);
  std::int32_t sample = nearestSample (piece[0], start);
  crossed_.clear ();
  for (int i = 0; i < 3; ++i)
    sample = walkSegment (piece[i], piece[(i + 1) % 3], sample, NO_SAMPLE, crossed_);
  std::for_each (crossed_.begin (), crossed_.end (), [this] (const Face& face) { push (face); });
  spread ();
  return found_;
}

const std::vector<Facet>&
PieceWalk::find (const Facet& facet)
{
  const std::array<std::int32_t, 3> samples = facetOf (complex_, facet.cell, facet.facet);
  begin ({point (samples[0]), point (samples[1]), point (samples[2])});
  bool all_gabriel = true;
  for (int i = 0; i < 3; ++i) {
    const Side& side = crossedBy ({samples[i], samples[(i + 1) % 3], facet.cell});
    all_gabriel = all_gabriel && side.gabriel;
    std::for_each (side.faces.begin (), side.faces.end (), [this] (const Face& face) { push (face); });
  }
  // From the middle of each side, which is inside of the face between its ends, to the circumcentre the
  // triangle stays in that face: where the centre is inside of its Voronoi edge, it meets no other one.
  if (all_gabriel && crosses (piece_, dualEdge (complex_, facet))) {
    pending_.clear ();
    found_.push_back (canonicalFacet (complex_, facet));
  }
  spread ();
  return found_;
}

void
PieceWalk::begin (const Piece& piece)
{
  piece_ = piece;
  faces_.clear ();
  found_.clear ();
}

std::int32_t
PieceWalk::nearestSample (const Eigen::Vector3d& where, std::int32_t start) const
{
  std::int32_t nearest = start;
  for (std::int32_t center = NO_SAMPLE; center != nearest;) {
    center = nearest;
    VoronoiCell (complex_, center).visitNeighbors ([&] (std::int32_t q) {
      if (nearer (where, point (nearest), point (q)) > 0)
        nearest = q;
    });
  }
  return nearest;
}

std::int32_t
PieceWalk::walkSegment (const Eigen::Vector3d& from, const Eigen::Vector3d& to, std::int32_t start,
                        std::int32_t end, std::vector<Face>& faces)
{
  for (std::int32_t sample = start; sample != end;) {
    const Eigen::Vector3d center = point (sample);
    std::int32_t next = NO_SAMPLE;
    touched_.clear ();
    VoronoiCell (complex_, sample).visitNeighbors ([&] (std::int32_t q) {
      const int side = nearer (to, center, point (q));
      if (side == 0)
        touched_.push_back (q);
      else if (side > 0 && q != next &&
               (next == NO_SAMPLE || crossesFirst (from, to, center, point (q), point (next)) < 0))
        next = q;
    });
    if (next == NO_SAMPLE) {
      for (const std::int32_t q : touched_)
        faces.push_back ({sample, q, cellAt (sample, q)});
      return sample;
    }
    // Where it crosses several faces at once one of them is enough: the others are found from there. Every
    // step leads to a sample nearer to the end of the segment.
    faces.push_back ({sample, next, cellAt (sample, next)});
    sample = next;
  }
  return end;
}

const PieceWalk::Side&
PieceWalk::crossedBy (const Face& edge)
{
  const std::uint64_t key = keyOf (edge.p, edge.q);
  Side& side = sides_[(key * 0x9e3779b97f4a7c15u >> 32) % REMEMBERED_SIDES];
  if (side.key == key)
    return side;
  side.key = key;
  side.faces.clear ();
  side.gabriel = isGabriel (edge);
  if (side.gabriel)
    side.faces.push_back (edge);
  else
    walkSegment (point (edge.p), point (edge.q), edge.p, edge.q, side.faces);
  return side;
}

bool
PieceWalk::isGabriel (const Face& face)
{
  ring_.collect (complex_, face.p, face.q, face.cell);
  return std::all_of (ring_.entries.begin (), ring_.entries.end (), [&] (const EdgeRing::Entry& entry) {
    return entry.sample == INFINITE || isOutsideBall (point (entry.sample), point (face.p), point (face.q));
  });
}

std::int32_t
PieceWalk::cellAt (std::int32_t p, std::int32_t q) const
{
  const VoronoiCell cells (complex_, p);
  return *std::find_if (cells.begin (), cells.end (), [&] (std::int32_t cell) {
    const DelaunayComplex::Cell& vertices = complex_.cells[cell];
    return std::find (vertices.begin (), vertices.end (), q) != vertices.end ();
  });
}

void
PieceWalk::push (const Face& face)
{
  if (faces_.insert (keyOf (face.p, face.q)))
    pending_.push_back (face);
}

void
PieceWalk::spread ()
{
  while (!pending_.empty ()) {
    const Face face = pending_.back ();
    pending_.pop_back ();
    visit (face);
  }
}

void
PieceWalk::visit (const Face& face)
{
  ring_.collect (complex_, face.p, face.q, face.cell);
  const FaceFilter filter (piece_, point (face.p), point (face.q));
  const std::size_t n = ring_.entries.size ();
  excesses_.resize (n);
  for (std::size_t i = 0; i < n; ++i)
    if (ring_.entries[i].sample != INFINITE)
      excesses_[i] = filter.excesses (point (ring_.entries[i].sample));
  for (std::size_t i = 0; i < n; ++i) {
    const EdgeRing::Entry& entry = ring_.entries[i];
    if (entry.sample == INFINITE)
      continue;
    const std::size_t behind = i == 0 ? n - 1 : i - 1;
    const std::size_t ahead = i + 1 == n ? 0 : i + 1;
    const auto bound = [&] (std::size_t k) {
      return ring_.entries[k].sample == INFINITE ? nullptr : &excesses_[k];
    };
    const Answer answer = filter.meets (excesses_[i], bound (behind), bound (ahead));
    if (answer == Answer::NO || (answer == Answer::UNCERTAIN && !meetsExactly (face, behind, i, ahead)))
      continue;
    push ({face.p, entry.sample, entry.cell});
    push ({face.q, entry.sample, entry.cell});
    // All three faces at the edge are visited: it is taken from one of them.
    if (entry.sample > face.p && entry.sample > face.q)
      found_.push_back (canonicalFacet (complex_, {entry.cell, entry.facet}));
  }
}

bool
PieceWalk::meetsExactly (const Face& face, std::size_t behind, std::size_t third, std::size_t ahead) const
{
  DualEdge edge{{point (face.p), point (face.q), point (ring_.entries[third].sample)}, {}, 0};
  for (const std::size_t bound : {behind, ahead})
    if (ring_.entries[bound].sample != INFINITE)
      edge.opposite[edge.bounds++] = point (ring_.entries[bound].sample);
  return pcl::manifold::meetsExactly (piece_, edge);
}

} // namespace manifold
} // namespace pcl
