#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** How much speaks for two things, of some that are around another, to follow each other. */
struct FollowWeight
{
  std::uint32_t a;
  std::uint32_t b;
  std::int32_t weight; ///< at least 0
};

/** A cyclic order of things that is heavy: pairs are joined by descending weight as long as no thing gets a
 * third neighbour and no cycle closes; what is left over follows in the order of the numbers.
 * \param[in] weights pairs of distinct numbers below \a size, every pair at most once
 * \return all numbers below \a size, each once */
std::vector<std::uint32_t> joinHeaviestFirst (std::size_t size, std::vector<FollowWeight> weights);

/** Finds the cyclic order of few things of the largest sum of weights of things that follow each other, a
 * Hamiltonian cycle of maximum weight, by branch and bound. */
class CyclicOrder
{
public:
  /// Many times as many as it takes where things are around a disc: it only limits the time on weights that
  /// make no sense. The best order found until then is taken.
  static constexpr int MOST_STEPS = 4000;

  static constexpr std::size_t MOST_THINGS = 16;

  /** Begins with no weight between any two of \a size things, at most MOST_THINGS. */
  void reset (std::size_t size);

  std::size_t size () const { return size_; }

  std::int32_t weight (std::uint32_t a, std::uint32_t b) const { return weights_[a * size_ + b]; }

  /** Of a and b in either order. */
  void set (std::uint32_t a, std::uint32_t b, std::int32_t weight)
  {
    weights_[a * size_ + b] = weight;
    weights_[b * size_ + a] = weight;
  }

  /** All things, each once. */
  const std::vector<std::uint32_t>& find ();

private:
  void rankPartners ();
  bool followBest ();
  void startHeavy ();
  void extend (std::int64_t weight, std::int64_t open);

  std::uint32_t partner (std::uint32_t thing, std::size_t rank) const
  {
    return ranked_[thing * (size_ - 1) + rank];
  }

  std::size_t size_ = 0;
  std::vector<std::int32_t> weights_;
  std::vector<std::uint32_t> ranked_; ///< per thing the others, the heaviest first
  std::vector<std::uint32_t> order_;
  std::int64_t best_ = 0; ///< the weight of order_
  std::vector<std::uint32_t> path_;
  std::uint32_t on_path_ = 0; ///< a bit per thing
  int steps_ = 0;
};

} // namespace manifold
} // namespace pcl
