// The counts of golden_counts.h: exactly what the classes make of real models, so that a change of any of
// them is seen. Where the file has faces, its topology has to be theirs: no row is of a wrong result.
#include "golden_counts.h"
#include "real_data.h"

#include <gtest/gtest.h>
#include <pcl/manifold/cocone_shape.h>
#include <pcl/manifold/fixed_point_reconstruction.h>
#include <pcl/manifold/graph_reconstruction.h>
#include <pcl/manifold/topology_report.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

pcl::SimplicialComplex
reconstruct (const std::string& name, const Cloud::ConstPtr& cloud)
{
  pcl::SimplicialComplex complex;
  if (name == "CoconeShape") {
    pcl::CoconeShape<pcl::PointXYZ> object;
    object.setInputCloud (cloud);
    object.reconstruct (complex);
  } else if (name == "FixedPoint") {
    pcl::FixedPointReconstruction<pcl::PointXYZ> object;
    object.setInputCloud (cloud);
    object.reconstruct (complex);
  } else {
    pcl::GraphReconstruction<pcl::PointXYZ> object;
    object.setInputCloud (cloud);
    std::vector<pcl::Vertices> polygons;
    object.reconstruct (polygons);
    for (const pcl::Vertices& polygon : polygons)
      complex.triangles.push_back ({polygon.vertices[0], polygon.vertices[1], polygon.vertices[2]});
  }
  return complex;
}

/** Loops and the genus of every component, the largest first: what does not depend on how dense a mesh is. */
std::string
topologyOf (const pcl::manifold::SurfaceTopology& surface)
{
  std::string text = std::to_string (surface.boundary_loops) + " loops, genus";
  std::vector<int> genera;
  for (const auto& component : surface.components)
    genera.push_back (component.genus);
  std::sort (genera.begin (), genera.end ());
  for (const int genus : genera)
    text += " " + std::to_string (genus);
  return text;
}

/** The next line that is no comment. */
std::istringstream
nextLine (std::istream& stream)
{
  std::string line;
  while (std::getline (stream, line) && line.find_first_not_of (" \t\r") == line.find ('#'))
    ;
  return std::istringstream (line);
}

/** The topology of the faces of an OFF file, a vertex or a face a line; empty for other files. */
std::string
topologyOfFaces (const std::string& file)
{
  if (file.substr (file.size () - 4) != ".off")
    return {};
  std::ifstream stream (file);
  std::size_t vertices = 0;
  std::size_t faces = 0;
  nextLine (stream); // OFF, COFF, ...
  nextLine (stream) >> vertices >> faces;
  for (std::size_t i = 0; i < vertices; ++i)
    nextLine (stream);
  pcl::manifold::FaceRows rows;
  for (std::size_t i = 0; i < faces; ++i) {
    std::istringstream line = nextLine (stream);
    int corners = 0;
    line >> corners;
    for (int corner = 0; corner < corners; ++corner) {
      rows.vertices.emplace_back ();
      line >> rows.vertices.back ();
    }
    rows.starts.push_back (rows.vertices.size ());
  }
  return topologyOf (pcl::manifold::analyze (rows).surface);
}

class GoldenCounts : public testing::TestWithParam<const char*>
{};

TEST_P (GoldenCounts, AreKept)
{
  std::istringstream row (GetParam ());
  std::string name;
  std::string model;
  row >> name >> model;
  model.pop_back (); // the colon
  const std::string file = real_data::demoFile (model);
  if (file.empty ())
    GTEST_SKIP () << model << " of libcgal-demo is not there";
  const pcl::SimplicialComplex complex = reconstruct (name, real_data::readCloud<pcl::PointXYZ> (file));
  const pcl::manifold::SurfaceTopology surface = pcl::manifold::analyze (complex).surface;
  const std::string result = name + " " + model + ": " + std::to_string (complex.triangles.size ()) +
                             " triangles, " + std::to_string (surface.edges) + " edges, " +
                             std::to_string (complex.edges.size ()) + " of curves, " + topologyOf (surface);
  std::printf ("golden \"%s\",\n", result.c_str ());
  EXPECT_EQ (result, std::string (GetParam ()));
  EXPECT_TRUE (complex.tetrahedra.empty ());
  const std::string expected = topologyOfFaces (file);
  if (!expected.empty ()) {
    EXPECT_EQ (topologyOf (surface), expected) << "not that of the faces in the file";
  }
}

INSTANTIATE_TEST_SUITE_P (Models, GoldenCounts,
                          testing::ValuesIn (std::begin (GOLDEN_COUNTS), std::end (GOLDEN_COUNTS)),
                          [] (const auto& tested) {
                            const std::string row = tested.param;
                            std::string name = row.substr (0, row.find (':'));
                            std::replace_if (
                              name.begin (), name.end (),
                              [] (unsigned char c) { return std::isalnum (c) == 0; }, '_');
                            return name;
                          });

} // namespace
