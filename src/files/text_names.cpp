#include "files/text_names.h"

#include "files/number_text.h"
#include "files/text_lines.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace pcl::manifold {
namespace {

/** \brief Is it the name of this axis: `x`, `X`, `X [m]`, `x(m)`? */
bool
isAxis (const std::string& name, char axis)
{
  return !name.empty () && std::tolower (static_cast<unsigned char> (name[0])) == axis &&
         (name.size () == 1 || std::string_view (" [(").find (name[1]) != std::string_view::npos);
}

/** \brief Where x, y and z are; the first three columns if one of them has no name. */
std::array<std::size_t, 3>
findAxes (const std::vector<std::string>& names)
{
  std::array<std::size_t, 3> axes{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto found = std::find_if (names.begin (), names.end (),
                                     [k] (const std::string& name) { return isAxis (name, "xyz"[k]); });
    if (found == names.end ())
      return {0, 1, 2};
    axes[k] = static_cast<std::size_t> (found - names.begin ());
  }
  return axes;
}

/** \brief A name of letters, digits, points, hyphens and underscores. */
std::string
cleanName (const std::string& name)
{
  std::string clean;
  for (const char c : name) {
    const bool keep = std::isalnum (static_cast<unsigned char> (c)) != 0 || c == '.' || c == '-';
    if (keep || (!clean.empty () && clean.back () != '_'))
      clean += keep ? c : '_';
  }
  while (!clean.empty () && clean.back () == '_')
    clean.pop_back ();
  return clean;
}

} // namespace

bool
isComment (std::string_view line, std::string_view& words)
{
  words = line.substr (std::min (line.find_first_not_of (" \t"), line.size ()));
  if (words.empty () || (words[0] != '#' && words[0] != '%' && words.substr (0, 2) != "//"))
    return false;
  words.remove_prefix (std::min (words.find_first_not_of ("#%/ \t"), words.size ()));
  return true;
}

std::vector<std::string>
parseNames (std::string_view line, char separator, std::size_t columns)
{
  std::string_view text;
  const bool comment = isComment (line, text);
  std::vector<std::string_view> words;
  for (const char at : {separator, ';', ',', '\t', ' '}) {
    splitAt (text, at, words);
    if (words.size () != columns)
      continue;
    std::vector<std::string> names;
    for (std::string_view word : words) {
      double number = 0;
      if (word.size () > 1 && word.front () == '"' && word.back () == '"')
        word = word.substr (1, word.size () - 2);
      if (word.empty () || parseNumber (word, number))
        return {};
      names.emplace_back (word);
    }
    // Any comment of as many words could be taken for names.
    const bool axes = isAxis (names[findAxes (names)[0]], 'x');
    return comment && at == ' ' && !axes ? std::vector<std::string> () : names;
  }
  return {};
}

std::vector<std::string>
fieldNames (const std::vector<std::string>& names, std::size_t columns)
{
  const std::array<std::size_t, 3> axes = findAxes (names);
  std::vector<std::string> fields (columns);
  for (std::size_t k = 0; k < 3; ++k)
    fields[axes[k]] = std::string (1, "xyz"[k]);
  for (std::size_t i = 0; i < columns; ++i) {
    if (!fields[i].empty ())
      continue;
    std::string name = names.empty () ? "" : cleanName (names[i]);
    if (name.empty () || std::find (fields.begin (), fields.end (), name) != fields.end ())
      name += (name.empty () ? "column_" : "_") + std::to_string (i + 1);
    fields[i] = name;
  }
  return fields;
}

} // namespace pcl::manifold
