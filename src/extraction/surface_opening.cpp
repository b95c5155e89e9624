#include "extraction/surface_opening.h"

#include "common/parallel.h"
#include "extraction/cell_star.h"
#include "extraction/color_changes.h"
#include "extraction/patches.h"
#include "extraction/surface_pruning.h"
#include "extraction/triangle_shape.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace manifold {

namespace {

// A patch of other triangles is inserted if its border has no more edges than this ...
constexpr int MAX_BORDER = 12;
// ... or if none of its triangles has a circumcircle more than this many times as large as the edges around
// it: the largest gaps in a random sample reach two. There were samples, only their cells are too irregular
// to vote.
constexpr double MAX_GAP = 3.0;

class Opening
{
public:
  Opening (const SurfaceCandidates& candidates, const std::vector<std::uint8_t>& colors)
    : complex_ (candidates.complex ()), colors_ (colors), surface_ (complex_)
  {
    const std::vector<Role>& roles = candidates.roles ();
    const std::vector<Facet> changes = colorChanges (complex_, colors);
    std::vector<std::uint8_t> candidate (changes.size ());
    parallelFor (changes.size (), [&] (std::size_t i) {
      candidate[i] =
        !hasInfiniteVertex (complex_, changes[i]) && candidates.contains (changes[i].cell, changes[i].facet);
    });
    for (std::size_t i = 0; i < changes.size (); ++i)
      if (candidate[i]) {
        surface_.insert (changes[i].cell, changes[i].facet);
        // The repair of colours does not look at samples of curves or inside of solids.
        for (const std::int32_t vertex : facetOf (complex_, changes[i].cell, changes[i].facet))
          if (roles[vertex] == Role::CURVE || roles[vertex] == Role::SOLID)
            touched_.push_back (vertex);
      } else {
        for (const std::int32_t vertex : facetOf (complex_, changes[i].cell, changes[i].facet))
          if (vertex != DelaunayComplex::INFINITE_VERTEX)
            touched_.push_back (vertex);
        if (!hasInfiniteVertex (complex_, changes[i]))
          others_.push_back (changes[i]);
      }
  }

  FacetSet run ()
  {
    std::vector<Patch> patches = findPatches (complex_, colors_, surface_, others_);
    patches.erase (std::remove_if (patches.begin (), patches.end (),
                                   [this] (const Patch& patch) { return isOpening (patch); }),
                   patches.end ());
    for (const Patch& patch : patches)
      for (const Facet& facet : patch.facets)
        surface_.insert (facet.cell, facet.facet);
    std::sort (touched_.begin (), touched_.end ());
    touched_.erase (std::unique (touched_.begin (), touched_.end ()), touched_.end ());
    closePinches ();
    eraseToManifold (touched_, surface_);
    return std::move (surface_);
  }

private:
  // Whether a patch spans something that was not sampled.
  bool isOpening (const Patch& patch) const
  {
    if (!patch.fills || patch.border == 0)
      return true;
    return patch.border > MAX_BORDER &&
           std::any_of (patch.facets.begin (), patch.facets.end (), [this] (const Facet& f) {
             double edges = 0.0;
             for (const std::int32_t vertex : facetOf (complex_, f.cell, f.facet))
               edges = std::max (edges, meanEdge (surface_, vertex));
             return std::sqrt (squaredCircumradius (complex_, f.cell, f.facet)) > MAX_GAP * edges;
           });
  }

  // Where triangles left out split the fan of a sample into several, takes back the smallest gaps between
  // them.
  void closePinches ()
  {
    CellStar star (complex_);
    std::vector<std::int32_t> queue (touched_.rbegin (), touched_.rend ());
    while (!queue.empty ()) {
      const std::int32_t sample = queue.back ();
      queue.pop_back ();
      star.split (sample, colors_);
      if (star.components () !=
          2) // the whole surface is no disk here: gaps are not between fans of one sheet
        continue;
      const std::vector<Facet> gap = smallestClosableGap (sample);
      std::vector<std::int32_t> vertices;
      for (const Facet& facet : gap) {
        surface_.insert (facet.cell, facet.facet);
        for (const std::int32_t vertex : facetOf (complex_, facet.cell, facet.facet))
          vertices.push_back (vertex);
      }
      if (std::all_of (vertices.begin (), vertices.end (),
                       [this] (std::int32_t vertex) { return isTwoSidedAt (vertex); }))
        queue.insert (queue.end (), vertices.begin (), vertices.end ());
      else
        for (const Facet& facet : gap)
          surface_.erase (facet.cell, facet.facet);
    }
  }

  // Whether the triangles at a sample have the cells of one colour on the same side: around a vertex of a gap
  // the colour may change more than twice.
  bool isTwoSidedAt (std::int32_t sample) const
  {
    Fan fan;
    surface_.forEachAt (sample, [&] (std::int32_t cell, int facet) {
      const std::array<std::int32_t, 2> side = oppositeSide (complex_, cell, facet, sample);
      fan.add (side[colors_[cell] == 1 ? 0 : 1], side[colors_[cell] == 1 ? 1 : 0]);
    });
    return fan.isDirected ();
  }

  // The facets of the smallest gap between the fans of a sample; none if there is one fan, or if all gaps but
  // one reach to infinity.
  std::vector<Facet> smallestClosableGap (std::int32_t sample) const
  {
    Fan fan;
    int fans = 0;
    surface_.fanAt (sample, fan);
    fan.split (fans);
    if (fans < 2)
      return {};
    Fan gap;
    std::vector<Facet> facets;
    VoronoiCell (complex_, sample).forEachEdge ([&] (std::int32_t a, std::int32_t b, int facet) {
      if (colors_[a] == colors_[b] || surface_.contains (a, facet))
        return;
      const std::array<std::int32_t, 2> side = oppositeSide (complex_, a, facet, sample);
      gap.add (side[0], side[1]);
      facets.push_back ({a, facet});
    });
    int gaps = 0;
    const std::vector<int>& gap_of = gap.split (gaps);
    std::vector<std::vector<Facet>> by_gap (gaps);
    for (std::size_t i = 0; i < facets.size (); ++i)
      by_gap[gap_of[i]].push_back (facets[i]);
    // A gap that reaches to infinity lacks its infinite triangles here, and so does not join two fans.
    std::vector<Facet> smallest;
    for (const std::vector<Facet>& candidate : by_gap)
      if ((smallest.empty () || candidate.size () < smallest.size ()) &&
          joinsTwoFans (sample, candidate, fans))
        smallest = candidate;
    return smallest;
  }

  bool joinsTwoFans (std::int32_t sample, const std::vector<Facet>& gap, int fans) const
  {
    Fan fan;
    surface_.fanAt (sample, fan);
    for (const Facet& facet : gap) {
      const std::array<std::int32_t, 2> side = oppositeSide (complex_, facet.cell, facet.facet, sample);
      fan.add (side[0], side[1]);
    }
    int joined = 0;
    fan.split (joined);
    return joined < fans;
  }

  const DelaunayComplex& complex_;
  const std::vector<std::uint8_t>& colors_;
  FacetSet surface_;
  std::vector<Facet> others_;
  std::vector<std::int32_t> touched_;
};

} // namespace

FacetSet
closedSurface (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors)
{
  FacetSet surface (complex);
  for (const Facet& change : colorChanges (complex, colors))
    if (!hasInfiniteVertex (complex, change))
      surface.insert (change.cell, change.facet);
  return surface;
}

FacetSet
openSurface (const SurfaceCandidates& candidates, const std::vector<std::uint8_t>& colors)
{
  return Opening (candidates, colors).run ();
}

} // namespace manifold
} // namespace pcl
