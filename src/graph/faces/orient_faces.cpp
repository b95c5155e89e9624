#include "graph/faces/orient_faces.h"

#include <algorithm>
#include <cstdint>

namespace pcl {
namespace manifold {

namespace {

using Walk = std::vector<pcl::index_t>;

constexpr std::size_t NONE = ~std::size_t (0);

void
beginAtSmallest (Walk& walk)
{
  std::rotate (walk.begin (), std::min_element (walk.begin (), walk.end ()), walk.end ());
  if (walk.size () > 2 && walk[1] > walk.back ())
    std::reverse (walk.begin () + 1, walk.end ());
}

// The sides of faces and holes: side i of a walk is the edge from its i-th landmark to the next one.
class Sides
{
public:
  explicit Sides (const std::vector<const Walk*>& walks)
  {
    starts_.push_back (0);
    for (const Walk* walk : walks)
      starts_.push_back (starts_.back () + walk->size ());
    std::vector<Side> sides;
    sides.reserve (starts_.back ());
    for (std::uint32_t w = 0; w < walks.size (); ++w)
      for (std::size_t i = 0; i < walks[w]->size (); ++i) {
        const pcl::index_t from = (*walks[w])[i];
        const pcl::index_t to = (*walks[w])[i + 1 < walks[w]->size () ? i + 1 : 0];
        sides.push_back ({std::min (from, to), std::max (from, to), starts_[w] + i, w, from < to});
      }
    std::sort (sides.begin (), sides.end (), [] (const Side& a, const Side& b) {
      return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.number < b.number;
    });
    neighbors_.assign (starts_.back (), {});
    for (std::size_t i = 0; i < sides.size ();) {
      std::size_t end = i + 1;
      while (end < sides.size () && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
        ++end;
      if (end == i + 2) {
        const bool agree = sides[i].upward != sides[i + 1].upward;
        neighbors_[sides[i].number] = {sides[i + 1].walk, agree};
        neighbors_[sides[i + 1].number] = {sides[i].walk, agree};
      }
      i = end;
    }
  }

  // Calls visit (neighbor, agree) for the walks at the other sides of edges of exactly two.
  template <typename Visit>
  void visitNeighbors (std::size_t walk, const Visit& visit) const
  {
    for (std::size_t side = starts_[walk]; side < starts_[walk + 1]; ++side)
      if (neighbors_[side].walk != NONE)
        visit (neighbors_[side].walk, neighbors_[side].agree);
  }

private:
  struct Side
  {
    pcl::index_t low;
    pcl::index_t high;
    std::size_t number;
    std::size_t walk;
    bool upward;
  };

  struct Neighbor
  {
    std::size_t walk = NONE;
    bool agree = false; ///< do both pass their edge in opposite directions?
  };

  std::vector<std::size_t> starts_;
  std::vector<Neighbor> neighbors_; ///< per side
};

constexpr std::uint8_t UNSEEN = 2;

// Which faces, the first walks, are to be turned so that they agree with the first one of their part.
std::vector<std::uint8_t>
turnedFaces (const Sides& sides, std::size_t faces)
{
  std::vector<std::uint8_t> turned (faces, UNSEEN);
  std::vector<std::size_t> queue;
  for (std::size_t seed = 0; seed < faces; ++seed) {
    if (turned[seed] != UNSEEN)
      continue;
    turned[seed] = 0;
    queue.assign (1, seed);
    for (std::size_t i = 0; i < queue.size (); ++i)
      sides.visitNeighbors (queue[i], [&] (std::size_t neighbor, bool agree) {
        if (neighbor >= faces || turned[neighbor] != UNSEEN)
          return;
        turned[neighbor] = agree ? turned[queue[i]] : 1 - turned[queue[i]];
        queue.push_back (neighbor);
      });
  }
  return turned;
}

void
turn (Walk& walk)
{
  std::reverse (walk.begin () + 1, walk.end ());
}

} // namespace

void
orientFaces (LandmarkMesh& mesh)
{
  std::vector<const Walk*> walks;
  for (std::vector<Walk>* kind : {&mesh.faces, &mesh.holes}) {
    for (Walk& walk : *kind)
      beginAtSmallest (walk);
    std::sort (kind->begin (), kind->end ());
    for (const Walk& walk : *kind)
      walks.push_back (&walk);
  }
  const Sides sides (walks);
  const std::vector<std::uint8_t> turned = turnedFaces (sides, mesh.faces.size ());
  // Faces decide about holes, never holes about faces: there may be faces that agree around a part of a hole
  // only.
  for (std::size_t h = 0; h < mesh.holes.size (); ++h) {
    std::uint8_t turned_hole = UNSEEN;
    sides.visitNeighbors (mesh.faces.size () + h, [&] (std::size_t neighbor, bool agree) {
      if (turned_hole == UNSEEN && neighbor < mesh.faces.size ())
        turned_hole = agree ? turned[neighbor] : 1 - turned[neighbor];
    });
    if (turned_hole == 1)
      turn (mesh.holes[h]);
  }
  for (std::size_t f = 0; f < mesh.faces.size (); ++f)
    if (turned[f] == 1)
      turn (mesh.faces[f]);
}

} // namespace manifold
} // namespace pcl
