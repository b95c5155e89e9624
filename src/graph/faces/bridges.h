#pragma once

#include "graph/faces/rotation_system.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Answers whether the graph of a rotation system falls apart without an edge, while edges are removed. */
class Bridges
{
public:
  /** \param[in] system as it is now; must outlive this object */
  explicit Bridges (const RotationSystem& system);

  /** Of a dart that is there. Linear in what hangs at the smaller end of a bridge; elsewhere, in how far the
   * next way round is. */
  bool isBridge (RotationSystem::Dart dart);

private:
  void findBridges ();
  bool growRegion (int side, RotationSystem::Dart without);

  const RotationSystem& system_;
  std::vector<std::uint8_t> known_; ///< per dart: was it a bridge in the beginning? Then it still is one.

  // The search from both ends.
  std::vector<std::uint32_t> seen_by_; ///< per tile: 2 * search + side
  std::uint32_t search_ = 0;
  std::vector<pcl::index_t> region_[2];
  std::size_t grown_[2] = {0, 0};
};

} // namespace manifold
} // namespace pcl
