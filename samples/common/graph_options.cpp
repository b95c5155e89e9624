#include "graph_options.h"

#include "app_error.h"

#include <array>
#include <utility>

namespace pcl::manifold::apps {
namespace {

constexpr std::array<std::pair<const char*, AdjacencyRule>, 3> ADJACENCY_RULES = {{
  {"points", AdjacencyRule::BOUNDARY_POINTS},
  {"edges", AdjacencyRule::LINKING_EDGES},
  {"path", AdjacencyRule::CLEAR_PATH},
}};

constexpr std::array<std::pair<const char*, FaceRule>, 2> FACE_RULES = {{
  {"rotation", FaceRule::ROTATION_SYSTEM},
  {"cycles", FaceRule::SHORTEST_CYCLES},
}};

template <typename Rules, typename Rule>
void
findRule (const std::string& option, const std::string& name, const Rules& rules, Rule& rule)
{
  std::string known;
  for (const auto& [word, value] : rules) {
    if (name == word) {
      rule = value;
      return;
    }
    known += (known.empty () ? "" : ", ") + std::string (word);
  }
  throw UsageError (option, "'" + name + "' is none of " + known);
}

template <typename Rules, typename Rule>
std::string
findName (const Rules& rules, Rule rule)
{
  for (const auto& [word, value] : rules)
    if (value == rule)
      return word;
  return {};
}

} // namespace

void
GraphOptions::declare (CommandLine& command_line)
{
  command_line
    .option ("k", "k", "neighbours of each point in the neighbourhood graph", parameters.k_search,
             {1, 100000})
    .option ("hops", "k", "least distance of two landmarks in hops: the larger, the coarser the mesh",
             parameters.hops, {1, 100000})
    .flag ("uniform",
           "that distance everywhere, as published: no more landmarks on thin parts and small surfaces",
           uniform_)
    .option ("a", "a", "tiles that touch by more than this are adjacent", parameters.adjacency_threshold,
             {0, 1e9})
    .option ("rule", "rule",
             "what is compared with it: points (of the border), edges (linking both tiles);\n"
             "or path: a path between the landmarks that stays clear of all other tiles",
             rule_)
    .option ("faces", "rule",
             "rotation: by the order of the tiles along each tile's border;\n"
             "cycles: shortest cycles first, as published",
             faces_)
    .option ("maxlength", "n", "edges of the largest face; a longer cycle bounds a hole",
             parameters.maximum_face_length, {3, 1000000})
    .flag ("polygons", "leave larger faces as they are instead of cutting them into triangles", polygons_)
    .option ("seed", "n", "chooses between the many sets of landmarks", parameters.seed);
}

void
GraphOptions::complete ()
{
  findRule ("-rule", rule_, ADJACENCY_RULES, parameters.adjacency_rule);
  findRule ("-faces", faces_, FACE_RULES, parameters.face_rule);
  parameters.refine = !uniform_;
  parameters.triangulate = !polygons_;
  parameters.threads = static_cast<unsigned int> (common.threads);
}

void
GraphOptions::describe (Report& report) const
{
  report.parameter ("k", parameters.k_search);
  report.parameter ("hops", parameters.hops);
  report.parameter ("uniform", !parameters.refine);
  report.parameter ("a", parameters.adjacency_threshold);
  report.parameter ("rule", nameOf (parameters.adjacency_rule));
  report.parameter ("faces", nameOf (parameters.face_rule));
  report.parameter ("maxlength", parameters.maximum_face_length);
  report.parameter ("polygons", !parameters.triangulate);
  report.parameter ("seed", Json::UInt64 (parameters.seed));
  report.parameter ("threads", common.threads);
}

std::string
nameOf (AdjacencyRule rule)
{
  return findName (ADJACENCY_RULES, rule);
}

std::string
nameOf (FaceRule rule)
{
  return findName (FACE_RULES, rule);
}

} // namespace pcl::manifold::apps
