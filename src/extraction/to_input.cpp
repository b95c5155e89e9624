#include "extraction/to_input.h"

namespace pcl {
namespace manifold {

namespace {

template <typename Simplex>
void
mapVertices (const SampleSet& samples, std::vector<Simplex>& simplices)
{
  for (Simplex& simplex : simplices)
    for (pcl::index_t& vertex : simplex)
      vertex = samples.input_index[vertex];
}

} // namespace

void
toInput (const SampleSet& samples, SimplicialComplex& shape)
{
  mapVertices (samples, shape.edges);
  mapVertices (samples, shape.triangles);
  mapVertices (samples, shape.tetrahedra);
}

} // namespace manifold
} // namespace pcl
