#include "graph/landmarks/clear_path.h"

#include "common/parallel.h"
#include "complex/disjoint_sets.h"

#include <algorithm>
#include <cstdint>

namespace pcl {
namespace manifold {

namespace {

// What tile besides its own a vertex has neighbours in.
constexpr pcl::index_t NONE = -1;
constexpr pcl::index_t SEVERAL = -2;

constexpr std::size_t CONTACTS_PER_TASK = 64;

std::vector<pcl::index_t>
otherTiles (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& tiles)
{
  std::vector<pcl::index_t> others (tiles.size ());
  parallelFor (tiles.size (), [&] (std::size_t i) {
    const auto v = static_cast<pcl::index_t> (i);
    pcl::index_t other = NONE;
    for (const pcl::index_t* w = graph.begin (v); w != graph.end (v); ++w)
      if (tiles[*w] != tiles[v] && tiles[*w] != other)
        other = other == NONE ? tiles[*w] : SEVERAL;
    others[i] = other;
  });
  return others;
}

// The vertices that see one other tile, by the contact of that one with theirs: those of contact i are
// vertices[starts[i]] to vertices[starts[i + 1] - 1].
struct Borders
{
  std::vector<std::size_t> starts;
  std::vector<pcl::index_t> vertices;

  Borders (const std::vector<pcl::index_t>& tiles, const std::vector<pcl::index_t>& others,
           const std::vector<TileContact>& contacts)
    : starts (contacts.size () + 1, 0)
  {
    std::vector<std::size_t> contact_of (tiles.size (), contacts.size ());
    parallelFor (tiles.size (), [&] (std::size_t v) {
      if (others[v] < 0 || tiles[v] < 0)
        return;
      const auto [first, second] = std::minmax (tiles[v], others[v]);
      contact_of[v] = static_cast<std::size_t> (
        std::lower_bound (contacts.begin (), contacts.end (), std::pair (first, second),
                          [] (const TileContact& contact, const auto& pair) {
                            return std::pair (contact.first, contact.second) < pair;
                          }) -
        contacts.begin ());
    });
    for (const std::size_t contact : contact_of)
      if (contact < contacts.size ())
        ++starts[contact + 1];
    for (std::size_t i = 0; i < contacts.size (); ++i)
      starts[i + 1] += starts[i];
    vertices.resize (starts.back ());
    std::vector<std::size_t> next (starts.begin (), starts.end () - 1);
    for (std::size_t v = 0; v < tiles.size (); ++v)
      if (contact_of[v] < contacts.size ())
        vertices[next[contact_of[v]]++] = static_cast<pcl::index_t> (v);
  }
};

// Per vertex that sees no other tile the smallest one of those that hang together with it by such vertices,
// for all others themselves. So every vertex is looked at once, however many contacts its tile has.
std::vector<pcl::index_t>
interiors (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& others)
{
  DisjointSets sets (others.size ());
  for (std::size_t i = 0; i < others.size (); ++i) {
    const auto v = static_cast<pcl::index_t> (i);
    for (const pcl::index_t* w = graph.begin (v); others[i] == NONE && w != graph.end (v) && *w < v; ++w)
      if (others[*w] == NONE)
        sets.join (static_cast<std::uint32_t> (v), static_cast<std::uint32_t> (*w));
  }
  std::vector<pcl::index_t> interior (others.size ());
  for (std::size_t v = 0; v < others.size (); ++v)
    interior[v] = static_cast<pcl::index_t> (sets.find (static_cast<std::uint32_t> (v)));
  return interior;
}

// The clear vertices of a contact are those that see no third tile: of the border between both tiles, and of
// their interiors. Finds out whether the landmarks hang together by them, where every connected part of an
// interior counts as one vertex.
class ContactSearch
{
public:
  ContactSearch (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& tiles,
                 const std::vector<pcl::index_t>& others, const std::vector<pcl::index_t>& interior,
                 const Borders& borders)
    : graph_ (graph), tiles_ (tiles), others_ (others), interior_ (interior), borders_ (borders)
  {}

  bool joins (std::size_t number, const TileContact& contact, pcl::index_t from, pcl::index_t to)
  {
    const auto isClear = [&] (pcl::index_t v) {
      return others_[v] == NONE || (tiles_[v] == contact.first && others_[v] == contact.second) ||
             (tiles_[v] == contact.second && others_[v] == contact.first);
    };
    if (!isClear (from) || !isClear (to))
      return false;
    links_.clear ();
    nodes_.assign ({interior_[from], interior_[to]});
    for (std::size_t i = borders_.starts[number]; i < borders_.starts[number + 1]; ++i) {
      const pcl::index_t v = borders_.vertices[i];
      nodes_.push_back (interior_[v]);
      for (const pcl::index_t* w = graph_.begin (v); w != graph_.end (v); ++w)
        if (isClear (*w)) {
          links_.emplace_back (interior_[v], interior_[*w]);
          nodes_.push_back (interior_[*w]);
        }
    }
    std::sort (nodes_.begin (), nodes_.end ());
    nodes_.erase (std::unique (nodes_.begin (), nodes_.end ()), nodes_.end ());
    DisjointSets sets (nodes_.size ());
    for (const auto& [v, w] : links_)
      sets.join (numberOf (v), numberOf (w));
    return sets.find (numberOf (interior_[from])) == sets.find (numberOf (interior_[to]));
  }

private:
  std::uint32_t numberOf (pcl::index_t node) const
  {
    return static_cast<std::uint32_t> (std::lower_bound (nodes_.begin (), nodes_.end (), node) -
                                       nodes_.begin ());
  }

  const NeighborhoodGraph& graph_;
  const std::vector<pcl::index_t>& tiles_;
  const std::vector<pcl::index_t>& others_;
  const std::vector<pcl::index_t>& interior_;
  const Borders& borders_;
  std::vector<pcl::index_t> nodes_;
  std::vector<std::pair<pcl::index_t, pcl::index_t>> links_;
};

} // namespace

void
findClearPaths (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& landmarks,
                const std::vector<pcl::index_t>& tiles, std::vector<TileContact>& contacts)
{
  const std::vector<pcl::index_t> others = otherTiles (graph, tiles);
  const std::vector<pcl::index_t> interior = interiors (graph, others);
  const Borders borders (tiles, others, contacts);
  parallelRanges (
    contacts.size (),
    [&] (std::size_t begin, std::size_t end) {
      ContactSearch search (graph, tiles, others, interior, borders);
      for (std::size_t i = begin; i < end; ++i)
        contacts[i].adjacent =
          search.joins (i, contacts[i], landmarks[contacts[i].first], landmarks[contacts[i].second]);
    },
    CONTACTS_PER_TASK);
}

} // namespace manifold
} // namespace pcl
