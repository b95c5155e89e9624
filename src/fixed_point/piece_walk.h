#pragma once

#include "extraction/facet_set.h"
#include "fixed_point/dual_edge.h"
#include "fixed_point/edge_ring.h"
#include "fixed_point/key_set.h"

#include <pcl/manifold/delaunay_complex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Finds the Delaunay triangles whose dual Voronoi edges meet a flat piece, by a walk through the Delaunay
 * triangulation and the Voronoi diagram in synchrony: first along the rim of the piece from Voronoi cell to
 * Voronoi cell, then inwards from the Voronoi faces that the rim crosses. From a face on it goes over the
 * Voronoi edges around the face that meet the piece to the faces beyond these.
 *
 * No other Voronoi edge can meet the piece: what the faces cut out of it would have a part within the piece
 * that a curve in a single Voronoi cell goes around, but cells are convex.
 *
 * Keeps its scratch memory between calls; one object a thread. */
class PieceWalk
{
public:
  /** \param[in] complex of affine dimension 2 or 3 */
  explicit PieceWalk (const DelaunayComplex& complex) : complex_ (complex), sides_ (REMEMBERED_SIDES) {}

  /** The triangles, each as the facet of its cell with the smaller number, in no particular order; valid
   * until the next call.
   * \param[in] start any sample; the nearer to the first corner of the piece, the shorter the walk */
  const std::vector<Facet>& find (const Piece& piece, std::int32_t start);

  /** The children of a Delaunay triangle in the restriction DAG: as above for the triangle itself as the
   * piece. */
  const std::vector<Facet>& find (const Facet& facet);

private:
  /** A Voronoi face, as the Delaunay edge that it is dual to and a cell at this. */
  struct Face
  {
    std::int32_t p;
    std::int32_t q;
    std::int32_t cell;
  };

  /** The Voronoi faces that a Delaunay edge crosses: its own dual one alone where it is Gabriel. */
  struct Side
  {
    std::uint64_t key = NO_KEY;
    bool gabriel = false;
    std::vector<Face> faces;
  };

  static constexpr std::uint64_t NO_KEY = ~std::uint64_t (0);

  /** A power of two. Two triangles at an edge are most often asked for soon after each other. */
  static constexpr std::size_t REMEMBERED_SIDES = 1024;

  static std::uint64_t keyOf (std::int32_t p, std::int32_t q)
  {
    return static_cast<std::uint64_t> (std::min (p, q)) << 32 | static_cast<std::uint64_t> (std::max (p, q));
  }

  Eigen::Vector3d point (std::int32_t sample) const { return complex_.samples->points.col (sample); }

  void begin (const Piece& piece);

  std::int32_t nearestSample (const Eigen::Vector3d& point, std::int32_t start) const;

  /** Adds the faces that a segment crosses; where it ends on faces, these, too.
   * \param[in] start a sample whose Voronoi cell has the start of the segment in it
   * \param[in] end the sample that the segment ends at, or -1 if it is none
   * \param[in,out] faces that they are added to
   * \return a sample whose cell has the end of the segment in it */
  std::int32_t walkSegment (const Eigen::Vector3d& from, const Eigen::Vector3d& to, std::int32_t start,
                            std::int32_t end, std::vector<Face>& faces);

  /** The faces that a Delaunay edge crosses, valid until the next call. */
  const Side& crossedBy (const Face& edge);

  /** Whether the segment from p to q meets no Voronoi cells but those of p and q, and its middle is inside of
   * the face. */
  bool isGabriel (const Face& face);

  std::int32_t cellAt (std::int32_t p, std::int32_t q) const;

  void push (const Face& face);

  void spread ();

  /** Finds the Voronoi edges around a face that meet the piece. */
  void visit (const Face& face);

  /** Whether the piece meets the Voronoi edge of a face and the sample of an entry of the ring; `behind` and
   * `ahead` are the entries beside this. */
  bool meetsExactly (const Face& face, std::size_t behind, std::size_t third, std::size_t ahead) const;

  const DelaunayComplex& complex_;
  Piece piece_;
  KeySet faces_;
  std::vector<Face> pending_;
  std::vector<Facet> found_;
  std::vector<std::int32_t> touched_;
  std::vector<Side> sides_;
  std::vector<Face> crossed_;
  EdgeRing ring_;
  std::vector<FaceFilter::Excesses> excesses_;
};

} // namespace manifold
} // namespace pcl
