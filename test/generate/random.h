#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>

namespace generate {

/** \brief Seeded random numbers. Boost's distributions, unlike those of the standard library, give the same
 * numbers with every compiler. */
class Random
{
public:
  explicit Random (std::uint64_t seed) : engine_ (seed) {}

  /** \brief Uniform in [0, 1). */
  double uniform () { return uniform_ (engine_); }

  double uniform (double low, double high) { return low + (high - low) * uniform (); }

  /** \brief Uniform in {0, ..., count - 1}; \a count must be positive. */
  std::size_t index (std::size_t count)
  {
    return boost::random::uniform_int_distribution<std::size_t> (0, count - 1) (engine_);
  }

  /** \brief A standard normal number. */
  double normal () { return normal_ (engine_); }

  /** \brief A point of the unit cube. */
  Eigen::Vector3d cube ()
  {
    const double x = uniform (), y = uniform (), z = uniform ();
    return {x, y, z};
  }

  /** \brief A uniformly distributed unit vector. */
  Eigen::Vector3d direction ()
  {
    Eigen::Vector3d v;
    do {
      const double x = normal (), y = normal (), z = normal ();
      v << x, y, z;
    } while (v.squaredNorm () == 0.0);
    return v.normalized ();
  }

private:
  boost::random::mt19937_64 engine_;
  boost::random::uniform_01<double> uniform_;
  boost::random::normal_distribution<double> normal_;
};

} // namespace generate
