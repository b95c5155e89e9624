#pragma once

#include "files/file_error.h"
#include "files/formats.h"

#include <pcl/common/io.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

/** What every reader keeps to, whatever the bytes: it fails with one line that says why, or what it gives is
 * consistent. */
namespace fuzz {

inline void
require (bool promise, std::string_view what)
{
  if (promise)
    return;
  std::cerr << "broken promise: " << what << std::endl;
  std::abort ();
}

inline void
requireLine (const std::string& text)
{
  const bool printable =
    std::all_of (text.begin (), text.end (), [] (char c) { return c >= ' ' && c <= '~'; });
  if (text.empty () || text.size () >= 2000 || !printable)
    require (false, "a message is one line: " + text);
}

inline void
requireCloud (const pcl::PCLPointCloud2& cloud)
{
  const std::size_t points = static_cast<std::size_t> (cloud.width) * cloud.height;
  require (cloud.data.size () == points * cloud.point_step, "a cloud has the data of its points");
  require (cloud.height <= 1 || cloud.row_step == cloud.width * cloud.point_step, "rows are packed");
  std::size_t offset = 0;
  for (const pcl::PCLPointField& field : cloud.fields) {
    require (field.offset == offset, "fields are packed");
    require (field.count > 0 && pcl::getFieldSize (field.datatype) > 0, "fields have values of a known type");
    offset += field.count * static_cast<std::size_t> (pcl::getFieldSize (field.datatype));
  }
  require (offset == cloud.point_step, "there is no padding");
}

template <typename Simplices>
void
requireVertices (const Simplices& simplices, std::size_t points)
{
  for (const auto& simplex : simplices)
    for (std::size_t i = 0; i < simplex.size (); ++i) {
      require (simplex[i] >= 0 && static_cast<std::size_t> (simplex[i]) < points, "vertices are points");
      for (std::size_t j = 0; j < i; ++j)
        require (simplex[i] != simplex[j], "no simplex repeats a vertex");
    }
}

/** Reads the bytes and checks what comes out. \return 0, as libFuzzer wants it */
inline int
read (pcl::manifold::FileContent (*reader) (std::string_view), const std::uint8_t* data, std::size_t size)
{
  pcl::manifold::FileContent content;
  try {
    content = reader ({reinterpret_cast<const char*> (data), size});
  } catch (const pcl::manifold::FileError& error) {
    requireLine (error.what ());
    return 0;
  }
  for (const std::string& note : content.notes)
    requireLine (note);
  requireCloud (content.cloud);
  const std::size_t points = static_cast<std::size_t> (content.cloud.width) * content.cloud.height;
  requireVertices (content.complex.edges, points);
  requireVertices (content.complex.triangles, points);
  requireVertices (content.complex.tetrahedra, points);
  return 0;
}

} // namespace fuzz
