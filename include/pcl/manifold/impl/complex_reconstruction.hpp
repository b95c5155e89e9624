#pragma once

#include <pcl/conversions.h>
#include <pcl/manifold/complex_reconstruction.h>

#include <utility>

template <typename PointT>
template <typename Convert>
bool
pcl::manifold::ComplexReconstruction<PointT>::reconstructAnd (const Convert& convert)
{
  if (this->tree_ && !warned_of_search_) {
    warned_of_search_ = true;
    PCL_WARN ("[pcl::%s::setSearchMethod] no search is needed, the given one is not used\n", name_);
  }
  forget ();
  const bool done = this->run (name_, [&] (StageLog& log) {
    pcl::SimplicialComplex complex;
    const Status status = this->withInput ([&] { return compute (log, complex); });
    return status == Status::OK ? convert (complex) : status;
  });
  if (!done)
    forget ();
  return done;
}

template <typename PointT>
pcl::manifold::Status
pcl::manifold::ComplexReconstruction<PointT>::toMesh (const pcl::SimplicialComplex& complex,
                                                      pcl::PolygonMesh& mesh) const
{
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2 (*this->input_, cloud);
  if (!toPolygonMesh (complex, cloud, mesh))
    return Status::INTERNAL_ERROR;
  mesh.header = this->input_->header;
  return Status::OK;
}

template <typename PointT>
void
pcl::manifold::ComplexReconstruction<PointT>::reconstruct (pcl::SimplicialComplex& output)
{
  output.clear ();
  const bool done = reconstructAnd ([&] (pcl::SimplicialComplex& complex) {
    output = std::move (complex);
    return Status::OK;
  });
  if (!done)
    output.clear ();
}

// The base class reads the input cloud before it asks whether there is one, so its functions are not called.

template <typename PointT>
void
pcl::manifold::ComplexReconstruction<PointT>::reconstruct (pcl::PolygonMesh& output)
{
  output = pcl::PolygonMesh ();
  if (!reconstructAnd ([&] (const pcl::SimplicialComplex& complex) { return toMesh (complex, output); }))
    output = pcl::PolygonMesh ();
}

template <typename PointT>
void
pcl::manifold::ComplexReconstruction<PointT>::reconstruct (std::vector<pcl::Vertices>& polygons)
{
  pcl::PolygonMesh mesh;
  reconstruct (mesh);
  polygons = std::move (mesh.polygons);
}
