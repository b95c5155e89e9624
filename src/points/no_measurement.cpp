#include "points/no_measurement.h"

#include "points/spacing.h"

#include <algorithm>
#include <cstddef>

namespace pcl {
namespace manifold {

namespace {

// What makes a place one of no measurement: so many points, more than so many times as many as at any other
// place, and farther than so many median spacings from all others.
struct Rule
{
  std::int32_t fewest;
  std::int64_t times;
  double spacings;
};

constexpr Rule AT_ZERO = {2, 4, 5.0};
constexpr Rule ELSEWHERE = {16, 16, 16.0};

// So many points may be nearer: dust, or what the sensor sees of its own mount. A ring of a lathe has more.
constexpr std::size_t NEARER = 7;

bool
isApart (const Eigen::Matrix3Xd& points, std::int32_t place, double spacings)
{
  std::vector<double> distances;
  for (Eigen::Index i = 0; i < points.cols (); ++i)
    if (i != place)
      distances.push_back ((points.col (i) - points.col (place)).norm ());
  const auto first =
    distances.begin () + static_cast<std::ptrdiff_t> (std::min (NEARER, distances.size () - 1));
  std::nth_element (distances.begin (), first, distances.end ());
  return *first > spacings * medianSpacing (points);
}

} // namespace

std::int32_t
findNoMeasurement (const Eigen::Matrix3Xd& points, const std::vector<std::int32_t>& counts,
                   const Eigen::Vector3d& zero)
{
  if (counts.size () < 2)
    return -1;
  const auto most = std::max_element (counts.begin (), counts.end ());
  std::int32_t second = 0;
  for (auto count = counts.begin (); count != counts.end (); ++count)
    if (count != most)
      second = std::max (second, *count);
  const auto place = static_cast<std::int32_t> (most - counts.begin ());
  const Rule& rule = points.col (place) == zero ? AT_ZERO : ELSEWHERE;
  const bool many = *most >= rule.fewest && (second == 1 || *most > rule.times * second);
  return many && isApart (points, place, rule.spacings) ? place : -1;
}

} // namespace manifold
} // namespace pcl
