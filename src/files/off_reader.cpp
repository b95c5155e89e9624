#include "files/file_error.h"
#include "files/formats.h"
#include "files/scanner.h"

namespace pcl::manifold {
namespace {

using Words = std::vector<std::string_view>;

/** \brief Reads the next line that holds anything but a comment.
 * \return false at the end of the file */
bool
readWords (Scanner& scanner, Words& words)
{
  while (scanner.wordsOfLine (words)) {
    for (std::size_t i = 0; i < words.size (); ++i) {
      const std::size_t comment = words[i].find ('#');
      if (comment == std::string_view::npos)
        continue;
      words[i] = words[i].substr (0, comment);
      words.resize (comment > 0 ? i + 1 : i);
    }
    if (!words.empty ())
      return true;
  }
  return false;
}

/** \brief Reads the header. \return the number of vertices */
std::size_t
readCount (Scanner& scanner)
{
  Words words;
  readWords (scanner, words);
  const std::string_view key = words.empty () ? std::string_view () : words[0];
  if (key.size () < 3 || key.substr (key.size () - 3) != "OFF")
    throw FileError ("not an OFF file: its first word is not OFF, COFF, NOFF or the like");
  if (words.size () > 1 && words[1] == "BINARY")
    throw FileError ("a binary OFF file, which is not supported");
  // The counts may follow the key word in its line.
  words.erase (words.begin ());
  if (words.empty ())
    readWords (scanner, words);
  std::size_t count = 0;
  if (words.empty () || !parseNumber (words[0], count))
    scanner.failAtLine ("the number of vertices is missing");
  return count;
}

} // namespace

FileContent
readOff (std::string_view bytes)
{
  Scanner scanner (bytes);
  const std::size_t count = readCount (scanner);
  std::vector<CloudColumn> columns;
  for (const char* const name : {"x", "y", "z"})
    columns.push_back ({name, pcl::PCLPointField::FLOAT64, 1, {}});
  Words words;
  for (std::size_t i = 0; i < count; ++i) {
    if (!readWords (scanner, words))
      throw FileError ("truncated: the file ends with " + std::to_string (i) + " of " +
                       std::to_string (count) + " vertices");
    if (words.size () < 3)
      scanner.failAtLine ("a vertex needs three numbers");
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint8_t value[sizeof (double)];
      if (!parseValue (words[k], pcl::PCLPointField::FLOAT64, value))
        scanner.failAtLine (quoted (words[k]) + " is no coordinate");
      columns[k].data.insert (columns[k].data.end (), value, value + sizeof (value));
    }
  }
  FileContent content;
  content.cloud = makeCloud (columns, count);
  return content;
}

} // namespace pcl::manifold
