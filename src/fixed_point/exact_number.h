#pragma once

#include "fixed_point/number_vector.h"

#include <CGAL/Mpzf.h>

#ifndef CGAL_HAS_MPZF
// GCC takes numbers of Boost's that are small for uninitialized large ones.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/multiprecision/cpp_int.hpp>
#pragma GCC diagnostic pop
#endif

namespace pcl {
namespace manifold {

/** Sums and products of doubles without rounding: CGAL's numbers for that or, where they are not to be had,
 * rational ones, which are slower. */
#ifdef CGAL_HAS_MPZF
using ExactNumber = CGAL::Mpzf;

inline int
signOf (const ExactNumber& x)
{
  return static_cast<int> (x.sign ());
}
#else
using ExactNumber = boost::multiprecision::cpp_rational;

inline int
signOf (const ExactNumber& x)
{
  return x.sign ();
}
#endif

template <>
inline ExactNumber
differenceOf<ExactNumber> (double x, double y)
{
  return ExactNumber (x) - ExactNumber (y);
}

} // namespace manifold
} // namespace pcl
