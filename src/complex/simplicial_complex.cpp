#include <pcl/manifold/simplicial_complex.h>

#include "complex/tetrahedron_sides.h"

#include <pcl/console/print.h>

#include <algorithm>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

template <std::size_t N>
bool
areValid (const std::vector<std::array<pcl::index_t, N>>& simplices, std::size_t vertices, const char* kind,
          std::string* why)
{
  for (std::size_t i = 0; i < simplices.size (); ++i) {
    auto sorted = simplices[i];
    std::sort (sorted.begin (), sorted.end ());
    const char* fault = nullptr;
    if (sorted.front () < 0 || static_cast<std::size_t> (sorted.back ()) >= vertices)
      fault = " has a vertex that the cloud has not: ";
    else if (std::adjacent_find (sorted.begin (), sorted.end ()) != sorted.end ())
      fault = " has a vertex twice: ";
    if (fault == nullptr)
      continue;
    if (why != nullptr) {
      *why = std::string (kind) + " " + std::to_string (i) + fault + std::to_string (simplices[i][0]);
      for (std::size_t k = 1; k < N; ++k)
        *why += ", " + std::to_string (simplices[i][k]);
    }
    return false;
  }
  return true;
}

template <std::size_t N>
void
appendPolygons (const std::vector<std::array<pcl::index_t, N>>& simplices,
                std::vector<pcl::Vertices>& polygons)
{
  for (const auto& simplex : simplices) {
    polygons.emplace_back ();
    polygons.back ().vertices.assign (simplex.begin (), simplex.end ());
  }
}

} // namespace

bool
isValid (const SimplicialComplex& complex, std::size_t vertices, std::string* why)
{
  return areValid (complex.edges, vertices, "edge", why) &&
         areValid (complex.triangles, vertices, "triangle", why) &&
         areValid (complex.tetrahedra, vertices, "tetrahedron", why);
}

std::vector<SimplicialComplex::Triangle>
boundaryTriangles (const std::vector<SimplicialComplex::Tetrahedron>& tetrahedra)
{
  const TetrahedronSides sides (tetrahedra);
  std::vector<std::uint32_t> numbers;
  sides.forEachTriangle ([&] (auto first, auto last) {
    if (last - first == 1)
      numbers.push_back (*first);
  });
  std::sort (numbers.begin (), numbers.end ());
  return sidesOf (tetrahedra, numbers);
}

bool
toPolygonMesh (const SimplicialComplex& complex, const pcl::PCLPointCloud2& cloud, pcl::PolygonMesh& mesh)
{
  std::string why;
  if (!isValid (complex, static_cast<std::size_t> (cloud.width) * cloud.height, &why)) {
    PCL_ERROR ("[pcl::manifold::toPolygonMesh] %s\n", why.c_str ());
    mesh = pcl::PolygonMesh ();
    return false;
  }
  // Not built in place: the cloud may be the mesh's own.
  const std::vector<SimplicialComplex::Triangle> boundary = boundaryTriangles (complex.tetrahedra);
  pcl::PolygonMesh result;
  result.header = cloud.header;
  result.cloud = cloud;
  result.polygons.reserve (complex.edges.size () + complex.triangles.size () + boundary.size ());
  appendPolygons (complex.edges, result.polygons);
  appendPolygons (complex.triangles, result.polygons);
  appendPolygons (boundary, result.polygons);
  mesh = std::move (result);
  return true;
}

} // namespace manifold
} // namespace pcl
