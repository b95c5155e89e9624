#include "mesh_distance.h"

#include <algorithm>
#include <cmath>

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPThreadLocalObject.h>
#include <vtkSMPTools.h>
#include <vtkStaticCellLocator.h>

namespace pcl::manifold::apps {

double
largestDistance (const Eigen::Matrix3Xd& places, const TriangleMesh& mesh)
{
  // Every triangle with corners of its own: points of none may be anything.
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble ();
  const vtkNew<vtkCellArray> triangles;
  for (const pcl::SimplicialComplex::Triangle& triangle : mesh.triangles) {
    triangles->InsertNextCell (3);
    for (const pcl::index_t vertex : triangle)
      triangles->InsertCellPoint (points->InsertNextPoint (mesh.points.col (vertex).data ()));
  }
  const vtkNew<vtkPolyData> data;
  data->SetPoints (points);
  data->SetPolys (triangles);
  const vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet (data);
  locator->BuildLocator ();
  Eigen::VectorXd squared = Eigen::VectorXd::Zero (places.cols ());
  vtkSMPThreadLocalObject<vtkGenericCell> cells;
  vtkSMPTools::For (0, places.cols (), [&] (vtkIdType begin, vtkIdType end) {
    Eigen::Vector3d nearest;
    vtkIdType triangle = 0;
    int part = 0;
    for (vtkIdType i = begin; i < end; ++i)
      locator->FindClosestPoint (places.col (i).data (), nearest.data (), cells.Local (), triangle, part,
                                 squared[i]);
  });
  return squared.size () == 0 ? 0.0 : std::sqrt (squared.maxCoeff ());
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
