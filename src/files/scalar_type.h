#pragma once

#include "files/number_text.h"

#include <pcl/PCLPointField.h>

#include <boost/predef/other/endian.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace pcl::manifold {

/** \brief Type of a field's values, one of pcl::PCLPointField::PointFieldTypes. */
using ScalarType = std::uint8_t;

/** \brief Calls f with a value of the C++ type that belongs to a scalar type; BOOL counts as UINT8. */
template <typename Function>
decltype (auto)
withType (ScalarType type, Function f)
{
  switch (type) {
    case pcl::PCLPointField::INT8:
      return f (std::int8_t ());
    case pcl::PCLPointField::INT16:
      return f (std::int16_t ());
    case pcl::PCLPointField::UINT16:
      return f (std::uint16_t ());
    case pcl::PCLPointField::INT32:
      return f (std::int32_t ());
    case pcl::PCLPointField::UINT32:
      return f (std::uint32_t ());
    case pcl::PCLPointField::INT64:
      return f (std::int64_t ());
    case pcl::PCLPointField::UINT64:
      return f (std::uint64_t ());
    case pcl::PCLPointField::FLOAT32:
      return f (float ());
    case pcl::PCLPointField::FLOAT64:
      return f (double ());
    default:
      return f (std::uint8_t ());
  }
}

/** \brief Is it one of the types, and not some number that a broken cloud holds? */
inline bool
isScalarType (ScalarType type)
{
  using Field = pcl::PCLPointField;
  for (const int known : {Field::BOOL, Field::INT8, Field::UINT8, Field::INT16, Field::UINT16, Field::INT32,
                          Field::UINT32, Field::INT64, Field::UINT64, Field::FLOAT32, Field::FLOAT64})
    if (type == known)
      return true;
  return false;
}

/** \brief Bytes of one value. */
inline std::size_t
sizeOf (ScalarType type)
{
  return withType (type, [] (auto value) { return sizeof (value); });
}

/** \brief A value wherever it lies, as a double; integers beyond 2^53 are rounded. */
inline double
toDouble (ScalarType type, const void* data)
{
  return withType (type, [data] (auto value) {
    std::memcpy (&value, data, sizeof (value));
    return static_cast<double> (value);
  });
}

/** \brief Reads one number from a word into memory.
 * \return false if the word is no number of that type */
inline bool
parseValue (std::string_view word, ScalarType type, void* to)
{
  return withType (type, [&] (auto value) {
    if (!parseNumber (word, value))
      return false;
    std::memcpy (to, &value, sizeof (value));
    return true;
  });
}

constexpr bool host_is_big_endian = BOOST_ENDIAN_BIG_BYTE;

/** \brief Turns the bytes of some values around. */
inline void
swapBytes (void* data, std::size_t size, std::size_t count)
{
  auto* bytes = static_cast<std::uint8_t*> (data);
  for (std::size_t i = 0; i < count; ++i)
    std::reverse (bytes + i * size, bytes + (i + 1) * size);
}

} // namespace pcl::manifold
