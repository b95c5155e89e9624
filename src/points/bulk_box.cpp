#include <pcl/manifold/bulk_box.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl {
namespace manifold {

namespace {

// So many times the extent of the middle half, doubled, from the median on, and a point is a stray.
constexpr double REACH = 4.0;

// So many points tell the quartiles well enough.
constexpr Eigen::Index ENOUGH = 2048;

// The same for equal points, and so for both zeros.
std::uint64_t
hashOf (const Eigen::Vector3d& point)
{
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double coordinate = point[axis] + 0.0;
    std::uint64_t bits = 0;
    std::memcpy (&bits, &coordinate, sizeof (bits));
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32;
  }
  return hash * 0xff51afd7ed558ccdULL >> 32;
}

bool
isBefore (const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::lexicographical_compare (a.data (), a.data () + 3, b.data (), b.data () + 3);
}

// A share of the distinct finite points that does not depend on their order: those whose hash has zeros in
// the bits of the mask.
std::vector<Eigen::Vector3d>
chosenPoints (const Eigen::Ref<const Eigen::Matrix3Xd>& points, std::uint64_t mask)
{
  std::vector<Eigen::Vector3d> chosen;
  for (Eigen::Index i = 0; i < points.cols (); ++i)
    if (const Eigen::Vector3d point = points.col (i); (hashOf (point) & mask) == 0 && point.allFinite ())
      chosen.push_back (point);
  std::sort (chosen.begin (), chosen.end (), isBefore);
  chosen.erase (std::unique (chosen.begin (), chosen.end ()), chosen.end ());
  return chosen;
}

std::vector<Eigen::Vector3d>
fewPoints (const Eigen::Ref<const Eigen::Matrix3Xd>& points)
{
  std::uint64_t mask = 0;
  for (Eigen::Index share = points.cols (); share > 2 * ENOUGH; share /= 2)
    mask = 2 * mask + 1;
  std::vector<Eigen::Vector3d> chosen = chosenPoints (points, mask);
  // Most points may be copies of a few.
  for (; mask != 0 && chosen.size () < ENOUGH / 8; chosen = chosenPoints (points, mask))
    mask /= 16;
  return chosen;
}

} // namespace

Eigen::AlignedBox3d
bulkBox (const Eigen::Ref<const Eigen::Matrix3Xd>& points)
{
  Eigen::AlignedBox3d box;
  for (Eigen::Index i = 0; i < points.cols (); ++i)
    if (points.col (i).allFinite ())
      box.extend (points.col (i));
  if (box.isEmpty ())
    return box;

  const std::vector<Eigen::Vector3d> chosen = fewPoints (points);
  Eigen::Vector3d middle;
  double extent = 0.0;
  std::vector<double> coordinates (chosen.size ());
  for (int axis = 0; axis < 3; ++axis) {
    std::transform (chosen.begin (), chosen.end (), coordinates.begin (),
                    [axis] (const Eigen::Vector3d& point) { return point[axis]; });
    std::sort (coordinates.begin (), coordinates.end ());
    const std::size_t quarter = (coordinates.size () - 1) / 4;
    middle[axis] = coordinates[coordinates.size () / 2];
    extent = std::max (extent, coordinates[coordinates.size () - 1 - quarter] - coordinates[quarter]);
  }
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant (2.0 * REACH * extent);
  if (extent > 0.0 && reach.allFinite ())
    box = box.intersection (Eigen::AlignedBox3d (middle - reach, middle + reach));
  return box;
}

} // namespace manifold
} // namespace pcl
