#include "xyz_reader.h"

#include "number_text.h"
#include "text_points.h"

#include <cstdint>

namespace pcl::manifold::apps {
namespace {

/** \brief The lines that did not conform. */
struct SkippedLines
{
  std::uint64_t count = 0;
  std::string first; ///< numbers of the first few

  void add (std::uint64_t line)
  {
    constexpr std::uint64_t shown = 5;
    if (count < shown)
      first += (count == 0 ? "" : ", ") + std::to_string (line);
    else if (count == shown)
      first += ", ...";
    ++count;
  }

  std::string text () const { return (count == 1 ? "line " : "lines ") + first; }
};

} // namespace

pcl::PCLPointCloud2
readXyz (const std::string& file, std::vector<std::string>& notes)
{
  InputFile input (file);
  std::string line;
  std::vector<std::string_view> words;
  std::vector<double> numbers;
  std::vector<double> values;
  std::size_t columns = 0;
  SkippedLines skipped;
  while (input.readLine (line)) {
    std::string_view text = line;
    const std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (input.lineNumber () == 1 && text.substr (0, 3) == byte_order_mark)
      text.remove_prefix (3);
    splitLine (text.substr (0, text.find ('#')), true, words);
    if (words.empty ())
      continue;
    if (!parseNumbers (words, numbers) || numbers.size () < 3 ||
        (columns != 0 && numbers.size () != columns)) {
      skipped.add (input.lineNumber ());
      continue;
    }
    columns = numbers.size ();
    values.insert (values.end (), numbers.begin (), numbers.end ());
  }
  if (values.empty ())
    input.fail ("none of its " + std::to_string (input.lineNumber ()) +
                " lines holds a point (three numbers or more)" +
                (skipped.count > 0 ? "; not understood: " + skipped.text () : ""));
  if (skipped.count > 0)
    notes.push_back (std::to_string (skipped.count) + (skipped.count == 1 ? " line" : " lines") +
                     " skipped that hold no " + std::to_string (columns) + " numbers: " + skipped.text ());
  return cloudOfColumns (input, values, columns);
}

} // namespace pcl::manifold::apps
