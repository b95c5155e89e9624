#include <generate/catalogue.h>
#include <generate/closed_surfaces.h>
#include <generate/curves.h>
#include <generate/implicit.h>
#include <generate/open_surfaces.h>
#include <generate/solids.h>

#include <stdexcept>
#include <utility>

namespace generate {

namespace {

using Entry = std::pair<std::string, std::function<Shape ()>>;

const std::vector<Entry>&
entries ()
{
  static const std::vector<Entry> list = {
    {"circle", [] { return circle (); }},
    {"trefoil", [] { return trefoil (); }},
    {"helix", [] { return helix (); }},
    {"segment", [] { return segment (); }},
    {"sphere", [] { return sphere (); }},
    {"ellipsoid", [] { return ellipsoid (); }},
    {"torus", [] { return torus (); }},
    {"knotted-tube", [] { return knottedTube (); }},
    {"genus2", [] { return genus2 (); }},
    {"genus3", [] { return genus3 (); }},
    {"hemisphere", [] { return hemisphere (); }},
    {"annulus", [] { return annulus (); }},
    {"square", [] { return flatSquare (); }},
    {"terrain", [] { return terrain (); }},
    {"moebius", [] { return moebiusBand (); }},
    {"cylinder", [] { return openCylinder (); }},
    {"ball", [] { return ball (); }},
    {"box", [] { return box (); }},
    {"solid-torus", [] { return solidTorus (); }},
  };
  return list;
}

} // namespace

const std::vector<std::string>&
shapeNames ()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const Entry& entry : entries ())
      result.push_back (entry.first);
    return result;
  }();
  return names;
}

Shape
shapeByName (const std::string& name)
{
  for (const Entry& entry : entries ())
    if (entry.first == name)
      return entry.second ();
  throw std::invalid_argument ("there is no shape '" + name + "'");
}

} // namespace generate
