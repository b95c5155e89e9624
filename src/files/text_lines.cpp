#include "files/text_lines.h"

#include "files/file_error.h"
#include "files/number_text.h"

#include <algorithm>
#include <limits>
#include <string>

namespace pcl::manifold {
namespace {

constexpr std::string_view blanks = " \t\v\f\r";

using Words = std::vector<std::string_view>;

/** \brief Reads the words as numbers, all of them or none. \return the decimal mark that they have, 0 for none
 */
char
parseWords (const Words& words, std::vector<double>& numbers)
{
  numbers.clear ();
  char mark = '\0';
  std::string pointed;
  for (std::string_view word : words) {
    const std::size_t at = word.find_first_of (".,");
    if (at != std::string_view::npos) {
      if (mark != '\0' && mark != word[at]) {
        numbers.clear ();
        break;
      }
      mark = word[at];
      if (mark == ',') {
        pointed = word;
        pointed[at] = '.';
        word = pointed;
      }
    }
    double number = std::numeric_limits<double>::quiet_NaN ();
    if (!word.empty () && !parseNumber (word, number)) {
      numbers.clear ();
      break;
    }
    numbers.push_back (number);
  }
  return mark;
}

/** \brief Could the commas of a line of whole numbers be decimal points as well, with commas between the numbers
 * too? So it is where every other number begins with a zero, as only decimals do, or stands by itself. */
bool
isAmbiguous (std::string_view line, const Words& words)
{
  if (words.size () < 6 || words.size () % 2 != 0)
    return false;
  bool zero = false;
  bool pairs = true;
  for (std::size_t i = 0; i < words.size (); ++i) {
    if (i % 2 == 1)
      zero = zero || (words[i].size () > 1 && words[i][0] == '0');
    if (i > 0) {
      const auto start = static_cast<std::size_t> (words[i].data () - line.data ());
      pairs = pairs && (line[start - 1] == ',') == (i % 2 == 1);
    }
  }
  return zero || pairs;
}

} // namespace

void
splitAt (std::string_view line, char separator, Words& words)
{
  words.clear ();
  if (separator == ' ') {
    for (std::size_t begin = line.find_first_not_of (blanks); begin != std::string_view::npos;) {
      const std::size_t end = line.find_first_of (blanks, begin);
      words.push_back (line.substr (begin, end - begin));
      begin = end == std::string_view::npos ? end : line.find_first_not_of (blanks, end);
    }
    return;
  }
  for (std::size_t begin = 0; begin <= line.size ();) {
    const std::size_t end = std::min (line.find (separator, begin), line.size ());
    std::string_view word = line.substr (begin, end - begin);
    word.remove_prefix (std::min (word.find_first_not_of (blanks), word.size ()));
    word = word.substr (0, word.find_last_not_of (blanks) + 1);
    if (end < line.size () || !word.empty ())
      words.push_back (word);
    begin = end + 1;
  }
}

Notation
parseLine (std::string_view line, std::vector<double>& numbers)
{
  thread_local Words words;
  Notation notation;
  if (line.find (';') != std::string_view::npos)
    notation.separator = ';';
  else if (line.find (',') != std::string_view::npos) {
    splitAt (line, ',', words);
    const bool no_commas = parseWords (words, numbers) != ',';
    if (no_commas && numbers.size () >= 3) {
      notation.separator = ',';
      notation.mark = line.find ('.') == std::string_view::npos ? '\0' : '.';
      if (notation.mark == '\0' && isAmbiguous (line, words))
        throw FileError (
          "commas that may stand between numbers or ahead of decimals; write semicolons or blanks "
          "between the numbers");
      return notation;
    }
  }
  splitAt (line, notation.separator, words);
  notation.mark = parseWords (words, numbers);
  const bool any =
    std::any_of (words.begin (), words.end (), [] (std::string_view w) { return !w.empty (); });
  if (!any)
    numbers.clear ();
  return notation;
}

} // namespace pcl::manifold
