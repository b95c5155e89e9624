#pragma once

#include <array>
#include <cstddef>
#include <optional>

/** The figures of D. Dumitriu, S. Funke, M. Kutz, N. Milosavljevic, "How much geometry it takes to
 * reconstruct a 2-manifold in R^3", measured on a Pentium 4 of 3 GHz. */
namespace paper {

/** \brief A row of tables I and II. */
struct Model
{
  const char* name;
  std::size_t points;
  double octree, neighbors, landmarks, voronoi, adjacency, cycles, total; ///< seconds; total with reading
  std::size_t subsample;
};

constexpr std::array<Model, 6> MODELS = {{
  {"Bunny", 35947, 0.1, 3.4, 0.4, 0.2, 0.2, 0.1, 5.7, 868},
  {"Bone", 177907, 0.9, 20.4, 2.7, 1.7, 1.2, 0.6, 30.2, 3649},
  {"Hand", 327323, 2.1, 36.8, 4.7, 2.8, 2.3, 0.8, 53.6, 7822},
  {"Dragon", 435545, 2.9, 49.0, 6.4, 4.0, 3.5, 1.3, 72.9, 9979},
  {"Buddha", 543524, 4.1, 63.1, 8.3, 5.1, 4.2, 1.8, 93.7, 12245},
  {"Blade", 882954, 6.2, 104.3, 14.3, 8.4, 7.0, 4.7, 152.9, 20973},
}};

/** \brief The model of that many points, if the paper has one. */
inline std::optional<Model>
modelOf (std::size_t points)
{
  for (const Model& model : MODELS)
    if (model.points == points)
      return model;
  return std::nullopt;
}

/** \brief A row of table III, of the bunny. */
struct Parameters
{
  int hops, threshold;
  std::size_t faces;
  double triangles; ///< in percent; 0 where the paper does not say
  double genus;
};

constexpr std::array<Parameters, 13> BUNNY = {{
  {2, 7, 6415, 0.0, 62.5},
  {3, 7, 3199, 0.0, 5.0},
  {4, 7, 1620, 0.0, 1.0},
  {5, 7, 976, 95.3, 0.0},
  {7, 7, 457, 0.0, 1.5},
  {14, 7, 94, 0.0, 0.0},
  {15, 7, 80, 0.0, 0.0},
  {5, 2, 1024, 99.4, 43.0},
  {5, 3, 1023, 99.5, 24.0},
  {5, 6, 998, 97.3, 1.5},
  {5, 11, 898, 87.0, 0.0},
  {5, 15, 778, 73.3, 3.5},
  {5, 20, 543, 48.4, 18.5},
}};

constexpr std::size_t BUNNY_POINTS = 35947;

} // namespace paper
