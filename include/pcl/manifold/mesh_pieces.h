#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/manifold/export.h>
#include <pcl/manifold/fixed_point_complex.h>
#include <pcl/manifold/status.h>

namespace pcl {
namespace manifold {

/** \brief The faces of a mesh as the pieces of restrictedDelaunay (), polygons of more than three vertices
 * cut from their first vertex on. Polygons of fewer vertices, and points of no polygon, are left out.
 * \param[in] mesh x, y and z may be floats or doubles
 * \param[out] pieces in the coordinates of the mesh; empty unless the answer is Status::OK
 * \return PARAMETER_OUT_OF_RANGE for a mesh without faces, a polygon that names no point, a vertex that is
 * not finite, or points without x, y and z. Does not throw.
 * \ingroup manifold */
PCL_MANIFOLD_DELAUNAY_EXPORTS Status meshPieces (const pcl::PolygonMesh& mesh, FlatPieces& pieces) noexcept;

} // namespace manifold
} // namespace pcl
