#include "mesh_distance.h"

#include <algorithm>
#include <cmath>

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPThreadLocal.h>
#include <vtkSMPThreadLocalObject.h>
#include <vtkSMPTools.h>
#include <vtkStaticCellLocator.h>

namespace pcl::manifold::apps {

struct MeshDistance::Search
{
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkStaticCellLocator> locator;
};

MeshDistance::MeshDistance (const TriangleMesh& mesh) : search_ (std::make_unique<Search> ())
{
  // Points of no triangle may be anything, so they are left out.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble ();
  vtkNew<vtkCellArray> triangles;
  std::vector<vtkIdType> number (static_cast<std::size_t> (mesh.points.cols ()), -1);
  for (const pcl::SimplicialComplex::Triangle& triangle : mesh.triangles) {
    triangles->InsertNextCell (3);
    for (const pcl::index_t vertex : triangle) {
      vtkIdType& own = number[static_cast<std::size_t> (vertex)];
      if (own < 0)
        own = points->InsertNextPoint (mesh.points.col (vertex).data ());
      triangles->InsertCellPoint (own);
    }
  }
  search_->mesh->SetPoints (points);
  search_->mesh->SetPolys (triangles);
  search_->locator->SetDataSet (search_->mesh);
  search_->locator->BuildLocator ();
}

MeshDistance::~MeshDistance () = default;

double
MeshDistance::largestOf (const Eigen::Matrix3Xd& places) const
{
  vtkSMPThreadLocal<double> largest (0.0);
  vtkSMPThreadLocalObject<vtkGenericCell> cells;
  vtkSMPTools::For (0, places.cols (), [&] (vtkIdType begin, vtkIdType end) {
    double& squared = largest.Local ();
    for (vtkIdType i = begin; i < end; ++i) {
      std::array<double, 3> nearest{};
      vtkIdType triangle = 0;
      int part = 0;
      double distance = 0.0;
      search_->locator->FindClosestPoint (places.col (i).data (), nearest.data (), cells.Local (), triangle,
                                          part, distance);
      squared = std::max (squared, distance);
    }
  });
  double squared = 0.0;
  for (const double local : largest)
    squared = std::max (squared, local);
  return std::sqrt (squared);
}

Eigen::Matrix3Xd
placesOn (const TriangleMesh& mesh, double step)
{
  constexpr double MOST_PARTS = 64.0;
  std::vector<Eigen::Vector3d> places;
  for (const pcl::SimplicialComplex::Triangle& triangle : mesh.triangles) {
    const Eigen::Vector3d a = mesh.points.col (triangle[0]);
    const Eigen::Vector3d b = mesh.points.col (triangle[1]) - a;
    const Eigen::Vector3d c = mesh.points.col (triangle[2]) - a;
    const double longest = std::max ({b.norm (), c.norm (), (c - b).norm ()});
    const auto parts = static_cast<int> (std::clamp (std::ceil (longest / step), 2.0, MOST_PARTS));
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; i + j <= parts; ++j)
        places.emplace_back (a + (i * b + j * c) / parts);
  }
  Eigen::Matrix3Xd result (3, static_cast<Eigen::Index> (places.size ()));
  for (std::size_t i = 0; i < places.size (); ++i)
    result.col (static_cast<Eigen::Index> (i)) = places[i];
  return result;
}

double
meanEdge (const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (const pcl::SimplicialComplex::Triangle& triangle : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      sum += (mesh.points.col (triangle[i]) - mesh.points.col (triangle[(i + 1) % 3])).norm ();
  return mesh.triangles.empty () ? 0.0 : sum / (3.0 * static_cast<double> (mesh.triangles.size ()));
}

} // namespace pcl::manifold::apps
