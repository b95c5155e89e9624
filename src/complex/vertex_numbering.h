#pragma once

#include <pcl/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief Vertex indices of a set of simplices, one after the other. */
struct IndexSpan
{
  const pcl::index_t* data = nullptr;
  std::size_t size = 0;

  IndexSpan (const pcl::Indices& indices) : data (indices.data ()), size (indices.size ()) {}

  template <std::size_t N>
  IndexSpan (const std::vector<std::array<pcl::index_t, N>>& simplices)
    : data (simplices.empty () ? nullptr : simplices.front ().data ()), size (simplices.size () * N)
  {}
};

/** \brief Numbers the vertices that occur in some simplices 0, 1, 2, ... by ascending index, so that tables
 * over the vertices are as large as what is used and not as the largest index. Negative indices get none. */
class VertexNumbering
{
public:
  explicit VertexNumbering (std::initializer_list<IndexSpan> spans);

  /** \brief How many distinct vertices occur. */
  std::size_t size () const { return size_; }

  /** \brief The number of a vertex that occurs. */
  std::uint32_t operator[] (pcl::index_t vertex) const
  {
    return sorted_.empty () ? table_[static_cast<std::size_t> (vertex)] : find (vertex);
  }

private:
  std::uint32_t find (pcl::index_t vertex) const;

  std::size_t size_ = 0;
  std::vector<std::uint32_t> table_; ///< by index, where the indices are dense enough
  pcl::Indices sorted_;              ///< otherwise the occurring indices
};

} // namespace manifold
} // namespace pcl
