#include "graph/faces/cyclic_order.h"

#include "complex/disjoint_sets.h"

#include <algorithm>
#include <array>

namespace pcl {
namespace manifold {

namespace {

constexpr std::uint32_t NOBODY = ~std::uint32_t (0);

// Things in rows: whom each thing is joined with so far.
using Joined = std::vector<std::array<std::uint32_t, 2>>;

void
appendRow (const Joined& joined, std::uint32_t end, std::vector<std::uint8_t>& taken,
           std::vector<std::uint32_t>& order)
{
  std::uint32_t before = NOBODY;
  for (std::uint32_t thing = end; thing != NOBODY;) {
    order.push_back (thing);
    taken[thing] = 1;
    const std::uint32_t next = joined[thing][0] != before ? joined[thing][0] : joined[thing][1];
    before = thing;
    thing = next;
  }
}

} // namespace

std::vector<std::uint32_t>
joinHeaviestFirst (std::size_t size, std::vector<FollowWeight> weights)
{
  std::sort (weights.begin (), weights.end (), [] (const FollowWeight& p, const FollowWeight& q) {
    return p.weight != q.weight ? p.weight > q.weight : p.a != q.a ? p.a < q.a : p.b < q.b;
  });
  Joined joined (size, {NOBODY, NOBODY});
  DisjointSets rows (size);
  for (const FollowWeight& pair : weights) {
    if (joined[pair.a][1] != NOBODY || joined[pair.b][1] != NOBODY ||
        rows.find (pair.a) == rows.find (pair.b))
      continue;
    joined[pair.a][joined[pair.a][0] == NOBODY ? 0 : 1] = pair.b;
    joined[pair.b][joined[pair.b][0] == NOBODY ? 0 : 1] = pair.a;
    rows.join (pair.a, pair.b);
  }
  std::vector<std::uint32_t> order;
  order.reserve (size);
  std::vector<std::uint8_t> taken (size, 0);
  for (std::uint32_t thing = 0; thing < size; ++thing)
    if (taken[thing] == 0 && joined[thing][1] == NOBODY)
      appendRow (joined, thing, taken, order);
  return order;
}

void
CyclicOrder::reset (std::size_t size)
{
  size_ = size;
  weights_.assign (size * size, 0);
}

const std::vector<std::uint32_t>&
CyclicOrder::find ()
{
  order_.resize (size_);
  for (std::uint32_t thing = 0; thing < size_; ++thing)
    order_[thing] = thing;
  if (size_ <= 3) // all orders are the same
    return order_;
  rankPartners ();
  if (followBest ())
    return order_;
  startHeavy ();
  std::int64_t open = 0;
  for (std::uint32_t thing = 1; thing < size_; ++thing)
    open += weight (thing, partner (thing, 0)) + weight (thing, partner (thing, 1));
  path_.assign (1, 0);
  on_path_ = 1;
  steps_ = 0;
  extend (0, open);
  return order_;
}

void
CyclicOrder::rankPartners ()
{
  ranked_.clear ();
  for (std::uint32_t thing = 0; thing < size_; ++thing) {
    for (std::uint32_t other = 0; other < size_; ++other)
      if (other != thing)
        ranked_.push_back (other);
    std::sort (ranked_.end () - static_cast<std::ptrdiff_t> (size_ - 1), ranked_.end (),
               [this, thing] (std::uint32_t a, std::uint32_t b) {
                 return weight (thing, a) != weight (thing, b) ? weight (thing, a) > weight (thing, b)
                                                               : a < b;
               });
  }
}

// Where every thing follows its two heaviest partners, no order is heavier.
bool
CyclicOrder::followBest ()
{
  std::uint32_t before = partner (0, 1);
  std::uint32_t thing = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    const std::uint32_t first = partner (thing, 0);
    const std::uint32_t second = partner (thing, 1);
    if ((before != first && before != second) || (i > 0 && thing == 0))
      return false;
    order_[i] = thing;
    const std::uint32_t next = before == first ? second : first;
    before = thing;
    thing = next;
  }
  return thing == 0;
}

void
CyclicOrder::startHeavy ()
{
  std::vector<FollowWeight> pairs;
  for (std::uint32_t a = 0; a < size_; ++a)
    for (std::uint32_t b = a + 1; b < size_; ++b)
      pairs.push_back ({a, b, weight (a, b)});
  order_ = joinHeaviestFirst (size_, std::move (pairs));
  best_ = 0;
  for (std::size_t i = 0; i < size_; ++i)
    best_ += weight (order_[i], order_[(i + 1) % size_]);
}

// Tries all ways on from the end of the path that may lead to a heavier order. Things that are not on it have
// two followers to come, its ends one each, and open is the weight of the former's heaviest ones.
void
CyclicOrder::extend (std::int64_t weight_of_path, std::int64_t open)
{
  const std::uint32_t end = path_.back ();
  if (path_.size () == size_) {
    if (weight_of_path + weight (end, 0) > best_) {
      best_ = weight_of_path + weight (end, 0);
      order_ = path_;
    }
    return;
  }
  if (2 * weight_of_path + open + weight (end, partner (end, 0)) + weight (0, partner (0, 0)) <= 2 * best_)
    return;
  for (std::size_t rank = 0; rank + 1 < size_ && steps_ < MOST_STEPS; ++rank) {
    const std::uint32_t next = partner (end, rank);
    if ((on_path_ >> next & 1) != 0)
      continue;
    ++steps_;
    path_.push_back (next);
    on_path_ |= 1u << next;
    extend (weight_of_path + weight (end, next),
            open - weight (next, partner (next, 0)) - weight (next, partner (next, 1)));
    on_path_ &= ~(1u << next);
    path_.pop_back ();
  }
}

} // namespace manifold
} // namespace pcl
