#include "complex/surface_patches.h"

namespace pcl {
namespace manifold {

SurfacePatches::SurfacePatches (const SurfaceSides& sides)
{
  constexpr std::uint32_t unseen = ~std::uint32_t (0);
  patch.assign (sides.faces (), unseen);
  turned.assign (sides.faces (), 0);
  std::vector<std::uint32_t> open;
  for (std::uint32_t seed = 0; seed < sides.faces (); ++seed) {
    if (patch[seed] != unseen)
      continue;
    const auto current = static_cast<std::uint32_t> (orientable.size ());
    orientable.push_back (1);
    has_boundary.push_back (0);
    patch[seed] = current;
    open.assign (1, seed);
    while (!open.empty ()) {
      const std::uint32_t f = open.back ();
      open.pop_back ();
      for (std::uint32_t s = sides.starts[f]; s < sides.starts[f + 1]; ++s) {
        if (!sides.hasTwin (s)) {
          has_boundary[current] |= sides.twin[s] == SurfaceSides::border;
          continue;
        }
        const std::uint32_t t = sides.twin[s];
        const std::uint32_t neighbour = sides.face[t];
        // Neighbours agree when they pass through their edge in opposite directions.
        const bool same_direction = sides.origin[s] == sides.origin[t];
        const auto turn = static_cast<std::uint8_t> ((turned[f] != 0) != same_direction);
        if (patch[neighbour] == unseen) {
          patch[neighbour] = current;
          turned[neighbour] = turn;
          open.push_back (neighbour);
        } else if (turned[neighbour] != turn)
          orientable[current] = 0;
      }
    }
  }
}

} // namespace manifold
} // namespace pcl
