#include "graph/landmarks/contact_rows.h"

#include <algorithm>

namespace pcl {
namespace manifold {

ContactRows::ContactRows (std::size_t tiles, const std::vector<TileContact>& contacts) : starts (tiles + 1, 0)
{
  for (const TileContact& contact : contacts) {
    ++starts[contact.first + 1];
    ++starts[contact.second + 1];
  }
  for (std::size_t t = 0; t < tiles; ++t)
    starts[t + 1] += starts[t];
  tile.resize (starts.back ());
  boundary_points.resize (starts.back ());
  adjacent.resize (starts.back ());

  // In ascending order of the pairs a tile first meets the smaller ones, then the larger ones.
  std::vector<std::size_t> ends (starts.begin (), starts.end () - 1);
  const auto add = [&] (pcl::index_t of, pcl::index_t other, const TileContact& contact) {
    const std::size_t position = ends[of]++;
    tile[position] = other;
    boundary_points[position] = contact.boundary_points;
    adjacent[position] = contact.adjacent ? 1 : 0;
  };
  for (const TileContact& contact : contacts) {
    add (contact.first, contact.second, contact);
    add (contact.second, contact.first, contact);
  }
}

void
ContactRows::limitAdjacency (std::size_t most)
{
  std::vector<std::size_t> row;
  std::vector<std::uint8_t> dropped (tile.size (), 0);
  for (std::size_t t = 0; t < tiles (); ++t) {
    if (starts[t + 1] - starts[t] <= most)
      continue;
    row.clear ();
    for (std::size_t contact = starts[t]; contact < starts[t + 1]; ++contact)
      if (adjacent[contact] != 0)
        row.push_back (contact);
    if (row.size () <= most)
      continue;
    const auto kept = row.begin () + static_cast<std::ptrdiff_t> (most);
    std::nth_element (row.begin (), kept, row.end (), [this] (std::size_t a, std::size_t b) {
      return boundary_points[a] != boundary_points[b] ? boundary_points[a] > boundary_points[b] : a < b;
    });
    for (auto contact = kept; contact != row.end (); ++contact)
      dropped[*contact] = 1;
  }
  for (std::size_t t = 0; t < tiles (); ++t)
    for (std::size_t contact = starts[t]; contact < starts[t + 1]; ++contact)
      if (dropped[contact] != 0 && dropped[find (tile[contact], static_cast<pcl::index_t> (t))] != 0)
        adjacent[contact] = 0;
}

std::size_t
ContactRows::find (pcl::index_t of, pcl::index_t other) const
{
  const auto begin = tile.begin () + static_cast<std::ptrdiff_t> (starts[of]);
  const auto end = tile.begin () + static_cast<std::ptrdiff_t> (starts[of + 1]);
  const auto found = std::lower_bound (begin, end, other);
  return found != end && *found == other ? static_cast<std::size_t> (found - tile.begin ()) : NONE;
}

} // namespace manifold
} // namespace pcl
