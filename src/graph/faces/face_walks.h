#pragma once

#include "graph/faces/long_faces.h"
#include "graph/faces/rotation_system.h"

#include <pcl/manifold/graph_faces.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Makes the walks of a rotation system faces of a surface, and finds out which of them are.
 *
 * A face should pass no tile twice. Where a walk passes one twice in opposite directions, some order around a
 * tile is wrong that could as well have been the other way round: turning it there makes two walks of the
 * walk. Where it passes an edge twice, this one has crossed another edge: removing the weakest makes two of
 * it as well. Each of both brings the surface one step nearer to the simplest one. Edges
 * that a walk passes twice in the end are no part of a surface: they are wires, bridges between its parts and
 * edges of curves.
 *
 * A walk goes along the boundary of a hole instead of around a face if points meet at hardly any of its
 * corners, or if it is longer than faces may be and cannot be cut into shorter ones. Short walks, of three
 * and four edges, always are faces: there are gaps of that size in any sample. */
class FaceWalks
{
public:
  using Dart = RotationSystem::Dart;
  using Walk = RotationSystem::Walk;
  using Tiles = std::vector<pcl::index_t>;
  using Edge = LandmarkMesh::Edge;

  /** \param[in,out] system loses the edges that crossed others and the wires
   * \param[in] maximum_length of a face */
  FaceWalks (const ContactRows& rows, const MeetingPoints& meetings, int maximum_length,
             RotationSystem& system);

  /** The tiles that faces go around. */
  const std::vector<Tiles>& faces () const { return faces_; }

  const std::vector<Tiles>& holes () const { return holes_; }

  /** The edges of the mesh in ascending order: those of the system, the wires, and those that cut long faces.
   */
  std::vector<Edge> edges () const;

private:
  void repair (const MeetingPoints& meetings);
  bool trace (RotationSystem::Corner start, Walk& walk);
  bool isHole (const Walk& walk) const;
  bool detach (const std::vector<Dart>& darts);
  void dropLooseHoles ();

  const ContactRows& rows_;
  RotationSystem& system_;
  const std::size_t maximum_length_;
  std::vector<std::uint8_t> traced_; ///< per corner
  std::vector<Edge> wires_;
  LongFaces long_faces_;
  std::vector<Tiles> faces_;
  std::vector<Tiles> holes_;
};

} // namespace manifold
} // namespace pcl
