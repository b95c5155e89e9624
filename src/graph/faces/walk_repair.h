#pragma once

#include "graph/faces/bridges.h"
#include "graph/faces/rotation_system.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** Finds facial walks of a rotation system (see there) that no embedding in the surface sampled can have, and
 * repairs the rotations that they come from. */
class WalkRepair
{
public:
  using Dart = RotationSystem::Dart;
  using Corner = RotationSystem::Corner;
  using Walk = RotationSystem::Walk;

  /** \param[in,out] system all of these must outlive this object */
  WalkRepair (const ContactRows& rows, const MeetingPoints& meetings, RotationSystem& system);

  /** Mends the system where one walk shows that it is wrong, by turning rotations or removing an edge: the
   * surface has a handle or a crosscap less then. The walk falls into others, which are walks along the same
   * corners, as far as these still exist.
   * \param[in] is_hole of its walks only those parts that pass points are mended
   * \return false if there is nothing to mend */
  bool mend (const Walk& walk, bool is_hole);

  /** A dart of every edge that the walk passes twice, in the order of the walk. */
  const std::vector<Dart>& edgesPassedTwice (const Walk& walk);

private:
  using Candidate = std::pair<std::int32_t, Dart>; ///< boundary points and an edge

  bool turnCheapest (const Walk& walk, bool is_hole);
  std::vector<Candidate> crossingEdges (bool is_hole) const;
  bool removeWeakest (const std::vector<Candidate>& candidates, std::size_t most, std::int32_t strength);
  std::int32_t weight (Dart a, Dart b) const;
  std::int32_t meetingPoints (Dart a, Dart b) const;
  std::int32_t costOfTurning (Corner first, Corner second) const;
  int closedCornersAt (Dart dart) const;

  const ContactRows& rows_;
  const MeetingPoints& meetings_;
  RotationSystem& system_;
  Bridges bridges_;
  std::vector<std::uint32_t> passed_in_; ///< per edge, by the smaller of its darts: the last walk
  std::uint32_t walk_ = 0;
  std::vector<Dart> twice_;
  std::vector<std::uint32_t> by_tile_;
};

} // namespace manifold
} // namespace pcl
