#pragma once

#include "promises_runs.h"

#include <pcl/console/print.h>
#include <pcl/manifold/simplicial_complex.h>
#include <pcl/manifold/topology_report.h>

#include <Eigen/LU>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace promises {

/** \brief Does a status leave the question open whether the input or the library is to blame? */
inline bool
isInputsFault (Status status)
{
  return status == Status::NO_INPUT || status == Status::TOO_FEW_POINTS ||
         status == Status::DIMENSION_TOO_LOW || status == Status::INPUT_TOO_COARSE ||
         status == Status::INPUT_OUT_OF_RANGE;
}

/** \brief What is wrong with how a run ended: all parameters were in range, so it is the input's fault or all
 * went well. */
inline std::string
brokenByStatus (Status status, bool empty)
{
  if (status != Status::OK && !isInputsFault (status))
    return std::string ("it ended in ") + pcl::manifold::toString (status);
  if (status != Status::OK && !empty)
    return std::string ("an output with the status ") + pcl::manifold::toString (status);
  return {};
}

/** \brief Is there an edge that two triangles run along in the same direction, in a surface whose components are
 * all orientable? */
inline bool
isInconsistent (const std::vector<pcl::SimplicialComplex::Triangle>& triangles)
{
  std::set<std::pair<int, int>> seen;
  for (const auto& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (!seen.insert ({triangle[i], triangle[(i + 1) % 3]}).second)
        return true;
  return false;
}

inline std::string
brokenBySurface (const pcl::manifold::SurfaceTopology& surface, const std::string& what)
{
  if (surface.non_manifold_edges > 0)
    return what + ": edges of more than two triangles";
  if (surface.non_manifold_vertices > 0)
    return what + ": vertices that are in no disc";
  if (surface.duplicate_faces > 0)
    return what + ": a triangle twice";
  return {};
}

/** \brief What is promised of every complex over the points of a case. */
inline std::string
brokenByComplex (const Case& input, const pcl::SimplicialComplex& complex)
{
  std::string why;
  if (!pcl::manifold::isValid (complex, input.points.size (), &why))
    return why;
  const auto point = [&input] (pcl::index_t i) { return input.points[static_cast<std::size_t> (i)]; };
  const auto allFinite = [&point] (const auto& simplices) {
    return std::all_of (simplices.begin (), simplices.end (), [&] (const auto& simplex) {
      return std::all_of (simplex.begin (), simplex.end (),
                          [&] (pcl::index_t i) { return point (i).allFinite (); });
    });
  };
  if (!allFinite (complex.edges) || !allFinite (complex.triangles) || !allFinite (complex.tetrahedra))
    return "a simplex with a vertex that is not finite";

  const pcl::TopologyReport report = pcl::manifold::analyze (complex);
  if (report.curve.branching_vertices > 0 || report.curve.duplicate_edges > 0)
    return "a curve that branches";
  if (const std::string broken = brokenBySurface (report.surface, "surface"); !broken.empty ())
    return broken;
  if (report.solid.non_manifold_triangles > 0)
    return "a triangle of more than two tetrahedra";
  if (const std::string broken = brokenBySurface (report.solid.boundary, "skin of the solids");
      !broken.empty ())
    return broken;
  const auto& components = report.surface.components;
  if (std::all_of (components.begin (), components.end (), [] (const auto& c) { return c.orientable; }) &&
      isInconsistent (complex.triangles))
    return "an orientable surface that is not consistently oriented";
  if (isInconsistent (pcl::manifold::boundaryTriangles (complex.tetrahedra)))
    return "tetrahedra that are not positively oriented";
  return {};
}

template <std::size_t N>
void
append (Rows& rows, const std::vector<std::array<pcl::index_t, N>>& simplices)
{
  for (const auto& simplex : simplices)
    rows.emplace_back (simplex.begin (), simplex.end ());
}

inline Outcome
outcomeOf (Status status, const pcl::SimplicialComplex& complex)
{
  Outcome outcome;
  outcome.status = status;
  append (outcome.simplices, complex.edges);
  append (outcome.simplices, complex.triangles);
  append (outcome.simplices, complex.tetrahedra);
  return outcome;
}

/** \brief What is asked of the labels of one run. */
inline std::string
brokenByLabels (const Case& input, const pcl::DimensionDetection<pcl::PointXYZ>& object,
                const Outcome& outcome)
{
  const std::size_t n = input.points.size ();
  if (object.getStatus () != Status::OK)
    return object.getManifoldDimension ().empty () && object.getSamples ().empty ()
             ? ""
             : "getters after a failure";
  if (outcome.values.size () != n)
    return "not one label a point";
  for (std::size_t i = 0; i < n; ++i) {
    const std::vector<double>& value = outcome.values[i];
    if (value[0] < 0 || value[0] > 3 || value[1] < 0 || value[1] > 3 || value[2] < 0 || value[2] > 1)
      return "a label out of range";
    if (!(value[3] >= 0.0 && value[3] <= 1.0))
      return "a confidence out of [0, 1]";
    if (!input.points[i].allFinite () && value[0] + value[1] != 0)
      return "a label for a point that is not finite";
  }
  for (const pcl::index_t sample : object.getSamples ())
    if (sample < 0 || static_cast<std::size_t> (sample) >= n ||
        !input.points[static_cast<std::size_t> (sample)].allFinite ())
      return "a sample that is no finite point";
  return {};
}

inline std::string
brokenDimensions (const Case& input)
{
  return brokenByThreadsOrOrder (input, [] (const Case& given, unsigned int threads, std::string* broken) {
    pcl::DimensionDetection<pcl::PointXYZ> object;
    setUp (object, given);
    object.setNumberOfThreads (threads);
    object.setInputCloud (cloudOf (given.points));
    pcl::PointCloud<pcl::Label> labels;
    object.compute (labels);
    Outcome outcome;
    outcome.status = object.getStatus ();
    const auto dimension = object.getManifoldDimension ();
    const auto boundary = object.getBoundary ();
    const auto confidence = object.getConfidence ();
    for (std::size_t i = 0; i < labels.size (); ++i)
      outcome.values.push_back (
        {static_cast<double> (labels[i].label), static_cast<double> (dimension.at (i)),
         static_cast<double> (boundary.at (i)), static_cast<double> (confidence.at (i))});
    if (broken != nullptr) {
      *broken = brokenByStatus (object.getStatus (), labels.empty ());
      if (broken->empty ())
        *broken = brokenByLabels (given, object, outcome);
    }
    return outcome;
  });
}

/** \brief For the two classes that give a complex.
 * \param[in] never_empty is something found where all went well? */
template <typename Class>
std::string
brokenComplex (const Case& input, bool never_empty)
{
  const auto run = [never_empty] (const Case& given, unsigned int threads, std::string* broken) {
    Class object;
    setUp (object, given);
    object.setNumberOfThreads (threads);
    object.setInputCloud (cloudOf (given.points));
    pcl::SimplicialComplex complex;
    object.reconstruct (complex);
    if (broken != nullptr) {
      *broken = brokenByStatus (object.getStatus (), complex.empty ());
      if (broken->empty () && never_empty && object.getStatus () == Status::OK && complex.empty ())
        *broken = "nothing with the status OK";
      if (broken->empty ())
        *broken = brokenByComplex (given, complex);
      // Samples in a plane enclose nothing.
      const auto triangulation = object.getDelaunayComplex ();
      if (broken->empty () && given.watertight && triangulation && triangulation->affine_dimension == 3 &&
          !pcl::manifold::analyze (complex).surface.isClosed ())
        *broken = "a watertight surface with a boundary";
    }
    return outcomeOf (object.getStatus (), complex);
  };
  return brokenByThreadsOrOrder (input, run);
}

/** \brief What is asked of a landmark mesh and of the polygons that came of it. */
inline std::string
brokenByLandmarks (const Case& input, const pcl::GraphReconstruction<pcl::PointXYZ>& object,
                   const std::vector<pcl::Vertices>& polygons)
{
  const auto isPoint = [&input] (pcl::index_t i) {
    return i >= 0 && static_cast<std::size_t> (i) < input.points.size () &&
           input.points[static_cast<std::size_t> (i)].allFinite ();
  };
  const pcl::Indices landmarks = object.getLandmarks ();
  const std::set<pcl::index_t> known (landmarks.begin (), landmarks.end ());
  if (!std::all_of (landmarks.begin (), landmarks.end (), isPoint))
    return "a landmark that is no finite point";
  for (const pcl::Vertices& polygon : polygons) {
    if (polygon.vertices.size () < 3 || (input.triangulate && polygon.vertices.size () != 3))
      return "a polygon of the wrong size";
    for (const pcl::index_t vertex : polygon.vertices)
      if (known.count (vertex) == 0)
        return "a polygon with a vertex that is no landmark";
  }
  const auto tiles = object.getTiles ();
  if (object.getStatus () == Status::OK && tiles.size () != input.points.size ())
    return "not one tile a point";
  for (std::size_t i = 0; i < tiles.size (); ++i)
    if (input.points[i].allFinite ()
          ? tiles[i] < 0 || static_cast<std::size_t> (tiles[i]) >= landmarks.size ()
          : tiles[i] != -1)
      return "a point with a wrong tile";
  if (object.getReport ().surface.non_manifold_edges > 0)
    return "an edge of the landmark mesh in more than two faces";
  return {};
}

inline std::string
brokenGraph (const Case& input)
{
  return brokenByThreadsOrOrder (input, [] (const Case& given, unsigned int threads, std::string* broken) {
    pcl::GraphReconstruction<pcl::PointXYZ> object;
    setUp (object, given);
    object.setNumberOfThreads (threads);
    object.setInputCloud (cloudOf (given.points));
    std::vector<pcl::Vertices> polygons;
    object.reconstruct (polygons);
    Outcome outcome;
    outcome.status = object.getStatus ();
    for (const pcl::Vertices& polygon : polygons)
      outcome.simplices.emplace_back (polygon.vertices.begin (), polygon.vertices.end ());
    if (broken != nullptr) {
      *broken = brokenByStatus (object.getStatus (), polygons.empty ());
      if (broken->empty () && object.getStatus () == Status::OK && polygons.empty ())
        *broken = "nothing with the status OK";
      if (broken->empty ())
        *broken = brokenByLandmarks (given, object, polygons);
    }
    return outcome;
  });
}

/** \brief Runs all classes on a case.
 * \return the promises that were broken, one line each; nothing where all is well */
inline std::string
broken (const Case& input)
{
  // A failure is no news here.
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  std::string all;
  const auto say = [&all] (const char* name, const std::string& text) {
    if (!text.empty ())
      all += std::string (name) + ": " + text + "\n";
  };
  say ("DimensionDetection", brokenDimensions (input));
  say ("CoconeShape", brokenComplex<pcl::CoconeShape<pcl::PointXYZ>> (input, false));
  say ("FixedPointReconstruction", brokenComplex<pcl::FixedPointReconstruction<pcl::PointXYZ>> (input, true));
  say ("GraphReconstruction", brokenGraph (input));
  return all;
}

} // namespace promises
