#include "extraction/fan.h"

#include <algorithm>

namespace pcl {
namespace manifold {

const std::vector<int>&
Fan::split (int& components)
{
  components = 0;
  component_.assign (sides_.size (), -1);
  for (std::size_t seed = 0; seed < sides_.size (); ++seed) {
    if (component_[seed] >= 0)
      continue;
    component_[seed] = components;
    stack_.assign (1, static_cast<int> (seed));
    while (!stack_.empty ()) {
      const auto side = sides_[stack_.back ()];
      stack_.pop_back ();
      for (std::size_t i = 0; i < sides_.size (); ++i)
        if (component_[i] < 0 && (sides_[i].first == side.first || sides_[i].first == side.second ||
                                  sides_[i].second == side.first || sides_[i].second == side.second)) {
          component_[i] = components;
          stack_.push_back (static_cast<int> (i));
        }
    }
    ++components;
  }
  return component_;
}

int
Fan::degree (std::int32_t vertex) const
{
  return static_cast<int> (std::count_if (sides_.begin (), sides_.end (), [vertex] (const auto& side) {
    return side.first == vertex || side.second == vertex;
  }));
}

bool
Fan::isManifold ()
{
  if (sides_.empty ())
    return true;
  int components = 0;
  split (components);
  return components == 1 && std::all_of (sides_.begin (), sides_.end (), [this] (const auto& side) {
           return degree (side.first) <= 2 && degree (side.second) <= 2;
         });
}

bool
Fan::isDirected () const
{
  for (std::size_t i = 0; i < sides_.size (); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (sides_[i].first == sides_[j].first || sides_[i].second == sides_[j].second)
        return false;
  return true;
}

bool
Fan::canBecomeManifold ()
{
  if (std::any_of (sides_.begin (), sides_.end (),
                   [this] (const auto& side) { return degree (side.first) > 2 || degree (side.second) > 2; }))
    return false;
  // A path has two ends, a cycle none.
  int components = 0;
  split (components);
  int ends = 0;
  for (const auto& side : sides_)
    ends += (degree (side.first) == 1 ? 1 : 0) + (degree (side.second) == 1 ? 1 : 0);
  return ends == 2 * components || components == 1;
}

std::array<std::int32_t, 2>
Fan::ends ()
{
  std::array<std::int32_t, 2> result{-1, -1};
  if (sides_.empty () || !isManifold ())
    return result;
  int count = 0;
  for (const auto& side : sides_)
    for (const std::int32_t vertex : {side.first, side.second})
      if (degree (vertex) == 1)
        result[count++] = vertex;
  return result;
}

bool
Fan::isClosed () const
{
  if (sides_.size () < 2)
    return false;
  // Along the sides from the first one on, back to it after all of them.
  std::size_t current = 0;
  std::int32_t vertex = sides_[0].second;
  for (std::size_t step = 1; step <= sides_.size (); ++step) {
    std::size_t next = sides_.size ();
    for (std::size_t i = 0; i < sides_.size (); ++i)
      if (i != current && (sides_[i].first == vertex || sides_[i].second == vertex)) {
        if (next != sides_.size ())
          return false; // more than two sides meet
        next = i;
      }
    if (next == sides_.size ())
      return false;
    if (next == 0)
      return step == sides_.size ();
    vertex = sides_[next].first == vertex ? sides_[next].second : sides_[next].first;
    current = next;
  }
  return false;
}

} // namespace manifold
} // namespace pcl
