#pragma once

#include <pcl/manifold/delaunay_complex.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The cells at one sample, split into the connected components of each colour: two cells are connected if
 * they share a facet at the sample. The surface where the colour changes is a manifold at the sample if there
 * are no more than two components. Keeps its scratch memory between calls; one object a thread. */
class CellStar
{
public:
  explicit CellStar (const DelaunayComplex& complex) : complex_ (complex) {}

  void split (std::int32_t sample, const std::vector<std::uint8_t>& colors);

  int components () const { return static_cast<int> (sizes_.size ()); }

  /** The component with the fewest cells; of equal ones the first.
   * \param[in] finite leaves out those with infinite cells, unless there are no others */
  int smallest (bool finite) const;

  /** The cells of a component, in ascending order. */
  std::vector<std::int32_t> cellsOf (int component) const;

private:
  const DelaunayComplex& complex_;
  std::vector<std::int32_t> cells_;
  std::vector<int> component_;
  std::vector<int> sizes_;
  std::vector<std::uint8_t> infinite_; // whether a component has infinite cells
  std::vector<int> stack_;
};

} // namespace manifold
} // namespace pcl
