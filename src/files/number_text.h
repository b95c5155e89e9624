#pragma once

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace pcl::manifold {

/** \brief Numbers that std::from_chars does not take: those beyond the range of a double, which become
 * infinite or zero, and the `1.#QNAN`, `-1.#IND` and `1.#INF` of old Windows runtimes.
 * \return false if the word is none of them */
bool parseOddNumber (std::string_view word, double& number);

/** \brief Reads one number that fills all of a word, whatever the locale. An integer type takes no fraction
 * and no overflow, but numbers written as 1.0 or 1e3: some writers print every field as a float. A
 * floating-point type takes `nan` and `inf` too; what is beyond its range becomes infinite or zero.
 * \return false, and leaves the number as it was, if the word is no such number */
template <typename Number>
bool
parseNumber (std::string_view word, Number& number)
{
  if (word.size () > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix (1);
  Number parsed{};
  const char* end = word.data () + word.size ();
  const auto [rest, error] = std::from_chars (word.data (), end, parsed);
  if (error == std::errc () && rest == end) {
    number = parsed;
    return true;
  }
  if constexpr (std::is_floating_point_v<Number>) {
    double wide = 0;
    if (!parseOddNumber (word, wide))
      return false;
    number = static_cast<Number> (wide);
    return true;
  } else {
    double wide = 0;
    if (!parseNumber (word, wide) || std::trunc (wide) != wide)
      return false;
    // The upper end of the 64-bit types is no double: stay below the next power of two.
    if (wide < static_cast<double> (std::numeric_limits<Number>::lowest ()) ||
        wide >= std::ldexp (1.0, std::numeric_limits<Number>::digits))
      return false;
    number = static_cast<Number> (wide);
    return true;
  }
}

} // namespace pcl::manifold
