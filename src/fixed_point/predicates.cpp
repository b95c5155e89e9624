#include "fixed_point/predicates.h"

#include "fixed_point/exact_number.h"
#include "fixed_point/filtered_number.h"
#include "fixed_point/lattice.h"
#include "fixed_point/number_vector.h"

namespace pcl {
namespace manifold {

namespace {

using Eigen::Vector3d;

template <typename Number>
int
nearerSign (const Vector3d& point, const Vector3d& p, const Vector3d& q)
{
  return -signOf (excess (difference<Number> (q, p), difference<Number> (point, p)));
}

template <typename Number>
int
crossingOrder (const Vector3d& from, const Vector3d& to, const Vector3d& p, const Vector3d& q,
               const Vector3d& r)
{
  const NumberVector<Number> start = difference<Number> (from, p);
  const NumberVector<Number> end = difference<Number> (to, p);
  const NumberVector<Number> to_q = difference<Number> (q, p);
  const NumberVector<Number> to_r = difference<Number> (r, p);
  // The excess over q goes from s to e < 0 and so vanishes at s / (s - e): before that over r does, if the
  // ratio of s to -e is less.
  return signOf (
    determinant (excess (to_r, start), excess (to_q, start), excess (to_r, end), excess (to_q, end)));
}

template <typename Number>
int
ballSign (const Vector3d& point, const Vector3d& p, const Vector3d& q)
{
  return signOf (dot (difference<Number> (p, point), difference<Number> (q, point)));
}

} // namespace

int
nearer (const Vector3d& point, const Vector3d& p, const Vector3d& q)
{
  const int sign = nearerSign<FilteredNumber> (point, p, q);
  if (sign != 0)
    return sign;
  std::array<Vector3d, 3> lattice{point, p, q};
  return moveToLattice (lattice) ? nearerSign<LatticeNumber> (lattice[0], lattice[1], lattice[2])
                                 : nearerSign<ExactNumber> (point, p, q);
}

int
crossesFirst (const Vector3d& from, const Vector3d& to, const Vector3d& p, const Vector3d& q,
              const Vector3d& r)
{
  const int sign = crossingOrder<FilteredNumber> (from, to, p, q, r);
  if (sign != 0)
    return sign;
  std::array<Vector3d, 5> lattice{from, to, p, q, r};
  return moveToLattice (lattice)
           ? crossingOrder<LatticeNumber> (lattice[0], lattice[1], lattice[2], lattice[3], lattice[4])
           : crossingOrder<ExactNumber> (from, to, p, q, r);
}

bool
isOutsideBall (const Vector3d& point, const Vector3d& p, const Vector3d& q)
{
  const int sign = ballSign<FilteredNumber> (point, p, q);
  if (sign != 0)
    return sign > 0;
  std::array<Vector3d, 3> lattice{point, p, q};
  return (moveToLattice (lattice) ? ballSign<LatticeNumber> (lattice[0], lattice[1], lattice[2])
                                  : ballSign<ExactNumber> (point, p, q)) > 0;
}

} // namespace manifold
} // namespace pcl
