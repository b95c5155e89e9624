#pragma once

#include "test_apps_clouds.h"
#include "test_apps_run.h"

#include <json/json.h>
#include <pcl/conversions.h>
#include <pcl/manifold/complex_io.h>
#include <pcl/manifold/topology_report.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

/** Apps on clouds of the kinds that users of other tools reported, and what is expected of them. */
namespace field_case {

/** \brief What an app left. */
struct Result
{
  apps_run::Outcome outcome;
  std::string file;               ///< its output
  pcl::SimplicialComplex complex; ///< of a mesh, tetrahedra by their boundary
  pcl::PointCloud<pcl::PointXYZ> points;
  pcl::TopologyReport topology; ///< of the complex
  Json::Value report;           ///< "result" of the report
};

/** \brief Says what is not as expected; nothing where all is. */
using Expectation = std::function<std::string (const Result&)>;

/** \brief Runs an app: the dimension of every point to a PCD file, or a mesh to a PLY file. */
inline Result
run (const TestFolder& folder, const std::string& app, const std::string& input, bool mesh)
{
  Result result;
  result.file = folder / (mesh ? "out.ply" : "out.pcd");
  const std::string report = folder / "report.json";
  result.outcome =
    apps_run::run (folder, app, "'" + input + "' '" + result.file + "' -quiet -report '" + report + "'");
  if (result.outcome.exit_status != 0)
    return result;
  std::ifstream stream (report);
  Json::Value all;
  stream >> all;
  result.report = all["result"];
  if (mesh) {
    std::string error;
    pcl::PCLPointCloud2 cloud;
    EXPECT_TRUE (pcl::manifold::loadComplex (result.file, cloud, result.complex, error)) << error;
    pcl::fromPCLPointCloud2 (cloud, result.points);
    result.topology = pcl::manifold::analyze (result.complex);
  }
  return result;
}

/** \brief The expectation of a run that ends well. */
inline Expectation
done (const Expectation& expectation)
{
  return [expectation] (const Result& result) {
    return result.outcome.exit_status == 0 ? expectation (result) : "failed: " + result.outcome.error;
  };
}

/** \brief One line on standard error, the exit status 1, and no output. */
inline Expectation
fails ()
{
  return [] (const Result& result) -> std::string {
    const std::string& error = result.outcome.error;
    const bool one_line =
      error.rfind ("error: ", 0) == 0 && std::count (error.begin (), error.end (), '\n') == 1;
    if (result.outcome.exit_status == 1 && one_line && !std::filesystem::exists (result.file))
      return {};
    return "ended with " + std::to_string (result.outcome.exit_status) + ", saying: " + error;
  };
}

/** \brief A manifold surface of orientable components, no curves and no solids.
 * \param[in] genus of the largest component */
inline Expectation
surface (std::size_t components, std::size_t loops, int genus)
{
  return done ([=] (const Result& result) -> std::string {
    const pcl::manifold::SurfaceTopology& found = result.topology.surface;
    const bool orientable = std::all_of (found.components.begin (), found.components.end (),
                                         [] (const auto& component) { return component.orientable; });
    if (found.components.size () == components && found.boundary_loops == loops && found.isManifold () &&
        orientable && found.components[0].genus == genus && result.complex.edges.empty () &&
        result.report["solids"]["tetrahedra"].asInt () == 0)
      return {};
    return std::to_string (found.components.size ()) + " components, " +
           std::to_string (found.boundary_loops) + " loops, " + (orientable ? "" : "one-sided, ") +
           std::to_string (found.non_manifold_edges) + " non-manifold edges, " +
           std::to_string (result.complex.edges.size ()) + " edges of curves";
  });
}

/** \brief Polylines, none of whose edges is longer than this. */
inline Expectation
polylines (std::size_t components, float longest)
{
  return done ([=] (const Result& result) -> std::string {
    float length = 0.0f;
    for (const auto& edge : result.complex.edges)
      length = std::max (length, (result.points[static_cast<std::size_t> (edge[0])].getVector3fMap () -
                                  result.points[static_cast<std::size_t> (edge[1])].getVector3fMap ())
                                   .norm ());
    if (result.topology.curve.components.size () == components && length <= longest)
      return {};
    return std::to_string (result.topology.curve.components.size ()) + " polylines, the longest edge " +
           std::to_string (length);
  });
}

/** \brief Solids with skins of these genera, in ascending order, no surfaces, and a volume up to this: not less
 * than 0.72 of it, because a skin runs through the outermost points. */
inline Expectation
solid (const std::vector<int>& genera, double volume)
{
  return done ([=] (const Result& result) -> std::string {
    std::vector<int> found;
    for (const auto& component : result.topology.surface.components)
      found.push_back (component.genus);
    std::sort (found.begin (), found.end ());
    double inside = 0.0;
    const auto point = [&result] (pcl::index_t i) {
      return result.points[static_cast<std::size_t> (i)].getVector3fMap ().cast<double> ();
    };
    for (const auto& t : result.complex.triangles)
      inside += point (t[0]).dot (point (t[1]).cross (point (t[2]))) / 6.0;
    const int sheets = result.report["surfaces"]["triangles"].asInt ();
    if (found == genera && sheets == 0 && inside >= 0.72 * volume && inside <= volume)
      return {};
    return std::to_string (found.size ()) + " skins, " + std::to_string (sheets) +
           " triangles of surfaces, volume " + std::to_string (inside);
  });
}

/** \brief The output has these fields. */
inline Expectation
fields (const std::vector<std::string>& names)
{
  return done ([=] (const Result& result) {
    const pcl::PCLPointCloud2 cloud = pcl::manifold::apps::readCloud (result.file).cloud;
    std::string missing;
    for (const std::string& name : names)
      if (pcl::manifold::findField (cloud, name) == nullptr)
        missing += " " + name;
    return missing.empty () ? missing : "missing fields:" + missing;
  });
}

/** \brief The output's first bytes hold this text. */
inline Expectation
header (const std::string& text)
{
  return done ([=] (const Result& result) {
    std::string head (1000, '\0');
    std::ifstream (result.file, std::ios::binary).read (head.data (), 1000);
    return contains (head, text) ? std::string () : "not in the header: " + text;
  });
}

/** \brief At least this share of the points has a manifold dimension that is its field "label". */
inline Expectation
labels (double share)
{
  return done ([=] (const Result& result) -> std::string {
    const pcl::PCLPointCloud2 cloud = pcl::manifold::apps::readCloud (result.file).cloud;
    const std::size_t n = static_cast<std::size_t> (cloud.width) * cloud.height;
    std::size_t right = 0;
    for (std::size_t i = 0; i < n; ++i)
      right += pcl::manifold::apps::valueAt (cloud, "manifold_dimension", i) ==
                   pcl::manifold::apps::valueAt (cloud, "label", i)
                 ? 1
                 : 0;
    if (static_cast<double> (right) >= share * static_cast<double> (n))
      return {};
    return std::to_string (right) + " of " + std::to_string (n) + " labels are right";
  });
}

/** \brief One of two expectations. */
inline Expectation
either (const Expectation& one, const Expectation& other)
{
  return [=] (const Result& result) {
    const std::string complaint = one (result);
    return complaint.empty () || other (result).empty () ? std::string () : complaint;
  };
}

} // namespace field_case
