#pragma once

#include <pcl/manifold/export.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** Asks the system to back memory that nobody has touched yet by large pages. The first touch of a page is a
 * call of the kernel: for arrays of many megabytes these calls, thousands of small pages after each other,
 * took as long as what is computed in them, and they hardly run in parallel. Without effect for small arrays,
 * and where the system does not know of it. */
PCL_MANIFOLD_CORE_EXPORTS void adviseLargePages (void* begin, std::size_t bytes) noexcept;

/** Makes a vector of n equal values, in large pages if it is large. What it held is lost. */
template <typename T>
void
assignLarge (std::vector<T>& values, std::size_t n, const T& value = T ())
{
  std::vector<T> fresh;
  fresh.reserve (n);
  adviseLargePages (fresh.data (), n * sizeof (T));
  fresh.resize (n, value);
  values = std::move (fresh);
}

/** Gives a matrix n columns of any values, in large pages if it is large. What it held is lost. */
template <typename Matrix>
void
resizeLarge (Matrix& matrix, Eigen::Index rows, Eigen::Index columns)
{
  matrix.resize (rows, columns);
  adviseLargePages (matrix.data (),
                    static_cast<std::size_t> (matrix.size ()) * sizeof (typename Matrix::Scalar));
}

} // namespace manifold
} // namespace pcl
