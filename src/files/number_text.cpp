#include "files/number_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pcl::manifold {
namespace {

/** \brief What follows the `1.#` of an infinity or a NaN: its name, and zeros as far as digits were asked for.
 */
bool
parseWindowsName (std::string_view name, double& number)
{
  for (const std::string_view known : {"INF", "QNAN", "SNAN", "IND"})
    if (name.substr (0, known.size ()) == known &&
        name.find_first_not_of ('0', known.size ()) == std::string_view::npos) {
      using Limits = std::numeric_limits<double>;
      number = known == "INF" ? Limits::infinity () : Limits::quiet_NaN ();
      return true;
    }
  return false;
}

/** \brief Is a number, which is no double, too small rather than too large? */
bool
isTiny (std::string_view number)
{
  const std::size_t e = std::min (number.find_first_of ("eE"), number.size ());
  const std::string_view mantissa = number.substr (0, e);
  const std::size_t point = std::min (mantissa.find ('.'), mantissa.size ());
  const auto digits =
    static_cast<std::ptrdiff_t> (point) - static_cast<std::ptrdiff_t> (mantissa.find_first_of ("123456789"));
  std::string_view text = number.substr (std::min (e + 1, number.size ()));
  text.remove_prefix (text.substr (0, 1) == "+" ? 1 : 0);
  std::int64_t exponent = 0;
  if (std::from_chars (text.data (), text.data () + text.size (), exponent).ec ==
      std::errc::result_out_of_range)
    return text[0] == '-';
  return exponent < -digits;
}

} // namespace

bool
parseOddNumber (std::string_view word, double& number)
{
  const bool negative = word.substr (0, 1) == "-";
  const std::string_view magnitude = word.substr (negative ? 1 : 0);
  if (magnitude.substr (0, 3) == "1.#") {
    if (!parseWindowsName (magnitude.substr (3), number))
      return false;
  } else {
    const char* end = magnitude.data () + magnitude.size ();
    const auto [rest, error] = std::from_chars (magnitude.data (), end, number);
    if (magnitude.substr (0, 1) == "-" || rest != end)
      return false;
    if (error == std::errc::result_out_of_range)
      number = isTiny (magnitude) ? 0 : std::numeric_limits<double>::infinity ();
    else if (error != std::errc ())
      return false;
  }
  if (negative)
    number = -number;
  return true;
}

} // namespace pcl::manifold
