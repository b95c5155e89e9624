#include <pcl/manifold/graph_faces.h>

#include "common/parallel.h"
#include "graph/faces/face_walks.h"
#include "graph/faces/mesh_components.h"
#include "graph/faces/orient_faces.h"
#include "graph/faces/shortest_cycles.h"
#include "graph/faces/tile_directions.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

constexpr int SHORTEST_FACE = 3;

// On a surface tiles are adjacent to six others or so. Where there are far more there is no surface, and the
// more of them are taken, the longer it takes to find out.
constexpr std::size_t MOST_ADJACENT = 64;

// How much may speak against turning what makes a surface two-sided. To begin with, three tenths of a bit.
constexpr std::int32_t FREE_TO_TURN = FOLLOW_BIT * 3 / 10;
constexpr std::int32_t FREE_IF_ONE_SIDED[] = {FOLLOW_BIT / 2,     FOLLOW_BIT * 3 / 4, FOLLOW_BIT,
                                              FOLLOW_BIT * 3 / 2, FOLLOW_BIT * 2,     FOLLOW_BIT * 5 / 2,
                                              FOLLOW_BIT * 3,     FOLLOW_BIT * 7 / 2, FOLLOW_BIT * 4};

// The graph of adjacent tiles, embedded in a surface.
LandmarkMesh
embed (const ContactRows& rows, const MeetingPoints& meetings, TileRotations rotations,
       std::int32_t free_to_turn, int maximum_length)
{
  rotations.breakIntoArcs (rows, free_to_turn);
  const std::vector<std::uint8_t> opposite = alignRotations (rows, meetings, rotations);
  RotationSystem system (rows, rotations, opposite);
  const FaceWalks walks (rows, meetings, maximum_length, system);
  return {walks.edges (), walks.faces (), walks.holes ()};
}

// Thin tubes come out one-sided where their rotations have been taken for the mirrored ones. So the one-sided
// components of a mesh are embedded once more with more freedom, and replaced by what is two-sided then and
// no less simple.
class OneSidedParts
{
public:
  OneSidedParts (LandmarkMesh& mesh, std::size_t landmarks)
    : mesh_ (mesh), landmarks_ (landmarks), parts_ (findComponents (mesh, landmarks))
  {}

  bool any () const
  {
    return std::any_of (parts_.components.begin (), parts_.components.end (),
                        [] (const MeshComponent& component) { return !component.orientable; });
  }

  // The contacts, those of one-sided components alone being adjacent.
  ContactRows only (ContactRows rows) const
  {
    for (std::size_t tile = 0; tile < rows.tiles (); ++tile)
      if (!isOneSided (static_cast<pcl::index_t> (tile)))
        std::fill (rows.adjacent.begin () + static_cast<std::ptrdiff_t> (rows.starts[tile]),
                   rows.adjacent.begin () + static_cast<std::ptrdiff_t> (rows.starts[tile + 1]), 0);
    return rows;
  }

  void replaceBy (LandmarkMesh other)
  {
    const MeshComponents others = findComponents (other, landmarks_);
    std::vector<std::uint8_t> replaced (landmarks_, 0);
    for (std::size_t landmark = 0; landmark < landmarks_; ++landmark)
      replaced[landmark] = isOneSided (static_cast<pcl::index_t> (landmark)) &&
                           isBetter (others.of (static_cast<pcl::index_t> (landmark)),
                                     parts_.of (static_cast<pcl::index_t> (landmark)));
    take (other.edges, mesh_.edges, replaced);
    take (other.faces, mesh_.faces, replaced);
    take (other.holes, mesh_.holes, replaced);
    std::sort (mesh_.edges.begin (), mesh_.edges.end ());
    parts_ = findComponents (mesh_, landmarks_);
  }

private:
  bool isOneSided (pcl::index_t landmark) const { return !parts_.of (landmark).orientable; }

  static std::int64_t eulerWithoutHoles (const MeshComponent& component)
  {
    return static_cast<std::int64_t> (component.vertices + component.faces + component.holes) -
           static_cast<std::int64_t> (component.edges);
  }

  static bool isBetter (const MeshComponent& a, const MeshComponent& b)
  {
    // A one-sided sheet must not become a two-sided one by a boundary more.
    return a.orientable && a.vertices == b.vertices && a.holes <= b.holes &&
           eulerWithoutHoles (a) >= eulerWithoutHoles (b);
  }

  // Moves what is replaced from one mesh to the other.
  template <typename Item>
  static void take (std::vector<Item>& from, std::vector<Item>& to, const std::vector<std::uint8_t>& replaced)
  {
    const auto isReplaced = [&replaced] (const Item& item) { return replaced[item.front ()] != 0; };
    to.erase (std::remove_if (to.begin (), to.end (), isReplaced), to.end ());
    std::copy_if (from.begin (), from.end (), std::back_inserter (to), isReplaced);
  }

  LandmarkMesh& mesh_;
  const std::size_t landmarks_;
  MeshComponents parts_;
};

// The recipe of FaceRule::ROTATION_SYSTEM, step by step.
LandmarkMesh
findByRotations (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& tiles,
                 std::size_t landmarks, const std::vector<TileContact>& contacts, int maximum_length)
{
  ContactRows rows (landmarks, contacts);
  rows.limitAdjacency (MOST_ADJACENT);
  const MeetingPoints meetings (graph, tiles, landmarks);
  const TileRotations rotations (rows, meetings);
  LandmarkMesh mesh = embed (rows, meetings, rotations, FREE_TO_TURN, maximum_length);
  OneSidedParts parts (mesh, landmarks);
  for (const std::int32_t free_to_turn : FREE_IF_ONE_SIDED)
    if (parts.any ())
      parts.replaceBy (embed (parts.only (rows), meetings, rotations, free_to_turn, maximum_length));
  return mesh;
}

} // namespace

LandmarkMesh
findFaces (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& tiles, std::size_t landmarks,
           const std::vector<TileContact>& contacts, FaceRule rule, int maximum_length, unsigned int threads)
{
  LandmarkMesh mesh;
  withThreads (threads, [&] {
    const int longest = std::max (maximum_length, SHORTEST_FACE);
    mesh = rule == FaceRule::SHORTEST_CYCLES ? shortestCycles (landmarks, contacts, longest)
                                             : findByRotations (graph, tiles, landmarks, contacts, longest);
    orientFaces (mesh);
  });
  return mesh;
}

} // namespace manifold
} // namespace pcl
