#include "number_text.h"

#include <pcl/PCLPointField.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

namespace pcl::manifold::apps {
namespace {

/** \brief Whole numbers may be written as 1.0 or 1e3 too: some writers print every field as a float. */
template <typename T>
bool
parseWhole (std::string_view text, T& value)
{
  double number = 0;
  if (!parseNumber (text, number) || std::trunc (number) != number)
    return false;
  // The upper end of the 64-bit types is no double: stay below the next power of two.
  const double upper = std::ldexp (1.0, std::numeric_limits<T>::digits);
  if (!(number >= static_cast<double> (std::numeric_limits<T>::lowest ()) && number < upper))
    return false;
  value = static_cast<T> (number);
  return true;
}

template <typename T>
bool
parseInto (std::string_view text, std::uint8_t* to)
{
  T value{};
  if (!parseNumber (text, value)) {
    if constexpr (std::is_integral_v<T>) {
      if (!parseWhole (text, value))
        return false;
    } else
      return false;
  }
  std::memcpy (to, &value, sizeof (T));
  return true;
}

template <typename T>
double
asDouble (const std::uint8_t* from)
{
  T value;
  std::memcpy (&value, from, sizeof (T));
  return static_cast<double> (value);
}

} // namespace

template <typename T>
bool
parseNumber (std::string_view text, T& value)
{
  if (text.size () > 1 && text[0] == '+' && text[1] != '-')
    text.remove_prefix (1);
  const char* end = text.data () + text.size ();
  T parsed{};
  const auto [stop, failure] = std::from_chars (text.data (), end, parsed);
  if (stop != end || text.empty ())
    return false;
  if (failure == std::errc::result_out_of_range && std::is_floating_point_v<T>) {
    // Too large or too small for the type: infinity or zero (or a subnormal), as the C library rounds it.
    if constexpr (std::is_same_v<T, float>)
      parsed = std::strtof (std::string (text).c_str (), nullptr);
    else
      parsed = static_cast<T> (std::strtod (std::string (text).c_str (), nullptr));
  } else if (failure != std::errc ())
    return false;
  value = parsed;
  return true;
}

template bool parseNumber<double> (std::string_view, double&);
template bool parseNumber<float> (std::string_view, float&);
template bool parseNumber<int> (std::string_view, int&);
template bool parseNumber<unsigned> (std::string_view, unsigned&);
template bool parseNumber<std::uint64_t> (std::string_view, std::uint64_t&);

bool
parseField (std::string_view text, std::uint8_t datatype, std::uint8_t* to)
{
  switch (datatype) {
    case pcl::PCLPointField::BOOL:
    case pcl::PCLPointField::UINT8:
      return parseInto<std::uint8_t> (text, to);
    case pcl::PCLPointField::INT8:
      return parseInto<std::int8_t> (text, to);
    case pcl::PCLPointField::INT16:
      return parseInto<std::int16_t> (text, to);
    case pcl::PCLPointField::UINT16:
      return parseInto<std::uint16_t> (text, to);
    case pcl::PCLPointField::INT32:
      return parseInto<std::int32_t> (text, to);
    case pcl::PCLPointField::UINT32:
      return parseInto<std::uint32_t> (text, to);
    case pcl::PCLPointField::INT64:
      return parseInto<std::int64_t> (text, to);
    case pcl::PCLPointField::UINT64:
      return parseInto<std::uint64_t> (text, to);
    case pcl::PCLPointField::FLOAT32:
      return parseInto<float> (text, to);
    case pcl::PCLPointField::FLOAT64:
      return parseInto<double> (text, to);
    default:
      return false;
  }
}

double
fieldAsDouble (std::uint8_t datatype, const std::uint8_t* from)
{
  switch (datatype) {
    case pcl::PCLPointField::BOOL:
    case pcl::PCLPointField::UINT8:
      return asDouble<std::uint8_t> (from);
    case pcl::PCLPointField::INT8:
      return asDouble<std::int8_t> (from);
    case pcl::PCLPointField::INT16:
      return asDouble<std::int16_t> (from);
    case pcl::PCLPointField::UINT16:
      return asDouble<std::uint16_t> (from);
    case pcl::PCLPointField::INT32:
      return asDouble<std::int32_t> (from);
    case pcl::PCLPointField::UINT32:
      return asDouble<std::uint32_t> (from);
    case pcl::PCLPointField::INT64:
      return asDouble<std::int64_t> (from);
    case pcl::PCLPointField::UINT64:
      return asDouble<std::uint64_t> (from);
    case pcl::PCLPointField::FLOAT32:
      return asDouble<float> (from);
    case pcl::PCLPointField::FLOAT64:
      return asDouble<double> (from);
    default:
      return std::numeric_limits<double>::quiet_NaN ();
  }
}

void
splitLine (std::string_view line, bool at_commas, std::vector<std::string_view>& tokens)
{
  const std::string_view separators = at_commas ? " \t\v\f\r,;" : " \t\v\f\r";
  tokens.clear ();
  for (std::size_t begin = line.find_first_not_of (separators); begin != std::string_view::npos;) {
    const std::size_t end = line.find_first_of (separators, begin);
    tokens.push_back (line.substr (begin, end - begin));
    begin = end == std::string_view::npos ? end : line.find_first_not_of (separators, end);
  }
}

} // namespace pcl::manifold::apps
