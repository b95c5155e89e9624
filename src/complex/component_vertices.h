#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief Collects which components each vertex belongs to, nearly always one. */
class ComponentVertices
{
public:
  explicit ComponentVertices (std::size_t vertices) : first_ (vertices, none) {}

  void add (std::uint32_t vertex, std::uint32_t component)
  {
    if (first_[vertex] == none)
      first_[vertex] = component;
    else if (first_[vertex] != component)
      further_.emplace_back (vertex, component);
  }

  /** \brief Calls f (vertex, component) once for every pair that was added. */
  template <typename Function>
  void forEach (Function f)
  {
    std::sort (further_.begin (), further_.end ());
    further_.erase (std::unique (further_.begin (), further_.end ()), further_.end ());
    for (std::uint32_t v = 0; v < first_.size (); ++v)
      if (first_[v] != none)
        f (v, first_[v]);
    for (const auto& [vertex, component] : further_)
      f (vertex, component);
  }

private:
  static constexpr std::uint32_t none = ~std::uint32_t (0);

  std::vector<std::uint32_t> first_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> further_;
};

} // namespace manifold
} // namespace pcl
