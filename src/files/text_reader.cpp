#include "files/file_error.h"
#include "files/formats.h"
#include "files/scanner.h"
#include "files/text_lines.h"
#include "files/text_names.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace pcl::manifold {
namespace {

/** \brief Lines of one kind, one behind the other but for comments and empty lines. */
struct Lines
{
  std::size_t first = 0; ///< number of the first one
  std::size_t count = 0;
  std::size_t columns = 0; ///< numbers in each; 0 for lines of anything else
  Notation notation;
  std::size_t values = 0; ///< where the numbers of the first one are
};

/** \brief What a line ahead of the points may name the columns by. */
struct Heading
{
  std::size_t line;
  std::string_view text;
};

/** \brief Lines that are left out. */
class SkippedLines
{
public:
  std::size_t count = 0;
  std::size_t first = 0;

  void add (const Lines& lines)
  {
    if (count == 0)
      first = lines.first;
    for (std::size_t i = 0; i < lines.count; ++i, ++count)
      if (count < 5)
        text_ += (count == 0 ? "" : ", ") + std::to_string (lines.first + i);
  }

  std::string text () const { return (count == 1 ? "line " : "lines ") + text_ + (count > 5 ? ", ..." : ""); }

private:
  std::string text_; ///< numbers of the first few
};

class TextReader
{
public:
  explicit TextReader (std::string_view bytes) : scanner_ (bytes) {}

  FileContent read ()
  {
    refusePtx ();
    readLines ();
    choosePoints ();
    checkMarks ();
    takePoints ();
    return std::move (content_);
  }

private:
  [[noreturn]] static void fail (std::size_t line, const std::string& why)
  {
    throw FileError ("line " + std::to_string (line) + ": " + why);
  }

  static Notation parse (std::size_t line, std::string_view text, std::vector<double>& numbers)
  {
    try {
      return parseLine (text, numbers);
    } catch (const FileError& error) {
      fail (line, error.what ());
    }
  }

  /** \brief PTX files look like points from their eleventh line on, but the four lines ahead of them move these.
   */
  void refusePtx ()
  {
    std::vector<double> numbers;
    Scanner scanner = scanner_;
    std::size_t line = 0;
    for (const std::size_t columns : {1, 1, 3, 3, 3, 3, 4, 4, 4, 4}) {
      parse (++line, scanner.line (), numbers);
      if (numbers.size () != columns)
        return;
    }
    throw FileError (
      "line 1: the head of a PTX file, whose points are to be moved by it; convert it to a file of "
      "points alone");
  }

  void readLines ()
  {
    std::vector<double> numbers;
    std::string_view words;
    constexpr std::size_t most_headings = 1000;
    for (std::size_t line = 1; scanner_.remaining () > 0; ++line) {
      std::string_view text = scanner_.line ();
      if (line == 1 && text.substr (0, 3) == "\xEF\xBB\xBF") // the mark of UTF-8
        text.remove_prefix (3);
      const bool comment = isComment (text, words);
      if (comment && headings_.size () < most_headings)
        headings_.push_back ({line, text});
      text = withoutTail (text);
      if (comment || text.find_first_not_of (" \t\v\f\r") == std::string_view::npos)
        continue;
      const Notation notation = parse (line, text, numbers);
      if (numbers.empty () && headings_.size () < most_headings)
        headings_.push_back ({line, text});
      append (line, numbers, notation);
    }
  }

  /** \brief A line without the comment behind its numbers; the `#` of `1.#QNAN` begins none. */
  static std::string_view withoutTail (std::string_view text)
  {
    for (std::size_t at = text.find ('#'); at != std::string_view::npos; at = text.find ('#', at + 1))
      if (at == 0 || (text[at - 1] != '.' && text[at - 1] != ','))
        return text.substr (0, at);
    return text;
  }

  void append (std::size_t line, const std::vector<double>& numbers, Notation notation)
  {
    Lines* last = lines_.empty () ? nullptr : &lines_.back ();
    if (last == nullptr || numbers.empty () || last->columns != numbers.size () ||
        last->notation.separator != notation.separator || line != last->first + last->count ||
        (last->notation.mark != notation.mark && last->notation.mark != '\0' && notation.mark != '\0')) {
      lines_.push_back ({line, 0, numbers.size (), notation, values_.size ()});
      last = &lines_.back ();
    }
    ++last->count;
    if (notation.mark != '\0')
      last->notation.mark = notation.mark;
    values_.insert (values_.end (), numbers.begin (), numbers.end ());
  }

  bool arePoints (const Lines& lines) const
  {
    return lines.columns == columns_ && lines.notation.separator == separator_;
  }

  /** \brief The points are the lines of the commonest kind, the first of them if there are several. */
  void choosePoints ()
  {
    std::map<std::pair<std::size_t, char>, std::size_t> counts;
    for (const Lines& lines : lines_)
      if (lines.columns >= 3)
        counts[{lines.columns, lines.notation.separator}] += lines.count;
    for (const Lines& lines : lines_) {
      const auto found = counts.find ({lines.columns, lines.notation.separator});
      if (found == counts.end () || found->second <= points_)
        continue;
      std::tie (columns_, separator_) = found->first;
      points_ = found->second;
    }
    if (points_ == 0)
      failWithoutPoints ();
    if (points_ > static_cast<std::size_t> (std::numeric_limits<pcl::index_t>::max ()))
      throw FileError ("more points than a cloud can have");
  }

  [[noreturn]] void failWithoutPoints () const
  {
    SkippedLines skipped;
    for (const Lines& lines : lines_)
      skipped.add (lines);
    throw FileError ("no line holds a point (three numbers or more)" +
                     (skipped.count > 0 ? "; not understood: " + skipped.text () : std::string ()));
  }

  /** \brief One decimal mark a file: points and commas together cannot be told from thousands. */
  void checkMarks ()
  {
    const Lines* first = nullptr;
    for (const Lines& lines : lines_) {
      if (!arePoints (lines) || lines.notation.mark == '\0')
        continue;
      if (first != nullptr && first->notation.mark != lines.notation.mark)
        fail (lines.first, std::string (lines.notation.mark == ',' ? "commas" : "points") +
                             " ahead of decimals, but not so from line " + std::to_string (first->first) +
                             " on");
      if (first == nullptr)
        first = &lines;
    }
    if (first != nullptr && first->notation.mark == ',')
      content_.notes.push_back ("commas taken for decimal points");
  }

  /** \brief Takes the names of the last line ahead of the points that has as many as there are columns.
   * \return the number of that line, 0 if there is none */
  std::size_t makeFields (std::size_t first_point)
  {
    std::vector<std::string> names;
    std::size_t names_line = 0;
    for (const Heading& heading : headings_)
      if (heading.line < first_point) {
        std::vector<std::string> found = parseNames (heading.text, separator_, columns_);
        if (found.empty ())
          continue;
        names = std::move (found);
        names_line = heading.line;
      }
    pcl::PCLPointCloud2& cloud = content_.cloud;
    for (const std::string& field : fieldNames (names, columns_))
      appendField (cloud, field, pcl::PCLPointField::FLOAT64);
    cloud.height = 1;
    cloud.width = static_cast<pcl::uindex_t> (points_);
    allocatePoints (cloud);
    return names_line;
  }

  void takePoints ()
  {
    const auto first = std::find_if (lines_.begin (), lines_.end (),
                                     [this] (const Lines& lines) { return arePoints (lines); });
    const std::size_t names_line = makeFields (first->first);
    std::uint8_t* to = content_.cloud.data.data ();
    SkippedLines skipped;
    SkippedLines wrong; // those of them that no heading would have, of which there may be few only
    for (auto lines = lines_.begin (); lines != lines_.end (); ++lines) {
      const bool ahead = lines < first;
      if (arePoints (*lines)) {
        const std::size_t bytes = lines->count * columns_ * sizeof (double);
        std::memcpy (to, values_.data () + lines->values, bytes);
        to += bytes;
        continue;
      }
      if (!ahead && lines->columns >= 3 && lines->notation.separator != separator_)
        fail (lines->first,
              "its numbers are separated otherwise than those of line " + std::to_string (first->first));
      // A single number ahead of the points is how many there are.
      if (ahead && lines->count == 1 && (lines->columns == 1 || lines->first == names_line))
        continue;
      skipped.add (*lines);
      if (!ahead || lines->columns > 0)
        wrong.add (*lines);
    }
    const std::string numbers = std::to_string (columns_) + " numbers";
    if (wrong.count > std::max (std::min<std::size_t> (points_ / 10, 5), points_ / 1000))
      fail (wrong.first,
            "not the " + numbers + " of most lines; " + std::to_string (wrong.count) + " lines differ");
    if (skipped.count > 0)
      content_.notes.push_back (
        std::to_string (skipped.count) +
        (skipped.count == 1 ? " line skipped that holds no " : " lines skipped that hold no ") + numbers +
        ": " + skipped.text ());
  }

  Scanner scanner_;
  FileContent content_;
  std::vector<Lines> lines_;
  std::vector<double> values_; ///< of all lines of numbers
  std::vector<Heading> headings_;
  std::size_t columns_ = 0; ///< of the points
  char separator_ = ' ';
  std::size_t points_ = 0;
};

} // namespace

FileContent
readText (std::string_view bytes)
{
  return TextReader (bytes).read ();
}

} // namespace pcl::manifold
