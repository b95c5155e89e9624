#pragma once

#include <pcl/manifold/simplicial_complex.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief The side of a positively oriented tetrahedron that lies opposite its corner 0, 1, 2 or 3, facing
 * outward. */
inline SimplicialComplex::Triangle
sideOf (const SimplicialComplex::Tetrahedron& t, int corner)
{
  switch (corner) {
    case 0:
      return {t[1], t[2], t[3]};
    case 1:
      return {t[0], t[3], t[2]};
    case 2:
      return {t[0], t[1], t[3]};
    default:
      return {t[0], t[2], t[1]};
  }
}

/** \brief Is a tetrahedron none, for a repeated or negative vertex? */
inline bool
isDegenerate (SimplicialComplex::Tetrahedron t)
{
  std::sort (t.begin (), t.end ());
  return t.front () < 0 || std::adjacent_find (t.begin (), t.end ()) != t.end ();
}

/** \brief The sides with the given numbers, see TetrahedronSides, facing outward. */
std::vector<SimplicialComplex::Triangle> sidesOf (
  const std::vector<SimplicialComplex::Tetrahedron>& tetrahedra, const std::vector<std::uint32_t>& numbers);

/** \brief Which tetrahedra share which triangles. A side is numbered 4 * tetrahedron + opposite corner;
 * degenerate tetrahedra have none.
 *
 * Sides are dealt into small parts by their smallest vertices and sorted part by part, which keeps the work
 * within the processor's caches in whatever order the tetrahedra come. Large inputs are dealt a quarter at a
 * time, which keeps the memory at about 16 bytes a tetrahedron. */
class TetrahedronSides
{
public:
  /** \param[in] tetrahedra must outlive this object
   * \throw std::length_error for 2^30 tetrahedra or more */
  explicit TetrahedronSides (const std::vector<SimplicialComplex::Tetrahedron>& tetrahedra);

  /** \brief Calls f (first, last) for every distinct triangle, with the iterators to the numbers, ascending,
   * of its sides. */
  template <typename Function>
  void forEachTriangle (Function f) const
  {
    std::vector<Side> sides;
    std::vector<std::uint32_t> numbers;
    for (std::size_t batch = 0; batch < batches_; ++batch) {
      sortSides (batch, sides);
      for (std::size_t first = 0, last; first < sides.size (); first = last) {
        numbers.clear ();
        for (last = first; last < sides.size () && sides[last].sameTriangle (sides[first]); ++last)
          numbers.push_back (static_cast<std::uint32_t> (sides[last].high_number));
        f (numbers.cbegin (), numbers.cend ());
      }
    }
  }

private:
  /** \brief Vertices in ascending order and the side's number, in two words that sort quickly. */
  struct Side
  {
    std::uint64_t low_middle;
    std::uint64_t high_number;

    bool sameTriangle (const Side& other) const
    {
      return low_middle == other.low_middle && high_number >> 32 == other.high_number >> 32;
    }
  };

  /** \brief The sides of one batch, sorted by their triangles and then by their numbers. */
  void sortSides (std::size_t batch, std::vector<Side>& sides) const;

  /** \brief Calls f (part, side) for the sides in a batch, in the order of the tetrahedra. */
  template <typename Function>
  void forEachSide (std::size_t batch, Function f) const;

  const std::vector<SimplicialComplex::Tetrahedron>& tetrahedra_;
  std::size_t batches_ = 1;
  std::size_t parts_ = 1; ///< of each batch
  std::size_t width_ = 1; ///< vertices of each part
};

} // namespace manifold
} // namespace pcl
