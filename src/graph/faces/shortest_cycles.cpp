#include "graph/faces/shortest_cycles.h"

#include "graph/landmarks/contact_rows.h"

#include <algorithm>
#include <cstdint>

namespace pcl {
namespace manifold {

namespace {

constexpr std::uint8_t MOST_FACES = 2; // that an edge is in

constexpr int FAR_AWAY = -1;

// Longer cycles are no faces in any mesh, whatever the maximum length, and the search for them has no end.
constexpr int LONGEST_CYCLE = 32;

// Searches for cycles along edges that are in fewer than two yet.
class CycleSearch
{
public:
  explicit CycleSearch (const ContactRows& rows)
    : rows_ (rows), faces_of_ (rows.tile.size (), 0), steps_back_ (rows.tiles (), FAR_AWAY)
  {
    for (std::size_t contact = 0; contact < rows.tile.size (); ++contact)
      if (rows.adjacent[contact] == 0)
        faces_of_[contact] = MOST_FACES;
  }

  // Adds all cycles of a length to the faces.
  void takeCycles (int length, std::vector<std::vector<pcl::index_t>>& faces)
  {
    for (std::size_t start = 0; start < rows_.tiles (); ++start) {
      length_ = length;
      faces_ = &faces;
      measureStepsBack (static_cast<pcl::index_t> (start));
      path_.assign (1, static_cast<pcl::index_t> (start));
      way_.clear ();
      extend ();
      for (const pcl::index_t tile : reached_)
        steps_back_[tile] = FAR_AWAY;
    }
  }

private:
  bool isFree (std::size_t contact) const { return faces_of_[contact] < MOST_FACES; }

  // Steps to the start of a cycle among larger tiles, as far as half of the cycle can lead.
  void measureStepsBack (pcl::index_t start)
  {
    reached_.assign (1, start);
    steps_back_[start] = 0;
    for (std::size_t i = 0; i < reached_.size () && 2 * steps_back_[reached_[i]] < length_; ++i)
      visitFree (reached_[i], [&] (std::size_t, pcl::index_t other) {
        if (other < start || steps_back_[other] != FAR_AWAY)
          return;
        steps_back_[other] = steps_back_[reached_[i]] + 1;
        reached_.push_back (other);
      });
  }

  template <typename Visit>
  void visitFree (pcl::index_t tile, const Visit& visit)
  {
    for (std::size_t contact = rows_.starts[tile]; contact < rows_.starts[tile + 1]; ++contact)
      if (isFree (contact))
        visit (contact, rows_.tile[contact]);
  }

  // Tries all ways on from the end of the path, in ascending order, until one of its own edges is used up.
  void extend ()
  {
    const auto size = static_cast<int> (path_.size ());
    if (size == length_) {
      close ();
      return;
    }
    const pcl::index_t end = path_.back ();
    visitFree (end, [&] (std::size_t contact, pcl::index_t other) {
      if (!isWayFree () || steps_back_[other] == FAR_AWAY || steps_back_[other] > length_ - size ||
          other <= path_.front () || isOnPath (other))
        return;
      path_.push_back (other);
      way_.push_back (contact);
      extend ();
      path_.pop_back ();
      way_.pop_back ();
    });
  }

  void close ()
  {
    const std::size_t closing = rows_.find (path_.back (), path_.front ());
    if (closing == ContactRows::NONE || !isFree (closing) || path_[1] > path_.back () || !isWayFree ())
      return;
    way_.push_back (closing);
    for (std::size_t i = 0; i < way_.size (); ++i) {
      ++faces_of_[way_[i]];
      ++faces_of_[rows_.find (rows_.tile[way_[i]], path_[i])];
    }
    way_.pop_back ();
    faces_->push_back (path_);
  }

  bool isWayFree () const
  {
    for (const std::size_t contact : way_)
      if (!isFree (contact))
        return false;
    return true;
  }

  bool isOnPath (pcl::index_t tile) const
  {
    for (const pcl::index_t other : path_)
      if (other == tile)
        return true;
    return false;
  }

  const ContactRows& rows_;
  std::vector<std::uint8_t> faces_of_; ///< per contact
  int length_ = 0;
  std::vector<std::vector<pcl::index_t>>* faces_ = nullptr;
  std::vector<int> steps_back_; ///< per tile
  std::vector<pcl::index_t> reached_;
  std::vector<pcl::index_t> path_;
  std::vector<std::size_t> way_; ///< the contacts along the path
};

} // namespace

LandmarkMesh
shortestCycles (std::size_t landmarks, const std::vector<TileContact>& contacts, int maximum_length)
{
  LandmarkMesh mesh;
  for (const TileContact& contact : contacts)
    if (contact.adjacent)
      mesh.edges.push_back ({contact.first, contact.second});
  const ContactRows rows (landmarks, contacts);
  CycleSearch search (rows);
  for (int length = 3; length <= std::min (maximum_length, LONGEST_CYCLE); ++length)
    search.takeCycles (length, mesh.faces);
  return mesh;
}

} // namespace manifold
} // namespace pcl
