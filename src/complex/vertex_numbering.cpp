#include "complex/vertex_numbering.h"

#include <algorithm>
#include <iterator>

namespace pcl {
namespace manifold {

VertexNumbering::VertexNumbering (std::initializer_list<IndexSpan> spans)
{
  std::size_t total = 0;
  pcl::index_t largest = -1;
  for (const IndexSpan& span : spans) {
    total += span.size;
    for (std::size_t i = 0; i < span.size; ++i)
      largest = std::max (largest, span.data[i]);
  }
  if (largest < 0)
    return;

  const auto indices = static_cast<std::size_t> (largest) + 1;
  if (indices <= 8 * total + 1024) {
    table_.assign (indices, 0);
    for (const IndexSpan& span : spans)
      for (std::size_t i = 0; i < span.size; ++i)
        if (span.data[i] >= 0)
          table_[static_cast<std::size_t> (span.data[i])] = 1;
    std::uint32_t next = 0;
    for (std::uint32_t& entry : table_)
      entry = entry != 0 ? next++ : 0;
    size_ = next;
    return;
  }

  sorted_.reserve (total);
  for (const IndexSpan& span : spans)
    std::copy_if (span.data, span.data + span.size, std::back_inserter (sorted_),
                  [] (pcl::index_t v) { return v >= 0; });
  std::sort (sorted_.begin (), sorted_.end ());
  sorted_.erase (std::unique (sorted_.begin (), sorted_.end ()), sorted_.end ());
  size_ = sorted_.size ();
}

std::uint32_t
VertexNumbering::find (pcl::index_t vertex) const
{
  return static_cast<std::uint32_t> (std::lower_bound (sorted_.begin (), sorted_.end (), vertex) -
                                     sorted_.begin ());
}

} // namespace manifold
} // namespace pcl
