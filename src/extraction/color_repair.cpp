#include "extraction/color_repair.h"

#include "common/parallel.h"
#include "extraction/cell_star.h"
#include "extraction/facet_set.h"
#include "extraction/fan.h"
#include "voronoi/voronoi_cell.h"

#include <algorithm>
#include <deque>

namespace pcl {
namespace manifold {

namespace {

// Changes at one sample after which it is given up: most settle after one or two.
constexpr std::uint8_t MAX_CHANGES = 8;

bool
isOnSurface (const DelaunayComplex& complex, std::int32_t sample, const std::vector<std::uint8_t>& colors)
{
  const VoronoiCell star (complex, sample);
  return std::any_of (star.begin (), star.end (),
                      [&] (std::int32_t cell) { return colors[cell] != colors[*star.begin ()]; });
}

class Repair
{
public:
  Repair (const SurfaceCandidates& candidates, bool closed, std::vector<std::uint8_t>& colors)
    : candidates_ (candidates), complex_ (candidates.complex ()), roles_ (candidates.roles ()),
      closed_ (closed), colors_ (colors), changes_ (roles_.size (), 0), queued_ (roles_.size (), 0),
      star_ (complex_)
  {}

  std::size_t run ()
  {
    findBad ();
    while (!queue_.empty ()) {
      const std::int32_t sample = queue_.front ();
      queue_.pop_front ();
      queued_[sample] = 0;
      settle (sample);
    }
    return given_up_;
  }

private:
  bool isBad (std::int32_t sample) const
  {
    if (!closed_ && roles_[sample] != Role::SURFACE && roles_[sample] != Role::RIM)
      return false;
    return crossesItself (complex_, colors_, sample) &&
           (closed_ || !candidates_.areManifoldAt (sample, colors_));
  }

  void findBad ()
  {
    std::vector<std::uint8_t> bad (roles_.size (), 0);
    parallelFor (roles_.size (),
                 [&] (std::size_t i) { bad[i] = isBad (static_cast<std::int32_t> (i)) ? 1 : 0; });
    for (std::size_t i = 0; i < bad.size (); ++i)
      if (bad[i])
        enqueue (static_cast<std::int32_t> (i));
  }

  void enqueue (std::int32_t sample)
  {
    if (queued_[sample])
      return;
    queued_[sample] = 1;
    queue_.push_back (sample);
  }

  void settle (std::int32_t sample)
  {
    if (!isBad (sample))
      return;
    star_.split (sample, colors_);
    if (changes_[sample] < MAX_CHANGES) {
      ++changes_[sample];
      change (star_.cellsOf (star_.smallest (closed_))); // the outside stays the outside
    } else {
      ++given_up_;
      const VoronoiCell star (complex_, sample);
      std::vector<std::int32_t> inside;
      std::copy_if (star.begin (), star.end (), std::back_inserter (inside),
                    [this] (std::int32_t cell) { return colors_[cell] != 0; });
      change (inside);
    }
  }

  void change (const std::vector<std::int32_t>& cells)
  {
    for (const std::int32_t cell : cells)
      colors_[cell] ^= 1;
    for (const std::int32_t cell : cells)
      for (const std::int32_t vertex : complex_.cells[cell])
        if (vertex != DelaunayComplex::INFINITE_VERTEX)
          enqueue (vertex);
  }

  const SurfaceCandidates& candidates_;
  const DelaunayComplex& complex_;
  const std::vector<Role>& roles_;
  bool closed_;
  std::vector<std::uint8_t>& colors_;
  std::vector<std::uint8_t> changes_;
  std::vector<std::uint8_t> queued_;
  std::deque<std::int32_t> queue_;
  CellStar star_;
  std::size_t given_up_ = 0;
};

} // namespace

bool
crossesItself (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors, std::int32_t sample)
{
  Fan fan;
  VoronoiCell (complex, sample).forEachFacet ([&] (std::int32_t a, std::int32_t b, int facet) {
    if (colors[a] == colors[b])
      return;
    const std::array<std::int32_t, 2> side = oppositeSide (complex, a, facet, sample);
    fan.add (side[0], side[1]);
  });
  return fan.size () > 0 && !fan.isClosed ();
}

std::size_t
repairColors (const SurfaceCandidates& candidates, bool closed, std::vector<std::uint8_t>& colors)
{
  return Repair (candidates, closed, colors).run ();
}

std::size_t
insertSamples (const SampleDimensions& dimensions, const std::vector<Role>& roles,
               std::vector<std::uint8_t>& colors)
{
  const DelaunayComplex& complex = *dimensions.complex;
  std::vector<std::uint8_t> missing (roles.size (), 0);
  parallelFor (roles.size (), [&] (std::size_t i) {
    if (roles[i] == Role::SURFACE || roles[i] == Role::RIM)
      missing[i] = isOnSurface (complex, static_cast<std::int32_t> (i), colors) ? 0 : 1;
  });
  std::size_t left = 0;
  for (std::size_t i = 0; i < missing.size (); ++i) {
    if (!missing[i])
      continue;
    const auto sample = static_cast<std::int32_t> (i);
    if (isOnSurface (complex, sample, colors)) // an insertion nearby may have done it
      continue;
    std::int32_t best = -1;
    double best_radius = 0.0;
    const VoronoiCell star (complex, sample);
    for (const std::int32_t cell : star) {
      if (complex.isInfinite (cell))
        continue;
      const auto opposite = std::find (complex.cells[cell].begin (), complex.cells[cell].end (), sample) -
                            complex.cells[cell].begin ();
      const double radius = star.vertex (cell).squaredNorm ();
      if (colors[complex.neighbors[cell][opposite]] != colors[cell] && (best < 0 || radius < best_radius)) {
        best = cell;
        best_radius = radius;
      }
    }
    if (best >= 0)
      colors[best] ^= 1;
    else
      ++left;
  }
  return left;
}

} // namespace manifold
} // namespace pcl
