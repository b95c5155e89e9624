#include <pcl/manifold/detail/guarded.h>
#include <pcl/manifold/reconstruct_graph.h>

#include "graph/faces/crowded_tiles.h"
#include "graph/faces/outward_faces.h"

#include <cassert>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

constexpr pcl::index_t FEWEST_VERTICES = 3;
constexpr int SHORTEST_FACE = 3;

// So often they are added at most.
constexpr int MOST_REFINEMENTS = 2;

bool
isRule (AdjacencyRule rule)
{
  return rule == AdjacencyRule::BOUNDARY_POINTS || rule == AdjacencyRule::LINKING_EDGES ||
         rule == AdjacencyRule::CLEAR_PATH;
}

bool
isRule (FaceRule rule)
{
  return rule == FaceRule::SHORTEST_CYCLES || rule == FaceRule::ROTATION_SYSTEM;
}

Status
check (const NeighborhoodGraph& graph, const Eigen::Ref<const Eigen::MatrixXd>& points,
       const GraphParameters& parameters)
{
  if (parameters.hops < 1 || parameters.adjacency_threshold < 0 ||
      parameters.maximum_face_length < SHORTEST_FACE || !isRule (parameters.adjacency_rule) ||
      !isRule (parameters.face_rule) || (points.cols () != 0 && points.cols () != graph.size ()))
    return Status::PARAMETER_OUT_OF_RANGE;
  return graph.size () < FEWEST_VERTICES ? Status::TOO_FEW_POINTS : Status::OK;
}

/** The coordinates of the landmarks, without columns where they are not known. */
Eigen::MatrixXd
pointsOf (const std::vector<pcl::index_t>& landmarks, const Eigen::Ref<const Eigen::MatrixXd>& points)
{
  if (points.cols () == 0)
    return {};
  Eigen::MatrixXd result (points.rows (), static_cast<Eigen::Index> (landmarks.size ()));
  for (std::size_t i = 0; i < landmarks.size (); ++i)
    result.col (static_cast<Eigen::Index> (i)) = points.col (landmarks[i]);
  return result.allFinite () ? result : Eigen::MatrixXd ();
}

/** The tiles of the landmarks, and which of them touch.
 * \return false if the user cancelled */
bool
makeTiles (const NeighborhoodGraph& graph, const GraphParameters& parameters, float fraction, StageLog& log,
           GraphMesh& result)
{
  if (!log.begin ("graph Voronoi diagram", fraction))
    return false;
  result.tiles = graphVoronoiDiagram (graph, result.landmarks, parameters.threads);
  if (!log.begin ("adjacency", fraction + 0.02f))
    return false;
  result.contacts = tileContacts (graph, result.landmarks, result.tiles, parameters.adjacency_rule,
                                  parameters.adjacency_threshold, parameters.threads);
  return true;
}

/** Adds landmarks, and makes the tiles again where there are any.
 * \return false if the user cancelled */
bool
refine (const NeighborhoodGraph& graph, const GraphParameters& parameters,
        const std::vector<pcl::index_t>& crowded, float fraction, StageLog& log, GraphMesh& result)
{
  if (!log.begin ("refinement", fraction))
    return false;
  std::vector<pcl::index_t> refined =
    refineLandmarks (graph, parameters.hops, parameters.seed, result.landmarks, result.tiles, result.contacts,
                     crowded, parameters.threads);
  if (refined.size () == result.landmarks.size ())
    return true;
  result.landmarks = std::move (refined);
  return makeTiles (graph, parameters, fraction + 0.01f, log, result);
}

/** The recipe, step by step. */
Status
reconstruct (const NeighborhoodGraph& graph, const Eigen::Ref<const Eigen::MatrixXd>& points,
             const GraphParameters& parameters, StageLog& log, GraphMesh& result)
{
  if (!log.begin ("stable set", 0.6f))
    return Status::CANCELLED;
  result.landmarks = maximalStableSet (graph, parameters.hops, parameters.seed, parameters.threads);
  if (!makeTiles (graph, parameters, 0.7f, log, result))
    return Status::CANCELLED;

  // Landmarks are added where tiles are no disks, and then where that was not enough.
  std::vector<pcl::index_t> crowded;
  for (int round = 0; round < MOST_REFINEMENTS; ++round) {
    const float fraction = 0.75f + 0.07f * static_cast<float> (round);
    const std::size_t before = result.landmarks.size ();
    if (parameters.refine && !refine (graph, parameters, crowded, fraction, log, result))
      return Status::CANCELLED;
    if (round > 0 && result.landmarks.size () == before)
      break;
    if (!log.begin ("faces", fraction + 0.04f))
      return Status::CANCELLED;
    result.mesh = findFaces (graph, result.tiles, result.landmarks.size (), result.contacts,
                             parameters.face_rule, parameters.maximum_face_length, parameters.threads);
    if (parameters.refine)
      crowded = crowdedTiles (result.mesh);
    if (crowded.empty ())
      break;
  }
  const Eigen::MatrixXd landmark_points = pointsOf (result.landmarks, points);
  constexpr Eigen::Index SPACE = 3;
  if (landmark_points.rows () == SPACE)
    turnOutward (result.mesh, landmark_points);
  result.report = analyze (result.mesh);

  if (!log.begin ("triangulation", 0.98f))
    return Status::CANCELLED;
  if (parameters.triangulate)
    result.triangles = triangulateFaces (result.mesh, landmark_points);
  if (!log.begin ("", 1.0f))
    return Status::CANCELLED;
  return result.mesh.faces.empty () ? Status::DIMENSION_TOO_LOW : Status::OK;
}

/** A polygon over the points of the cloud. */
template <typename Face>
pcl::Vertices
polygonOf (const Face& face, const GraphMesh& mesh, const pcl::Indices& input_index)
{
  pcl::Vertices polygon;
  for (const pcl::index_t landmark : face)
    polygon.vertices.push_back (input_index[mesh.landmarks[landmark]]);
  return polygon;
}

} // namespace

Status
reconstructGraph (const NeighborhoodGraph& graph, const Eigen::Ref<const Eigen::MatrixXd>& points,
                  const GraphParameters& parameters, StageLog& log, GraphMesh& result) noexcept
{
  assert (isProper (graph));
  const Status status = guarded ([&] {
    result = GraphMesh ();
    const Status answer = check (graph, points, parameters);
    return answer == Status::OK ? reconstruct (graph, points, parameters, log, result) : answer;
  });
  if (status != Status::OK && status != Status::DIMENSION_TOO_LOW)
    result = GraphMesh ();
  return status;
}

std::vector<pcl::Vertices>
polygonsOf (const GraphMesh& mesh, const pcl::Indices& input_index)
{
  std::vector<pcl::Vertices> polygons;
  for (const auto& triangle : mesh.triangles)
    polygons.push_back (polygonOf (triangle, mesh, input_index));
  if (mesh.triangles.empty ())
    for (const auto& face : mesh.mesh.faces)
      polygons.push_back (polygonOf (face, mesh, input_index));
  return polygons;
}

} // namespace manifold
} // namespace pcl
