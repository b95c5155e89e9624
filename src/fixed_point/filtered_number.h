#pragma once

#include "fixed_point/number_vector.h"

#include <cmath>

namespace pcl {
namespace manifold {

/** A number computed in doubles, with a measure of what rounding can have done to it: the same expression
 * computed with absolute values throughout. Its sign is certain where it is large against that measure.
 *
 * Every operation rounds by at most the unit roundoff u = 2^-53 times the magnitude, and by a fixed tiny
 * amount where it underflows. The magnitude of a difference has a floor of 2^-150, so that a product of up to
 * six of them stays above 2^-900, where the tiny amount is less than u times it, too. A number that went
 * through n roundings one after the other is thus off by at most 2 n u of its magnitude, with some more for
 * the roundings of the magnitude itself. An overflow makes the magnitude infinite, and no sign certain. */
struct FilteredNumber
{
  double value;
  double magnitude;
};

/** No expression here goes through more than 26 roundings, nor multiplies more than six differences. */
constexpr double FILTER_ROUNDINGS = 64.0 * 0x1p-53;
constexpr double FILTER_FLOOR = 0x1p-150;

inline FilteredNumber
operator+ (const FilteredNumber& x, const FilteredNumber& y)
{
  return {x.value + y.value, x.magnitude + y.magnitude};
}

inline FilteredNumber
operator- (const FilteredNumber& x, const FilteredNumber& y)
{
  return {x.value - y.value, x.magnitude + y.magnitude};
}

inline FilteredNumber
operator* (const FilteredNumber& x, const FilteredNumber& y)
{
  return {x.value * y.value, x.magnitude * y.magnitude};
}

template <>
inline FilteredNumber
differenceOf<FilteredNumber> (double x, double y)
{
  return {x - y, std::abs (x - y) + FILTER_FLOOR};
}

/** The sign where it is certain, or else 0. */
inline int
signOf (const FilteredNumber& x)
{
  const double bound = FILTER_ROUNDINGS * x.magnitude;
  return x.value > bound ? 1 : (x.value < -bound ? -1 : 0);
}

} // namespace manifold
} // namespace pcl
