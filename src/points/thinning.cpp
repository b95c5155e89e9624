#include "points/thinning.h"

#include <pcl/manifold/bulk_box.h>

#include "points/nearest_neighbors.h"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace pcl {
namespace manifold {

namespace {

constexpr std::uint64_t ORDER_SEED = 20100817;

// A Fisher-Yates shuffle with Boost's generator and distribution, which, unlike the standard library's, give
// the same sequence everywhere.
std::vector<std::int32_t>
randomOrder (std::size_t n)
{
  boost::random::mt19937_64 generator (ORDER_SEED);
  std::vector<std::int32_t> order (n);
  for (std::size_t i = 0; i < n; ++i)
    order[i] = static_cast<std::int32_t> (i);
  for (std::size_t i = n; i > 1; --i)
    std::swap (order[i - 1],
               order[boost::random::uniform_int_distribution<std::size_t> (0, i - 1) (generator)]);
  return order;
}

// The smallest cell of the grid in a share of the largest coordinate of the bulk, and the largest number of
// one. What is farther away is in the last cell of its row, no farther from its neighbours than it was.
constexpr double MIN_CELL = 0x1p-40;
constexpr double LAST_CELL = 0x1p42;

using Cell = std::array<std::int64_t, 3>;

struct CellHash
{
  std::size_t operator() (const Cell& cell) const
  {
    std::uint64_t hash = 0;
    for (const std::int64_t coordinate : cell) {
      hash ^= static_cast<std::uint64_t> (coordinate) + 0x9e3779b97f4a7c15ULL + (hash << 6) + (hash >> 2);
      hash *= 0xff51afd7ed558ccdULL;
    }
    return static_cast<std::size_t> (hash ^ hash >> 33);
  }
};

} // namespace

std::vector<std::uint8_t>
thinByNeighbors (const Eigen::Matrix3Xd& points, int k)
{
  const auto n = static_cast<std::size_t> (points.cols ());
  std::vector<std::uint8_t> kept (n, 0);
  if (n == 0)
    return kept;
  k = static_cast<int> (std::min<std::size_t> (k, n - 1));
  const std::vector<pcl::index_t> neighbors = kNearestNeighbors (points, k);
  std::vector<std::uint8_t> excluded (n, 0);
  for (const std::int32_t point : randomOrder (n)) {
    const pcl::index_t* row = neighbors.data () + static_cast<std::size_t> (point) * k;
    // A kept point has marked its own neighbours; that this point has a kept one among its own is seen here.
    if (excluded[point] || std::any_of (row, row + k, [&kept] (pcl::index_t q) { return kept[q] != 0; }))
      continue;
    kept[point] = 1;
    std::for_each (row, row + k, [&excluded] (pcl::index_t q) { excluded[q] = 1; });
  }
  return kept;
}

std::vector<std::uint8_t>
thinBySpacing (const Eigen::Matrix3Xd& points, double spacing)
{
  const auto n = static_cast<std::size_t> (points.cols ());
  if (n < 2)
    return std::vector<std::uint8_t> (n, 1);
  std::vector<std::uint8_t> kept (n, 0);
  // A cell holds one kept point at the most; very small spacings have larger cells, so that their numbers are
  // exact.
  const Eigen::AlignedBox3d bulk = bulkBox (points);
  const double largest = std::max (bulk.min ().cwiseAbs ().maxCoeff (), bulk.max ().cwiseAbs ().maxCoeff ());
  const double cell_size = std::max (spacing / std::sqrt (3.0), largest * MIN_CELL);
  const auto cellOf = [&] (std::int32_t point) {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis)
      cell[axis] = static_cast<std::int64_t> (
        std::floor (std::clamp (points (axis, point) / cell_size, -LAST_CELL, LAST_CELL)));
    return cell;
  };
  std::unordered_map<Cell, std::int32_t, CellHash> grid; // the last kept point of each cell
  std::vector<std::int32_t> next (n, -1);                // the one kept before it in its cell
  const auto isFree = [&] (const Cell& cell, std::int32_t point) {
    const auto first = grid.find (cell);
    if (first == grid.end ())
      return true;
    for (std::int32_t q = first->second; q >= 0; q = next[q])
      if ((points.col (q) - points.col (point)).norm () < spacing)
        return false;
    return true;
  };
  for (const std::int32_t point : randomOrder (n)) {
    const Cell cell = cellOf (point);
    bool free = isFree (cell, point); // most that are not see it there
    for (std::int64_t x = -2; free && x <= 2; ++x)
      for (std::int64_t y = -2; free && y <= 2; ++y)
        for (std::int64_t z = -2; free && z <= 2; ++z)
          free = isFree ({cell[0] + x, cell[1] + y, cell[2] + z}, point);
    if (!free)
      continue;
    kept[point] = 1;
    const auto [position, inserted] = grid.emplace (cell, point);
    if (!inserted) {
      next[point] = position->second;
      position->second = point;
    }
  }
  return kept;
}

} // namespace manifold
} // namespace pcl
