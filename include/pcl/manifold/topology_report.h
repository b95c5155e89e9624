#pragma once

#include <pcl/manifold/export.h>
#include <pcl/manifold/simplicial_complex.h>
#include <pcl/types.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief Faces of any number of vertices, one row after the other: face f has the vertices
 * vertices[starts[f]] to vertices[starts[f + 1] - 1], in order around it.
 * \ingroup manifold */
struct FaceRows
{
  std::vector<std::size_t> starts = {0}; ///< one more than there are faces, never decreasing
  pcl::Indices vertices;                 ///< of one face after the other

  /** \brief The number of faces.
   * \return one less than there are starts */
  std::size_t size () const { return starts.size () - 1; }
};

/** \brief The topology of one component of a surface: faces that hang together through shared edges, however
 * many faces share them. Two components may touch at vertices.
 * \ingroup manifold */
struct SurfaceComponent
{
  std::size_t faces = 0;                 ///< without the degenerate ones
  std::size_t vertices = 0;              ///< a vertex where components touch counts in each of them
  std::size_t edges = 0;                 ///< boundary_edges + inner_edges + non_manifold_edges
  std::size_t boundary_edges = 0;        ///< edges of one face
  std::size_t inner_edges = 0;           ///< edges of two faces
  std::size_t non_manifold_edges = 0;    ///< edges of more than two faces
  std::size_t non_manifold_vertices = 0; ///< counts in every component that has the vertex
  /** Closed walks of boundary edges that turn at every vertex to the next boundary edge of the same fan of
   * faces. So two sheets that touch at a vertex keep a loop each, and two holes of one sheet that touch at a
   * vertex are one loop: separated there, the sheet has one hole. Where a fan ends in a non-manifold edge
   * there is no next edge; walks that end so at the same vertex are taken for one. */
  std::size_t boundary_loops = 0;
  std::int64_t euler_characteristic = 0; ///< vertices - edges + faces
  bool closed = false;                   ///< no boundary edge
  bool orientable = false; ///< neighbours across edges of exactly two faces can be made to agree
  /** Number of handles of an orientable component, (2 - chi - boundary_loops) / 2, or of crosscaps of a
   * non-orientable one, 2 - chi - boundary_loops. A vertex where several fans of faces touch enters chi once
   * a fan, as if they were separated there. -1 for a component with non-manifold edges, which has no genus.
   */
  int genus = -1;
};

/** \brief The topology of a set of faces. Counts are of the whole set: a vertex that several components
 * share counts once.
 * \ingroup manifold */
struct SurfaceTopology
{
  std::size_t faces = 0;              ///< without the degenerate ones
  std::size_t triangles = 0;          ///< faces of three edges
  std::size_t vertices = 0;           ///< of faces
  std::size_t edges = 0;              ///< boundary_edges + inner_edges + non_manifold_edges
  std::size_t boundary_edges = 0;     ///< edges of one face
  std::size_t inner_edges = 0;        ///< edges of two faces
  std::size_t non_manifold_edges = 0; ///< edges of more than two faces
  /** Vertices around which the faces form neither one disc nor one half-disc: the link is neither a cycle nor
   * a path. The ends of non-manifold edges are among them, and vertices where components touch. */
  std::size_t non_manifold_vertices = 0;
  std::size_t boundary_loops = 0;        ///< of all components
  std::int64_t euler_characteristic = 0; ///< vertices - edges + faces
  /** Faces of fewer than three vertices, with a negative vertex, or that pass an edge twice or from a vertex
   * to itself: left out of all else. A face may pass a vertex more than once, which then is no manifold one.
   */
  std::size_t degenerate_faces = 0;
  /** Faces with the same edges as another one before them: they take part in all else. */
  std::size_t duplicate_faces = 0;
  std::vector<SurfaceComponent> components; ///< most faces first; of equals the one with the first face

  /** \brief Whether every component has two sides.
   * \return true if so, for an empty surface as well */
  bool isOrientable () const
  {
    return std::all_of (components.begin (), components.end (),
                        [] (const SurfaceComponent& component) { return component.orientable; });
  }

  /** \brief Whether there is no boundary edge.
   * \return true if so, for an empty surface as well */
  bool isClosed () const { return boundary_edges == 0; }

  /** \brief Whether it is a manifold with or without boundary: edge-manifold, vertex-manifold, no face twice.
   * \return true if so */
  bool isManifold () const
  {
    return non_manifold_edges == 0 && non_manifold_vertices == 0 && duplicate_faces == 0;
  }
};

/** \brief The topology of one component of a set of edges: what hangs together through shared vertices.
 * \ingroup manifold */
struct CurveComponent
{
  std::size_t vertices = 0;           ///< of edges
  std::size_t edges = 0;              ///< without the degenerate ones
  std::size_t end_vertices = 0;       ///< vertices of one edge
  std::size_t branching_vertices = 0; ///< vertices of more than two edges
  bool closed = false;                ///< one cycle: every vertex has two edges
};

/** \brief The topology of a set of edges.
 * \ingroup manifold */
struct CurveTopology
{
  std::size_t edges = 0;                  ///< without the degenerate ones
  std::size_t vertices = 0;               ///< of edges
  std::size_t end_vertices = 0;           ///< vertices of one edge
  std::size_t branching_vertices = 0;     ///< vertices of more than two edges
  std::size_t degenerate_edges = 0;       ///< from a vertex to itself, or with a negative vertex: left out
  std::size_t duplicate_edges = 0;        ///< as another one before them: they take part in all else
  std::vector<CurveComponent> components; ///< most edges first; of equals the one with the first edge
};

/** \brief One component of a set of tetrahedra: what hangs together through shared triangles.
 * \ingroup manifold */
struct SolidComponent
{
  std::size_t tetrahedra = 0;         ///< without the degenerate ones
  std::size_t vertices = 0;           ///< a vertex where components touch counts in each of them
  std::size_t boundary_triangles = 0; ///< sides of one tetrahedron
};

/** \brief The topology of a set of tetrahedra.
 * \ingroup manifold */
struct SolidTopology
{
  std::size_t tetrahedra = 0;             ///< without the degenerate ones
  std::size_t vertices = 0;               ///< of tetrahedra
  std::size_t triangles = 0;              ///< distinct sides of tetrahedra
  std::size_t boundary_triangles = 0;     ///< sides of one tetrahedron
  std::size_t non_manifold_triangles = 0; ///< sides of more than two tetrahedra
  std::size_t degenerate_tetrahedra = 0;  ///< with a repeated or negative vertex: left out of all else
  std::vector<SolidComponent> components; ///< most tetrahedra first; of equals the one with the first
  SurfaceTopology boundary; ///< of boundaryTriangles (); its components are skins: a cavity adds one
};

} // namespace manifold

/** \brief What a complex, or a mesh of polygons and edges, is topologically. The surface is the topology of
 * the triangles or polygons alone and solid.boundary that of the boundary of the tetrahedra alone, because a
 * reconstruction takes its sheets and the skins of its solids for different things: where a sheet meets a
 * solid, its rim is a boundary.
 * \ingroup manifold */
struct TopologyReport
{
  std::size_t vertices = 0;          ///< distinct vertices of edges, triangles and tetrahedra together
  manifold::CurveTopology curve;     ///< of the edges
  manifold::SurfaceTopology surface; ///< of the triangles
  manifold::SolidTopology solid;     ///< of the tetrahedra
};

namespace manifold {

/** \brief Count and classify. Any set of simplices will do; time and memory are close to linear in their
 * number and do not depend on how large the indices are.
 * \param[in] complex need not be valid: see the counts of degenerate simplices
 * \return the report; it does not depend on the numbering of the vertices
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS pcl::TopologyReport analyze (const SimplicialComplex& complex);

/** \brief As analyze (complex), for faces of any number of vertices and the edges between them.
 * \param[in] faces rows as described in FaceRows
 * \param[in] edges those that are sides of a face, degenerate or not, tell nothing new; the curve of the
 * report is the topology of the others, which are in no face
 * \return without a solid
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS pcl::TopologyReport analyze (
  const FaceRows& faces, const std::vector<SimplicialComplex::Edge>& edges = {});

} // namespace manifold
} // namespace pcl
