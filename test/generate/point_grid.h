#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace generate {

/** \brief Growing set of points that quickly finds those near a given place. A hashed grid of cubes; memory
 * is linear in the number of points. */
class PointGrid
{
public:
  /** \param[in] reach the radius that will be asked for most, positive */
  explicit PointGrid (double reach);

  void insert (const Eigen::Vector3d& point);

  /** \brief Is there a point nearer to \a place than \a radius? */
  bool anyWithin (const Eigen::Vector3d& place, double radius) const;

  /** \brief The points nearer to \a place than \a radius, in place of what \a found held. */
  void collectWithin (const Eigen::Vector3d& place, double radius, std::vector<Eigen::Vector3d>& found) const;

private:
  struct Cell
  {
    std::int64_t x, y, z;
    std::int32_t first; ///< head of the list of its points, -1 where the slot is free
  };

  struct Entry
  {
    Eigen::Vector3d point;
    std::int32_t next;
  };

  std::size_t slotOf (std::int64_t x, std::int64_t y, std::int64_t z) const;

  void grow ();

  /** Calls visit (point) for the points in all cubes that a ball meets, until it returns true; returns
   * whether it did. */
  template <typename Visit>
  bool visitNear (const Eigen::Vector3d& place, double radius, Visit visit) const;

  double inverse_size_;
  std::size_t used_ = 0;
  std::vector<Cell> table_; ///< open addressing, its size a power of two
  std::vector<Entry> entries_;
};

} // namespace generate
