#pragma once

#include "files/formats.h"
#include "files/scanner.h"

#include <cstdint>

namespace pcl::manifold {

/** \brief What the header of a PCD file says, once it is known to fit together. */
struct PcdHeader
{
  enum class Data
  {
    ASCII,
    BINARY,
    BINARY_COMPRESSED
  };

  pcl::PCLPointCloud2 layout; ///< fields, padding named "_" included, width and height; without data
  Viewpoint viewpoint{0, 0, 0, 1, 0, 0, 0};
  std::uint64_t points = 0;
  std::uint64_t values = 0; ///< numbers in a point: the sum of the counts of its fields
  Data data = Data::ASCII;
};

/** \brief Reads the header of a PCD file (versions 0.6 and 0.7), up to its DATA line, and holds it against
 * itself and against the size of the file, so that whoever allocates by it allocates no more than a small
 * multiple of the file.
 *
 * PCL's own reader trusts the header: sizes that lie make it allocate at will or read past its buffers.
 * \throw FileError that names the line and what is wrong with it */
PcdHeader readPcdHeader (Scanner& scanner);

} // namespace pcl::manifold
