#include "summary.h"

#include "table.h"

#include <algorithm>
#include <cmath>

namespace pcl::manifold::apps {
namespace {

/** \brief "1 part", "2 parts" or, with a plural of its own, "2 vertices". */
std::string
counted (std::size_t number, const std::string& word, const std::string& plural = {})
{
  return grouped (number) + " " + (number == 1 ? word : plural.empty () ? word + "s" : plural);
}

/** \brief What counts are there of, separated by commas; empty if all are zero. */
std::string
listed (const std::vector<std::pair<std::size_t, std::string>>& counts)
{
  std::string text;
  for (const auto& [number, word] : counts)
    if (number > 0)
      text += (text.empty () ? "" : ", ") + grouped (number) + " " + word;
  return text;
}

template <typename Components, typename Predicate>
std::size_t
countOf (const Components& components, const Predicate& predicate)
{
  return static_cast<std::size_t> (std::count_if (components.begin (), components.end (), predicate));
}

std::string
onePart (const SurfaceTopology& surface)
{
  const SurfaceComponent& part = surface.components.front ();
  std::string text = "in one part, ";
  text += part.closed ? "closed" : "open with " + counted (part.boundary_loops, "boundary loop");
  if (part.genus >= 0)
    text += ", " + (part.orientable ? "of genus " + std::to_string (part.genus)
                                    : "with " + counted (static_cast<std::size_t> (part.genus), "crosscap"));
  return text;
}

std::string
manyParts (const SurfaceTopology& surface)
{
  const std::size_t closed = countOf (surface.components, [] (const auto& part) { return part.closed; });
  const double share =
    100.0 * static_cast<double> (surface.components.front ().faces) / static_cast<double> (surface.faces);
  std::string text = "in " + counted (surface.components.size (), "part") + ", " +
                     listed ({{closed, "closed"}, {surface.components.size () - closed, "open"}});
  if (surface.boundary_loops > 0)
    text += " with " + counted (surface.boundary_loops, "boundary loop");
  return text + "; the largest has " + std::to_string (static_cast<int> (share)) + " % of the faces";
}

} // namespace

std::string
inWords (const PointCounts& counts)
{
  const std::string out = listed ({{counts.dropped, "not finite"},
                                   {counts.no_measurement, "no measurement"},
                                   {counts.duplicates, "duplicate"},
                                   {counts.thinned, "thinned"}});
  return counted (counts.points, "point") + ", " +
         (out.empty () ? "none left out" : "left out " + out + ": " + counted (counts.samples, "sample"));
}

std::vector<std::string>
inWords (const std::string& name, const SurfaceTopology& surface)
{
  if (surface.components.empty ())
    return {};
  const bool is_one = surface.components.size () == 1;
  std::vector<std::string> lines = {name + " " + (is_one ? onePart (surface) : manyParts (surface))};
  const std::size_t one_sided =
    countOf (surface.components, [] (const auto& part) { return !part.orientable; });
  if (one_sided > 0)
    lines.push_back (name + " one-sided in " + counted (one_sided, "part") +
                     ": no way to orient all of its triangles");
  if (!surface.isManifold ())
    lines.push_back (name + " not manifold at " + counted (surface.non_manifold_edges, "edge") + " and " +
                     counted (surface.non_manifold_vertices, "vertex", "vertices"));
  return lines;
}

std::vector<std::string>
inWords (const pcl::TopologyReport& topology)
{
  std::vector<std::string> lines;
  const CurveTopology& curve = topology.curve;
  if (!curve.components.empty ()) {
    const std::size_t closed = countOf (curve.components, [] (const auto& part) { return part.closed; });
    lines.push_back (counted (curve.components.size (), "curve") + ", " +
                     listed ({{closed, "closed"}, {curve.components.size () - closed, "open"}}));
    if (curve.branching_vertices > 0)
      lines.push_back ("curves branch at " + counted (curve.branching_vertices, "vertex", "vertices"));
  }
  const std::vector<std::string> surface = inWords ("surface", topology.surface);
  lines.insert (lines.end (), surface.begin (), surface.end ());
  if (!topology.solid.components.empty ()) {
    lines.push_back (counted (topology.solid.components.size (), "solid") + " of " +
                     counted (topology.solid.tetrahedra, "tetrahedron", "tetrahedra"));
    const std::vector<std::string> skin = inWords ("skin of the solids", topology.solid.boundary);
    lines.insert (lines.end (), skin.begin (), skin.end ());
  }
  if (lines.empty ())
    lines.emplace_back ("nothing: no edge, triangle or tetrahedron");
  return lines;
}

} // namespace pcl::manifold::apps
