#include "files/number_text.h"

namespace pcl::manifold {
namespace {

/** \brief What follows the `1.#` of an infinity or a NaN: its name, and zeros as far as digits were asked for.
 */
bool
parseWindowsName (std::string_view name, long double& number)
{
  for (const std::string_view known : {"INF", "QNAN", "SNAN", "IND"})
    if (name.substr (0, known.size ()) == known &&
        name.find_first_not_of ('0', known.size ()) == std::string_view::npos) {
      using Limits = std::numeric_limits<long double>;
      number = known == "INF" ? Limits::infinity () : Limits::quiet_NaN ();
      return true;
    }
  return false;
}

} // namespace

bool
parseOddNumber (std::string_view word, long double& number)
{
  const bool negative = !word.empty () && word[0] == '-';
  const std::string_view magnitude = word.substr (negative ? 1 : 0);
  if (magnitude.substr (0, 3) == "1.#") {
    if (!parseWindowsName (magnitude.substr (3), number))
      return false;
  } else {
    const char* end = magnitude.data () + magnitude.size ();
    const auto [rest, error] = std::from_chars (magnitude.data (), end, number);
    if (magnitude.empty () || magnitude[0] == '-' || rest != end ||
        (error != std::errc () && error != std::errc::result_out_of_range))
      return false;
    if (error == std::errc::result_out_of_range) {
      const bool tiny =
        word.find ("e-") != std::string_view::npos || word.find ("E-") != std::string_view::npos;
      number = tiny ? 0 : std::numeric_limits<long double>::infinity ();
    }
  }
  if (negative)
    number = -number;
  return true;
}

} // namespace pcl::manifold
