#include <generate/point_grid.h>

#include <cmath>
#include <utility>

namespace generate {

// Cubes of twice the reach: a ball of that radius meets at most two of them along each axis.
PointGrid::PointGrid (double reach) : inverse_size_ (0.5 / reach), table_ (1024, {0, 0, 0, -1}) {}

std::size_t
PointGrid::slotOf (std::int64_t x, std::int64_t y, std::int64_t z) const
{
  std::uint64_t hash = static_cast<std::uint64_t> (x) * 0x9E3779B97F4A7C15ULL;
  hash = (hash ^ (hash >> 29)) + static_cast<std::uint64_t> (y) * 0xBF58476D1CE4E5B9ULL;
  hash = (hash ^ (hash >> 31)) + static_cast<std::uint64_t> (z) * 0x94D049BB133111EBULL;
  hash ^= hash >> 30;
  const std::size_t mask = table_.size () - 1;
  std::size_t slot = static_cast<std::size_t> (hash) & mask;
  while (table_[slot].first >= 0 && (table_[slot].x != x || table_[slot].y != y || table_[slot].z != z))
    slot = (slot + 1) & mask;
  return slot;
}

void
PointGrid::grow ()
{
  std::vector<Cell> old (2 * table_.size (), {0, 0, 0, -1});
  old.swap (table_);
  for (const Cell& cell : old)
    if (cell.first >= 0)
      table_[slotOf (cell.x, cell.y, cell.z)] = cell;
}

void
PointGrid::insert (const Eigen::Vector3d& point)
{
  const auto x = static_cast<std::int64_t> (std::floor (point.x () * inverse_size_));
  const auto y = static_cast<std::int64_t> (std::floor (point.y () * inverse_size_));
  const auto z = static_cast<std::int64_t> (std::floor (point.z () * inverse_size_));
  std::size_t slot = slotOf (x, y, z);
  if (table_[slot].first < 0) {
    if (2 * (used_ + 1) > table_.size ()) {
      grow ();
      slot = slotOf (x, y, z);
    }
    table_[slot] = {x, y, z, -1};
    ++used_;
  }
  entries_.push_back ({point, table_[slot].first});
  table_[slot].first = static_cast<std::int32_t> (entries_.size () - 1);
}

template <typename Visit>
bool
PointGrid::visitNear (const Eigen::Vector3d& place, double radius, Visit visit) const
{
  const Eigen::Vector3d low = ((place.array () - radius) * inverse_size_).floor ();
  const Eigen::Vector3d high = ((place.array () + radius) * inverse_size_).floor ();
  for (auto x = static_cast<std::int64_t> (low.x ()); x <= static_cast<std::int64_t> (high.x ()); ++x)
    for (auto y = static_cast<std::int64_t> (low.y ()); y <= static_cast<std::int64_t> (high.y ()); ++y)
      for (auto z = static_cast<std::int64_t> (low.z ()); z <= static_cast<std::int64_t> (high.z ()); ++z)
        for (std::int32_t i = table_[slotOf (x, y, z)].first; i >= 0;
             i = entries_[static_cast<std::size_t> (i)].next)
          if (visit (entries_[static_cast<std::size_t> (i)].point))
            return true;
  return false;
}

bool
PointGrid::anyWithin (const Eigen::Vector3d& place, double radius) const
{
  return visitNear (place, radius, [&place, squared = radius * radius] (const Eigen::Vector3d& point) {
    return (point - place).squaredNorm () < squared;
  });
}

void
PointGrid::collectWithin (const Eigen::Vector3d& place, double radius,
                          std::vector<Eigen::Vector3d>& found) const
{
  found.clear ();
  visitNear (place, radius, [&place, &found, squared = radius * radius] (const Eigen::Vector3d& point) {
    if ((point - place).squaredNorm () < squared)
      found.push_back (point);
    return false;
  });
}

} // namespace generate
