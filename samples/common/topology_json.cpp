#include "topology_json.h"

#include "summary.h"

namespace pcl::manifold::apps {

namespace {

Json::Value
count (std::size_t number)
{
  return Json::UInt64 (number);
}

Json::Value
toJson (const SurfaceComponent& component)
{
  Json::Value json (Json::objectValue);
  json["faces"] = count (component.faces);
  json["vertices"] = count (component.vertices);
  json["edges"] = count (component.edges);
  json["boundary_edges"] = count (component.boundary_edges);
  json["boundary_loops"] = count (component.boundary_loops);
  json["non_manifold_edges"] = count (component.non_manifold_edges);
  json["non_manifold_vertices"] = count (component.non_manifold_vertices);
  json["euler_characteristic"] = Json::Int64 (component.euler_characteristic);
  json["closed"] = component.closed;
  json["orientable"] = component.orientable;
  json["genus"] = component.genus < 0 ? Json::Value () : Json::Value (component.genus);
  return json;
}

Json::Value
toJson (const CurveTopology& curve)
{
  Json::Value json (Json::objectValue);
  json["edges"] = count (curve.edges);
  json["vertices"] = count (curve.vertices);
  json["end_vertices"] = count (curve.end_vertices);
  json["branching_vertices"] = count (curve.branching_vertices);
  json["components"] = Json::Value (Json::arrayValue);
  for (const CurveComponent& component : curve.components) {
    Json::Value entry (Json::objectValue);
    entry["edges"] = count (component.edges);
    entry["vertices"] = count (component.vertices);
    entry["closed"] = component.closed;
    json["components"].append (entry);
  }
  return json;
}

Json::Value
toJson (const SolidTopology& solid)
{
  Json::Value json (Json::objectValue);
  json["tetrahedra"] = count (solid.tetrahedra);
  json["vertices"] = count (solid.vertices);
  json["non_manifold_triangles"] = count (solid.non_manifold_triangles);
  json["components"] = count (solid.components.size ());
  json["boundary"] = surfaceJson (solid.boundary);
  return json;
}

} // namespace

Json::Value
surfaceJson (const SurfaceTopology& surface)
{
  Json::Value json (Json::objectValue);
  json["faces"] = count (surface.faces);
  json["triangles"] = count (surface.triangles);
  json["vertices"] = count (surface.vertices);
  json["edges"] = count (surface.edges);
  json["boundary_edges"] = count (surface.boundary_edges);
  json["boundary_loops"] = count (surface.boundary_loops);
  json["non_manifold_edges"] = count (surface.non_manifold_edges);
  json["non_manifold_vertices"] = count (surface.non_manifold_vertices);
  json["euler_characteristic"] = Json::Int64 (surface.euler_characteristic);
  json["components"] = Json::Value (Json::arrayValue);
  for (const SurfaceComponent& component : surface.components)
    json["components"].append (toJson (component));
  return json;
}

void
describeTopology (const pcl::TopologyReport& topology, std::size_t samples, Report& report, Table& table)
{
  report.result ("vertices", count (topology.vertices));
  report.result ("curves", toJson (topology.curve));
  report.result ("surfaces", surfaceJson (topology.surface));
  report.result ("solids", toJson (topology.solid));
  report.say (inWords (topology));
  if (samples > topology.vertices)
    report.say ({grouped (samples - topology.vertices) + " of " + grouped (samples) + " samples in no part"});
  table.row ("vertices used", topology.vertices);
  if (topology.curve.edges > 0)
    table.row ("curve edges", topology.curve.edges);
  if (topology.surface.faces > 0) {
    table.row ("surface triangles", topology.surface.faces);
    table.row ("surface Euler characteristic", std::to_string (topology.surface.euler_characteristic));
  }
  if (topology.solid.tetrahedra > 0) {
    table.row ("solid tetrahedra", topology.solid.tetrahedra);
    table.row ("skin triangles", topology.solid.boundary.faces);
    table.row ("skin Euler characteristic", std::to_string (topology.solid.boundary.euler_characteristic));
  }
}

} // namespace pcl::manifold::apps
