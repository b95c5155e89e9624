#include "landmark_report.h"

#include "topology_json.h"

namespace pcl::manifold::apps {

void
describeLandmarks (std::size_t landmarks, const pcl::TopologyReport& mesh, Report& report, Table& table)
{
  const std::size_t edges = mesh.curve.edges + mesh.surface.edges;
  Json::Value json (Json::objectValue);
  json["landmarks"] = Json::UInt64 (landmarks);
  json["edges"] = Json::UInt64 (edges);
  json["edges_in_no_face"] = Json::UInt64 (mesh.curve.edges);
  json["surfaces"] = surfaceJson (mesh.surface);
  report.result ("landmark_mesh", json);
  if (mesh.curve.edges > 0)
    report.say (
      {grouped (mesh.curve.edges) + " of the edges in no face: curves, or parts thinner than a tile"});
  table.row ("landmarks", landmarks);
  table.row ("adjacencies", edges);
  table.row ("faces",
             grouped (mesh.surface.faces) + ", of them " + grouped (mesh.surface.triangles) + " triangles");
}

} // namespace pcl::manifold::apps
