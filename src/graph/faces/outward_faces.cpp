#include "graph/faces/outward_faces.h"

#include "complex/disjoint_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

using Walk = std::vector<pcl::index_t>;
using EdgeOfFace = std::pair<LandmarkMesh::Edge, std::uint32_t>;

LandmarkMesh::Edge
edgeAt (const Walk& walk, std::size_t i)
{
  const auto [low, high] = std::minmax (walk[i], walk[(i + 1) % walk.size ()]);
  return {low, high};
}

/** Every edge of every face, sorted. */
std::vector<EdgeOfFace>
edgesOfFaces (const std::vector<Walk>& faces)
{
  std::vector<EdgeOfFace> edges;
  for (std::size_t f = 0; f < faces.size (); ++f)
    for (std::size_t i = 0; i < faces[f].size (); ++i)
      edges.emplace_back (edgeAt (faces[f], i), static_cast<std::uint32_t> (f));
  std::sort (edges.begin (), edges.end ());
  return edges;
}

/** The part of the mesh that each face is of.
 * \return how many parts there are */
std::uint32_t
findParts (std::size_t faces, const std::vector<EdgeOfFace>& edges, std::vector<std::uint32_t>& part_of)
{
  DisjointSets parts (faces);
  for (std::size_t i = 1; i < edges.size (); ++i)
    if (edges[i].first == edges[i - 1].first)
      parts.join (edges[i].second, edges[i - 1].second);
  return parts.number (part_of);
}

/** Six times the volume of the cone over a face. */
double
coneVolume (const Walk& face, const Eigen::Matrix3Xd& points, const Eigen::Vector3d& apex)
{
  double volume = 0.0;
  const Eigen::Vector3d a = points.col (face[0]) - apex;
  for (std::size_t i = 2; i < face.size (); ++i) {
    const Eigen::Vector3d b = points.col (face[i - 1]) - apex;
    const Eigen::Vector3d c = points.col (face[i]) - apex;
    volume += a.dot (b.cross (c));
  }
  return volume;
}

/** Per part whether it must be turned. */
std::vector<std::uint8_t>
inwardParts (const std::vector<Walk>& faces, const std::vector<std::uint32_t>& part_of, std::uint32_t parts,
             const Eigen::Matrix3Xd& points)
{
  Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero (3, parts);
  Eigen::ArrayXd corners = Eigen::ArrayXd::Zero (parts);
  for (std::size_t f = 0; f < faces.size (); ++f)
    for (const pcl::index_t vertex : faces[f]) {
      sums.col (part_of[f]) += points.col (vertex);
      corners[part_of[f]] += 1.0;
    }
  std::vector<double> volumes (parts, 0.0);
  for (std::size_t f = 0; f < faces.size (); ++f)
    volumes[part_of[f]] += coneVolume (faces[f], points, sums.col (part_of[f]) / corners[part_of[f]]);
  std::vector<std::uint8_t> inward (parts);
  std::transform (volumes.begin (), volumes.end (), inward.begin (),
                  [] (double volume) { return volume < 0.0; });
  return inward;
}

/** The other way round, from the same landmark on. */
void
reverse (Walk& walk)
{
  std::reverse (walk.begin () + 1, walk.end ());
}

} // namespace

void
turnOutward (LandmarkMesh& mesh, const Eigen::Matrix3Xd& points)
{
  const std::vector<EdgeOfFace> edges = edgesOfFaces (mesh.faces);
  std::vector<std::uint32_t> part_of;
  const std::uint32_t parts = findParts (mesh.faces.size (), edges, part_of);
  const std::vector<std::uint8_t> inward = inwardParts (mesh.faces, part_of, parts, points);
  for (Walk& hole : mesh.holes) {
    const EdgeOfFace first = {edgeAt (hole, 0), 0};
    const auto found = std::lower_bound (edges.begin (), edges.end (), first);
    if (found != edges.end () && found->first == first.first && inward[part_of[found->second]] != 0)
      reverse (hole);
  }
  for (std::size_t f = 0; f < mesh.faces.size (); ++f)
    if (inward[part_of[f]] != 0)
      reverse (mesh.faces[f]);
}

} // namespace manifold
} // namespace pcl
