#include "graph/landmarks/landmark_balls.h"

#include <algorithm>

namespace pcl {
namespace manifold {

void
findBall (const NeighborhoodGraph& graph, const std::vector<int>& hops_to_landmark, pcl::index_t center,
          int hops, std::vector<std::uint8_t>& seen, LandmarkBall& ball)
{
  ball.vertices.assign (1, center);
  ball.ends.assign (1, 1);
  seen[center] = 1;
  std::size_t next = 0;
  for (int hop = 1; hop < hops && next < ball.vertices.size (); ++hop) {
    for (const std::size_t end = ball.vertices.size (); next < end; ++next) {
      const pcl::index_t v = ball.vertices[next];
      for (const pcl::index_t* w = graph.begin (v); w != graph.end (v); ++w)
        if (!seen[*w] && hops_to_landmark[*w] > hop) {
          seen[*w] = 1;
          ball.vertices.push_back (*w);
        }
    }
    ball.ends.push_back (ball.vertices.size ());
  }
  for (const pcl::index_t v : ball.vertices)
    seen[v] = 0;
}

void
addLandmark (const LandmarkBall& ball, std::vector<int>& hops_to_landmark)
{
  std::size_t i = 0;
  for (std::size_t hop = 0; hop < ball.ends.size (); ++hop)
    for (; i < ball.ends[hop]; ++i)
      hops_to_landmark[ball.vertices[i]] =
        std::min (hops_to_landmark[ball.vertices[i]], static_cast<int> (hop));
}

} // namespace manifold
} // namespace pcl
