#include <pcl/manifold/graph_voronoi.h>

#include "common/large_pages.h"
#include "common/parallel.h"
#include "graph/landmarks/hop_rings.h"
#include "graph/landmarks/landmark_balls.h"
#include "graph/landmarks/priority.h"
#include "graph/landmarks/tile_rings.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

constexpr std::size_t LANDMARKS_PER_TASK = 16;

// Tiles of landmarks nearer to each other than this are so small that chance decides which of them touch.
constexpr int FEWEST_HOPS = 3;

// Smaller disks ask for no fewer hops.
constexpr int SMALLEST_RADIUS = 4;

// A surface whose disks have this radius is told by landmarks at so many hops from each other.
int
hopsForRadius (int radius)
{
  return std::max (FEWEST_HOPS, radius / 8 * 5 + radius % 8 * 5 / 8);
}

// The radius that is enough for landmarks at so many hops.
int
radiusForHops (int hops)
{
  return hops + hops / 5 * 3 + (hops % 5 * 3 + 4) / 5;
}

// How far around a landmark with too small a disk there may be others.
int
reachForHops (int hops)
{
  return hops - 2 * (hops / 5) - 2 * (hops % 5) / 5;
}

class Refinement
{
public:
  Refinement (const NeighborhoodGraph& graph, int hops, std::uint64_t seed,
              const std::vector<pcl::index_t>& landmarks, const std::vector<pcl::index_t>& tiles)
    : graph_ (graph), hops_ (hops), seed_ (seed), landmarks_ (landmarks), tiles_ (tiles),
      rings_ ([&graph] { return HopRings (graph); })
  {}

  /** Looks at some landmarks, adds others around them, looks at those, and so on.
   * \param[in] doubtful landmarks to look at
   * \param[in] crowded landmarks around which others are added without a look
   * \return the added ones */
  std::vector<pcl::index_t> run (std::vector<pcl::index_t> doubtful, const std::vector<pcl::index_t>& crowded)
  {
    for (const pcl::index_t landmark : crowded)
      lowerAround (landmark, FEWEST_HOPS);
    std::vector<pcl::index_t> added;
    std::vector<int> wanted;
    while (!doubtful.empty () || !candidates_.empty ()) {
      wanted.resize (doubtful.size ());
      parallelFor (
        doubtful.size (),
        [&] (std::size_t i) {
          wanted[i] = hopsForRadius (
            rings_.local ().radiusOfDisk (doubtful[i], SMALLEST_RADIUS, radiusForHops (hops_)));
        },
        LANDMARKS_PER_TASK);
      for (std::size_t i = 0; i < doubtful.size (); ++i)
        if (wanted[i] < hops_)
          lowerAround (doubtful[i], wanted[i]);
      doubtful = newLandmarks ();
      added.insert (added.end (), doubtful.begin (), doubtful.end ());
    }
    return added;
  }

private:
  // What is needed once there is something to add.
  void begin ()
  {
    assignLarge (seen_, tiles_.size (), std::uint8_t (0));
    assignLarge (allowed_, tiles_.size (), hops_);
    assignLarge (hops_to_landmark_, tiles_.size (), UNREACHED);
  }

  // Allows landmarks around one at so many hops from others.
  void lowerAround (pcl::index_t landmark, int wanted)
  {
    if (seen_.empty ())
      begin ();
    const int reach = reachForHops (hops_);
    std::vector<pcl::index_t>& ball = ball_.vertices;
    ball.assign (1, landmark);
    seen_[landmark] = 1;
    std::size_t next = 0;
    for (int hop = 0; hop <= reach; ++hop)
      for (const std::size_t end = ball.size (); next < end; ++next) {
        const pcl::index_t v = ball[next];
        if (wanted < allowed_[v]) {
          allowed_[v] = wanted;
          candidates_.push_back (v);
        }
        for (const pcl::index_t* w = graph_.begin (v); w != graph_.end (v) && hop < reach; ++w)
          if (!seen_[*w]) {
            seen_[*w] = 1;
            ball.push_back (*w);
          }
      }
    for (const pcl::index_t v : ball)
      seen_[v] = 0;
  }

  // Finds out how far the vertices of a tile are from its landmark, unless that is known. The tile of a
  // vertex is that of the nearest one, and holds a shortest path to it.
  void reachTile (pcl::index_t tile)
  {
    const pcl::index_t landmark = landmarks_[tile];
    if (hops_to_landmark_[landmark] == 0)
      return;
    std::vector<pcl::index_t>& reached = ball_.vertices;
    reached.assign (1, landmark);
    hops_to_landmark_[landmark] = 0;
    std::size_t next = 0;
    for (int hop = 1; next < reached.size (); ++hop)
      for (const std::size_t end = reached.size (); next < end; ++next)
        for (const pcl::index_t* w = graph_.begin (reached[next]); w != graph_.end (reached[next]); ++w)
          if (tiles_[*w] == tile && hops_to_landmark_[*w] > hop) {
            hops_to_landmark_[*w] = hop;
            reached.push_back (*w);
          }
  }

  bool isFree (pcl::index_t v) const { return hops_to_landmark_[v] >= allowed_[v]; }

  std::vector<pcl::index_t> newLandmarks ()
  {
    for (const pcl::index_t v : candidates_)
      reachTile (tiles_[v]);
    std::sort (candidates_.begin (), candidates_.end (), [this] (pcl::index_t v, pcl::index_t w) {
      const std::uint64_t of_v = priorityOf (v, seed_);
      const std::uint64_t of_w = priorityOf (w, seed_);
      return of_v != of_w ? of_v < of_w : v < w;
    });
    std::vector<pcl::index_t> added;
    for (const pcl::index_t v : candidates_)
      if (isFree (v)) {
        findBall (graph_, hops_to_landmark_, v, hops_, seen_, ball_);
        addLandmark (ball_, hops_to_landmark_);
        added.push_back (v);
      }
    candidates_.clear ();
    return added;
  }

  const NeighborhoodGraph& graph_;
  const int hops_;
  const std::uint64_t seed_;
  const std::vector<pcl::index_t>& landmarks_;
  const std::vector<pcl::index_t>& tiles_;
  tbb::enumerable_thread_specific<HopRings> rings_;
  std::vector<std::uint8_t> seen_;
  std::vector<int> allowed_;          ///< per vertex, how many hops a landmark there must be away from others
  std::vector<int> hops_to_landmark_; ///< per vertex of tiles that were reached, or near an added landmark
  std::vector<pcl::index_t> candidates_;
  LandmarkBall ball_;
};

} // namespace

std::vector<pcl::index_t>
refineLandmarks (const NeighborhoodGraph& graph, int hops, std::uint64_t seed,
                 const std::vector<pcl::index_t>& landmarks, const std::vector<pcl::index_t>& tiles,
                 const std::vector<TileContact>& contacts, const std::vector<pcl::index_t>& crowded,
                 unsigned int threads)
{
  if (hops <= FEWEST_HOPS)
    return landmarks;
  // No two vertices are further apart than there are vertices.
  hops = std::min (hops, std::max (graph.size (), FEWEST_HOPS + 1));
  std::vector<pcl::index_t> refined = landmarks;
  withThreads (threads, [&] {
    const std::vector<std::uint8_t> doubtful = findDoubtfulTiles (ContactRows (landmarks.size (), contacts));
    std::vector<pcl::index_t> start;
    for (std::size_t i = 0; i < landmarks.size (); ++i)
      if (doubtful[i] != 0)
        start.push_back (landmarks[i]);
    std::vector<pcl::index_t> around;
    for (const pcl::index_t tile : crowded)
      around.push_back (landmarks[tile]);
    const std::vector<pcl::index_t> added =
      Refinement (graph, hops, seed, landmarks, tiles).run (std::move (start), around);
    refined.insert (refined.end (), added.begin (), added.end ());
  });
  std::sort (refined.begin (), refined.end ());
  return refined;
}

} // namespace manifold
} // namespace pcl
