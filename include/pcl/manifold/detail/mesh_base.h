#pragma once

#include <pcl/impl/pcl_base.hpp> // for point types that PCL does not instantiate itself
#include <pcl/point_types.h>
#include <pcl/surface/reconstruction.h>

#include <boost/preprocessor/seq/for_each.hpp>

#include <type_traits>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief Whether PCL's libraries hold the code of its search trees for a point type. */
template <typename PointT>
struct HasSearchInstances : std::false_type
{};

#define PCL_MANIFOLD_HAS_SEARCH_INSTANCES(r, data, PointType)                                                \
  template <>                                                                                                \
  struct HasSearchInstances<PointType> : std::true_type                                                      \
  {};
BOOST_PP_SEQ_FOR_EACH (PCL_MANIFOLD_HAS_SEARCH_INSTANCES, _, PCL_XYZ_POINT_TYPES)
#undef PCL_MANIFOLD_HAS_SEARCH_INSTANCES

/** \brief Stands in for pcl::MeshConstruction where that needs code that PCL does not have: it makes search
 * trees of its own, for every point type, and two of those are compiled for PCL's own types with x, y and z
 * only. */
template <typename PointT>
class SearchlessMeshConstruction : public pcl::PCLSurfaceBase<PointT>
{
public:
  using pcl::PCLSurfaceBase<PointT>::reconstruct;

  virtual void reconstruct (std::vector<pcl::Vertices>& polygons) = 0;

protected:
  virtual void performReconstruction (pcl::PolygonMesh& output) = 0;

  virtual void performReconstruction (std::vector<pcl::Vertices>& polygons) = 0;

  bool check_tree_ = false;
};

/** \brief The base class of a mesh construction: pcl::MeshConstruction for PCL's own point types with x, y
 * and z; for all others, histograms and types of the user's own, its base pcl::PCLSurfaceBase with the same
 * functions, so that they need no PCL_NO_PRECOMPILE. */
template <typename PointT>
using MeshBase = std::conditional_t<HasSearchInstances<PointT>::value, pcl::MeshConstruction<PointT>,
                                    SearchlessMeshConstruction<PointT>>;

} // namespace manifold
} // namespace pcl
