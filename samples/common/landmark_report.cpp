#include "landmark_report.h"

#include <sstream>

namespace pcl::manifold::apps {
namespace {

Json::Value
count (std::size_t number)
{
  return Json::UInt64 (number);
}

Json::Value
toJson (const LandmarkComponent& component)
{
  Json::Value json (Json::objectValue);
  json["landmarks"] = count (component.vertices);
  json["edges"] = count (component.edges);
  json["faces"] = count (component.faces);
  json["triangles"] = count (component.triangles);
  json["edges_in_no_face"] = count (component.edges_in_no_face);
  json["edges_in_one_face"] = count (component.edges_in_one_face);
  json["edges_in_two_faces"] = count (component.edges_in_two_faces);
  json["edges_in_more_faces"] = count (component.edges_in_more_faces);
  json["boundary_loops"] = count (component.boundary_loops);
  json["orientable"] = component.orientable;
  json["genus_by_formula"] = component.genus ();
  json["genus"] =
    component.isClosed () && component.orientable ? Json::Value (component.genus ()) : Json::Value ();
  return json;
}

} // namespace

std::string
genusText (double genus)
{
  std::ostringstream text;
  text << genus;
  return text.str ();
}

void
describeLandmarks (const LandmarkMeshReport& mesh, Report& report, Table& table)
{
  Json::Value total_json = toJson (mesh.total);
  if (mesh.components.size () != 1)
    total_json["genus"] = Json::Value ();
  report.result ("landmark_mesh", total_json);
  Json::Value components (Json::arrayValue);
  for (const LandmarkComponent& component : mesh.components)
    components.append (toJson (component));
  report.result ("components", components);

  const LandmarkComponent& total = mesh.total;
  if (total.edges_in_no_face > 0)
    report.say (
      {grouped (total.edges_in_no_face) + " of the edges in no face: curves, or parts thinner than a tile"});
  table.row ("landmarks", total.vertices);
  table.row ("adjacencies", total.edges);
  table.row ("faces", grouped (total.faces) + ", of them " + grouped (total.triangles) + " triangles");
  table.row ("edges in 0, 1, 2 faces", grouped (total.edges_in_no_face) + ", " +
                                         grouped (total.edges_in_one_face) + ", " +
                                         grouped (total.edges_in_two_faces));
  if (total.edges_in_more_faces > 0)
    table.row ("edges in more faces", total.edges_in_more_faces);
  table.row ("components", mesh.components.size ());
  table.row ("boundary loops", total.boundary_loops);
  if (mesh.components.size () == 1)
    table.row (total.isClosed () && total.orientable ? "genus" : "genus by n - e + f = 2 - 2g",
               genusText (total.genus ()) + (total.orientable ? "" : " (not orientable)") +
                 (total.boundary_loops > 0 ? ", to which every loop adds a half" : ""));
}

} // namespace pcl::manifold::apps
