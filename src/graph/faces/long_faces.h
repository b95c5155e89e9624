#pragma once

#include "graph/landmarks/contact_rows.h"

#include <pcl/manifold/graph_faces.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Cuts faces that are too long between tiles that touch, though too little to be adjacent. Any edge from one
 * tile of a face to another leaves the surface as it is. */
class LongFaces
{
public:
  using Tiles = std::vector<pcl::index_t>;

  /** \param[in] rows must outlive this object
   * \param[in] maximum_length of a face */
  LongFaces (const ContactRows& rows, std::size_t maximum_length);

  /** Adds the parts of a face to the faces, and those that cannot be cut to the holes. */
  void cut (Tiles face, std::vector<Tiles>& faces, std::vector<Tiles>& holes);

  /** The edges that were added. */
  const std::vector<LandmarkMesh::Edge>& chords () const { return chords_; }

private:
  std::size_t strongestChord (const Tiles& face);

  const ContactRows& rows_;
  const std::size_t maximum_length_;
  std::vector<LandmarkMesh::Edge> chords_;
  std::vector<std::uint8_t> is_chord_; ///< per contact
  std::vector<std::size_t> position_;  ///< per tile the first one in the face that is cut
};

} // namespace manifold
} // namespace pcl
