#include "extraction/surface_pruning.h"

#include "extraction/triangle_shape.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

class Pruning
{
public:
  explicit Pruning (FacetSet& surface) : complex_ (surface.complex ()), surface_ (surface) {}

  void run (std::vector<std::int32_t> samples)
  {
    std::reverse (samples.begin (), samples.end ());
    queue_ = std::move (samples);
    while (!queue_.empty ()) {
      const std::int32_t sample = queue_.back ();
      queue_.pop_back ();
      prune (sample);
    }
  }

private:
  void prune (std::int32_t sample)
  {
    collect (sample);
    if (fan_.isManifold ())
      return;
    while (eraseAtCrowdedEdge (sample))
      collect (sample);
    eraseSmallFans ();
  }

  void collect (std::int32_t sample)
  {
    fan_.clear ();
    facets_.clear ();
    surface_.forEachAt (sample, [&] (std::int32_t cell, int facet) {
      const std::array<std::int32_t, 2> side = oppositeSide (complex_, cell, facet, sample);
      fan_.add (side[0], side[1]);
      facets_.push_back ({cell, facet});
    });
  }

  // Of the triangles at an edge with more than two, erases the one with the largest circumcircle.
  bool eraseAtCrowdedEdge (std::int32_t sample)
  {
    const Facet* worst = nullptr;
    double worst_radius = -1.0;
    for (const Facet& facet : facets_)
      for (const std::int32_t vertex : oppositeSide (complex_, facet.cell, facet.facet, sample)) {
        const double radius = squaredCircumradius (complex_, facet.cell, facet.facet);
        if (fan_.degree (vertex) > 2 && radius > worst_radius) {
          worst = &facet;
          worst_radius = radius;
        }
      }
    if (worst == nullptr)
      return false;
    erase (*worst);
    return true;
  }

  void eraseSmallFans ()
  {
    int fans = 0;
    const std::vector<int> fan_of = fan_.split (fans);
    if (fans < 2)
      return;
    std::vector<int> sizes (fans, 0);
    for (const int fan : fan_of)
      ++sizes[fan];
    const auto largest = static_cast<int> (std::max_element (sizes.begin (), sizes.end ()) - sizes.begin ());
    for (std::size_t i = 0; i < facets_.size (); ++i)
      if (fan_of[i] != largest)
        erase (facets_[i]);
  }

  void erase (const Facet& facet)
  {
    surface_.erase (facet.cell, facet.facet);
    for (const std::int32_t vertex : facetOf (complex_, facet.cell, facet.facet))
      queue_.push_back (vertex);
  }

  const DelaunayComplex& complex_;
  FacetSet& surface_;
  std::vector<std::int32_t> queue_;
  std::vector<Facet> facets_;
  Fan fan_;
};

} // namespace

void
eraseToManifold (const std::vector<std::int32_t>& samples, FacetSet& surface)
{
  Pruning (surface).run (samples);
}

} // namespace manifold
} // namespace pcl
