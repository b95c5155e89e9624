#include "complex_layers.h"

#include "files/cloud_fields.h"
#include "table.h"

#include <cstring>
#include <stdexcept>

namespace pcl::manifold::apps {
namespace {

/** \brief A layer of simplices in the colour of a dimension; nothing is added if there are none. */
template <typename Simplices>
void
addLayer (std::vector<Layer>& layers, const std::shared_ptr<const Positions>& positions,
          const Simplices& simplices, int dimension, const std::string& what)
{
  if (simplices.empty ())
    return;
  Layer layer;
  layer.kind = simplices.front ().size () == 2 ? Layer::Kind::LINES : Layer::Kind::TRIANGLES;
  layer.positions = positions;
  layer.colour = dimensionColour (dimension);
  layer.name = dimensionName (dimension) + ": " + what;
  for (const auto& simplex : simplices)
    layer.corners.insert (layer.corners.end (), simplex.begin (), simplex.end ());
  layers.push_back (std::move (layer));
}

} // namespace

std::shared_ptr<const Positions>
positionsOf (const pcl::PCLPointCloud2& cloud)
{
  auto positions = std::make_shared<Positions> (static_cast<std::size_t> (cloud.width) * cloud.height);
  for (int axis = 0; axis < 3; ++axis) {
    const pcl::PCLPointField* field = findField (cloud, std::string (1, "xyz"[axis]));
    if (field == nullptr || field->datatype != pcl::PCLPointField::FLOAT32)
      throw std::invalid_argument ("the coordinates of the cloud are no floats");
    for (std::size_t i = 0; i < positions->size (); ++i)
      std::memcpy (&(*positions)[i][axis], &cloud.data[i * cloud.point_step + field->offset], sizeof (float));
  }
  return positions;
}

std::vector<Layer>
layersOf (const std::shared_ptr<const Positions>& positions, const pcl::SimplicialComplex& complex)
{
  std::vector<Layer> layers;
  addLayer (layers, positions, complex.edges, 1, grouped (complex.edges.size ()) + " edges");
  addLayer (layers, positions, complex.triangles, 2, grouped (complex.triangles.size ()) + " triangles");
  addLayer (layers, positions, pcl::manifold::boundaryTriangles (complex.tetrahedra), 3,
            grouped (complex.tetrahedra.size ()) + " tetrahedra");
  return layers;
}

} // namespace pcl::manifold::apps
