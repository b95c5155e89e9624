#include "complex/tetrahedron_sides.h"

#include <array>
#include <numeric>
#include <stdexcept>

namespace pcl {
namespace manifold {

std::vector<SimplicialComplex::Triangle>
sidesOf (const std::vector<SimplicialComplex::Tetrahedron>& tetrahedra,
         const std::vector<std::uint32_t>& numbers)
{
  std::vector<SimplicialComplex::Triangle> sides;
  sides.reserve (numbers.size ());
  for (const std::uint32_t number : numbers)
    sides.push_back (sideOf (tetrahedra[number / 4], static_cast<int> (number % 4)));
  return sides;
}

TetrahedronSides::TetrahedronSides (const std::vector<SimplicialComplex::Tetrahedron>& tetrahedra)
  : tetrahedra_ (tetrahedra)
{
  static_assert (sizeof (pcl::index_t) == 4, "a side packs two vertices into one word");
  constexpr std::size_t sides_of_part = 512, sides_of_batch = 1 << 22, max_parts = 1 << 16;
  if (tetrahedra.size () >= std::size_t (1) << 30)
    throw std::length_error ("too many tetrahedra for one solid");
  pcl::index_t largest = 0;
  for (const auto& t : tetrahedra)
    largest = std::max (largest, *std::max_element (t.begin (), t.end ()));

  const std::size_t sides = 4 * tetrahedra.size ();
  batches_ = std::clamp<std::size_t> (sides / sides_of_batch, 1, 4);
  parts_ = std::clamp<std::size_t> (sides / batches_ / sides_of_part, 1, max_parts);
  width_ = static_cast<std::size_t> (largest) / (batches_ * parts_) + 1;
}

template <typename Function>
void
TetrahedronSides::forEachSide (std::size_t batch, Function f) const
{
  const std::size_t begin = batch * parts_ * width_, end = begin + parts_ * width_;
  for (std::size_t i = 0; i < tetrahedra_.size (); ++i) {
    const SimplicialComplex::Tetrahedron& t = tetrahedra_[i];
    if (isDegenerate (t))
      continue;
    std::array<std::uint64_t, 4> corners; // vertex and corner, by ascending vertices
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = static_cast<std::uint64_t> (t[k]) << 2 | k;
    std::sort (corners.begin (), corners.end ());
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint64_t low = corners[k == 0 ? 1 : 0] >> 2;
      if (low < begin || low >= end)
        continue;
      const std::uint64_t middle = corners[k <= 1 ? 2 : 1] >> 2, high = corners[k <= 2 ? 3 : 2] >> 2;
      f ((low - begin) / width_, Side{low << 32 | middle, high << 32 | (4 * i + (corners[k] & 3))});
    }
  }
}

void
TetrahedronSides::sortSides (std::size_t batch, std::vector<Side>& sides) const
{
  std::vector<std::size_t> starts (parts_ + 1, 0);
  forEachSide (batch, [&] (std::size_t part, const Side&) { ++starts[part + 1]; });
  std::partial_sum (starts.begin (), starts.end (), starts.begin ());
  sides.resize (starts.back ());
  std::vector<std::size_t> fill (starts.begin (), starts.end () - 1);
  forEachSide (batch, [&] (std::size_t part, const Side& side) { sides[fill[part]++] = side; });
  for (std::size_t part = 0; part < parts_; ++part)
    std::sort (
      sides.begin () + static_cast<std::ptrdiff_t> (starts[part]),
      sides.begin () + static_cast<std::ptrdiff_t> (starts[part + 1]), [] (const Side& a, const Side& b) {
        return a.low_middle != b.low_middle ? a.low_middle < b.low_middle : a.high_number < b.high_number;
      });
}

} // namespace manifold
} // namespace pcl
