#pragma once

#include "complex/files/scalar_type.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief How a VTU file's binary arrays are written. */
struct VtuEncoding
{
  bool big_endian = false;
  bool wide_header = false; ///< lengths have 64 bits, not 32
  bool zlib = false;
};

/** \brief The bytes of an array, in this machine's byte order. The length stands before them, and with zlib
 * the number and the sizes of the blocks.
 * \param[in] bytes the file from where the array starts; what lies behind the array does no harm
 * \param[in] base64 or else raw
 * \param[in] type of the array's values
 * \param[in] encoding as the file's first tag says
 * \throw FileError if the bytes are not what they should be */
std::vector<std::uint8_t> readVtuBinary (std::string_view bytes, bool base64, ScalarType type,
                                         const VtuEncoding& encoding);

/** \brief The values of an array that is written as text.
 * \throw FileError for the first word that is no number of the type */
std::vector<std::uint8_t> readVtuText (std::string_view text, ScalarType type);

} // namespace manifold
} // namespace pcl
