#pragma once

#include <cstdint>
#include <random>

namespace oracle {

/** \brief Seeded random numbers that are the same with every standard library. */
class Random
{
public:
  explicit Random (std::uint64_t seed) : engine_ (seed) {}

  /** \brief In {0, ..., count - 1}. */
  int index (int count) { return static_cast<int> (engine_ () % static_cast<std::uint64_t> (count)); }

  /** \brief In {low, ..., high}. */
  int integer (int low, int high) { return low + index (high - low + 1); }

  /** \brief In [0, 1). */
  double uniform () { return static_cast<double> (engine_ () >> 11) * 0x1p-53; }

  double uniform (double low, double high) { return low + (high - low) * uniform (); }

  bool coin () { return (engine_ () >> 40 & 1) != 0; }

private:
  std::mt19937_64 engine_;
};

} // namespace oracle
