#include "off_reader.h"

#include "number_text.h"
#include "text_points.h"

#include <cstdint>
#include <string_view>

namespace pcl::manifold::apps {
namespace {

/** \brief Appends the first three numbers of a line. */
void
appendVertex (const InputFile& file, const std::vector<std::string_view>& words, std::vector<double>& values)
{
  if (words.size () < 3)
    file.failAtLine ("a vertex needs three numbers");
  for (std::size_t i = 0; i < 3; ++i) {
    double number = 0;
    if (!parseNumber (words[i], number))
      file.failAtLine (quoted (std::string (words[i])) + " is no coordinate");
    values.push_back (number);
  }
}

/** \brief Reads the next line that holds anything but a comment.
 * \return false at the end of the file */
bool
readWords (InputFile& file, std::string& line, std::vector<std::string_view>& words)
{
  words.clear ();
  while (words.empty () && file.readLine (line))
    splitLine (std::string_view (line).substr (0, line.find ('#')), false, words);
  return !words.empty ();
}

} // namespace

pcl::PCLPointCloud2
readOffVertices (const std::string& file)
{
  InputFile input (file);
  std::string line;
  std::vector<std::string_view> words;
  readWords (input, line, words);
  const std::string_view key = words.empty () ? std::string_view () : words[0];
  if (key.size () < 3 || key.substr (key.size () - 3) != "OFF")
    input.fail ("not an OFF file: its first word is not OFF, COFF, NOFF or the like");
  if (words.size () > 1 && words[1] == "BINARY")
    input.fail ("a binary OFF file, which is not supported");
  // The counts may follow the key word in its line.
  words.erase (words.begin ());
  if (words.empty ())
    readWords (input, line, words);
  std::uint64_t count = 0;
  if (words.empty () || !parseNumber (words[0], count))
    input.failAtLine ("the number of vertices is missing");
  if (count == 0)
    input.fail ("holds no point: the header says so");
  std::vector<double> values;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!readWords (input, line, words))
      input.fail ("truncated: the file ends after line " + std::to_string (input.lineNumber ()) + ", with " +
                  std::to_string (i) + " of " + std::to_string (count) + " vertices");
    appendVertex (input, words, values);
  }
  return cloudOfColumns (input, values, 3);
}

} // namespace pcl::manifold::apps
