#pragma once

#include "oracle_graph.h"

#include <pcl/manifold/graph_faces.h>

#include <array>
#include <string>
#include <vector>

namespace oracle {

/** \brief A surface of triangles. As a graph of its edges, in which every vertex is a landmark with a tile of
 * its own, all of its faces are known. */
struct Tiling
{
  std::string name;
  int vertices;
  std::vector<std::array<index_t, 3>> triangles;
  int euler;
  int loops = 0;
  bool orientable = true;

  EdgeSet edges () const
  {
    EdgeSet edges;
    for (const auto& t : triangles)
      for (std::size_t i = 0; i < 3; ++i)
        edges.insert (std::minmax (t[i], t[(i + 1) % 3]));
    return edges;
  }
};

/** \brief A grid of width x height squares with a diagonal each. Where it is closed, a side is glued to the
 * opposite one, that of the columns mirrored if wanted. */
inline Tiling
gridTiling (const std::string& name, int width, int height, bool closed_rows, bool closed_columns,
            bool mirrored)
{
  const int columns = width + (closed_rows ? 0 : 1);
  const int rows = height + (closed_columns ? 0 : 1);
  const auto vertexAt = [&] (int x, int y) {
    if (closed_columns && y == height) {
      y = 0;
      if (mirrored)
        x = closed_rows ? (width - x) % width : width - x;
    }
    return static_cast<index_t> (y * columns + (closed_rows ? x % width : x));
  };
  Tiling tiling{name, columns * rows, {}, 0};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const index_t a = vertexAt (x, y), b = vertexAt (x + 1, y);
      const index_t c = vertexAt (x + 1, y + 1), d = vertexAt (x, y + 1);
      tiling.triangles.push_back ({a, b, c});
      tiling.triangles.push_back ({a, c, d});
    }
  tiling.orientable = !mirrored;
  tiling.loops = closed_rows && closed_columns ? 0 : closed_rows || closed_columns ? 2 : 1;
  if (mirrored && !closed_rows)
    tiling.loops = 1;
  tiling.euler = !closed_rows && !closed_columns ? 1 : 0;
  return tiling;
}

/** \brief A polyhedron of triangles with every triangle cut into n x n. */
inline Tiling
subdivided (const std::string& name, const std::vector<std::array<int, 3>>& triangles, int n, int euler)
{
  Tiling tiling{name, 0, {}, euler};
  // A point of a triangle is known by its weights, n in all, at the corners.
  std::map<std::map<int, int>, index_t> numbers;
  for (const auto& t : triangles) {
    const auto vertexAt = [&] (int i, int j) {
      std::map<int, int> weights{{t[0], n - i - j}, {t[1], i}, {t[2], j}};
      for (auto it = weights.begin (); it != weights.end ();)
        it = it->second == 0 ? weights.erase (it) : std::next (it);
      return numbers.emplace (weights, static_cast<index_t> (numbers.size ())).first->second;
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        tiling.triangles.push_back ({vertexAt (i, j), vertexAt (i + 1, j), vertexAt (i, j + 1)});
        if (i + j + 1 < n)
          tiling.triangles.push_back ({vertexAt (i + 1, j), vertexAt (i + 1, j + 1), vertexAt (i, j + 1)});
      }
  }
  tiling.vertices = static_cast<int> (numbers.size ());
  return tiling;
}

inline Tiling
sphereTiling (int n)
{
  return subdivided (
    "sphere", {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}}, n, 2);
}

/** \brief The six vertices of the projective plane's smallest triangulation, cut finer. */
inline Tiling
projectivePlaneTiling (int n)
{
  Tiling tiling = subdivided ("projective plane",
                              {{0, 1, 2},
                               {0, 2, 3},
                               {0, 3, 4},
                               {0, 4, 5},
                               {0, 5, 1},
                               {1, 2, 4},
                               {2, 3, 5},
                               {3, 4, 1},
                               {4, 5, 2},
                               {5, 1, 3}},
                              n, 1);
  tiling.orientable = false;
  return tiling;
}

inline std::vector<Tiling>
tilings ()
{
  return {sphereTiling (4),
          sphereTiling (9),
          gridTiling ("torus", 7, 9, true, true, false),
          gridTiling ("long torus", 6, 40, true, true, false),
          gridTiling ("Klein bottle", 9, 12, true, true, true),
          projectivePlaneTiling (6),
          gridTiling ("disc", 12, 9, false, false, false),
          gridTiling ("annulus", 14, 6, true, false, false),
          gridTiling ("Moebius band", 6, 20, false, true, true)};
}

/** \brief The tiles, every vertex its own, and their contacts, all of them adjacent. */
struct TiledGraph
{
  NeighborhoodGraph graph;
  std::vector<index_t> tiles;
  std::vector<TileContact> contacts;

  TiledGraph (int vertices, const EdgeSet& edges) : graph (graphOfEdges (vertices, edges))
  {
    for (index_t v = 0; v < graph.size (); ++v)
      tiles.push_back (v);
    contacts = tileContacts (graph, tiles, tiles, pcl::manifold::AdjacencyRule::BOUNDARY_POINTS, 0, 1);
  }

  pcl::manifold::LandmarkMesh findFaces (pcl::manifold::FaceRule rule, int maximum_length,
                                         unsigned int threads = 1) const
  {
    return pcl::manifold::findFaces (graph, tiles, tiles.size (), contacts, rule, maximum_length, threads);
  }
};

} // namespace oracle
