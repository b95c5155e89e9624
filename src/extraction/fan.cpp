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
Fan::isClosed ()
{
  return !sides_.empty () && isManifold () &&
         std::all_of (sides_.begin (), sides_.end (), [this] (const auto& side) {
           return degree (side.first) == 2 && degree (side.second) == 2;
         });
}

} // namespace manifold
} // namespace pcl
