#include "files/pcd_header.h"

#include "files/file_error.h"

#include <pcl/common/io.h>

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::manifold {
namespace {

using Words = std::vector<std::string_view>;

/** \brief Bytes of a point that no sensible file exceeds; keeps every product below in 64 bits. */
constexpr std::uint64_t max_point_bytes = 1u << 20;

/** \brief The lines of a header, as they were found. */
class PcdHeaderParser
{
public:
  explicit PcdHeaderParser (Scanner& scanner) : scanner_ (scanner) {}

  PcdHeader parse ()
  {
    Words words;
    do {
      if (!scanner_.wordsOfLine (words))
        throw FileError ("the header has no DATA line");
    } while (words.empty () || words[0][0] == '#' || !takeLine (words));
    takePoints ();
    takeFields ();
    checkSize ();
    return std::move (header_);
  }

private:
  [[noreturn]] void fail (std::string_view word, const std::string& what) const
  {
    scanner_.failAtLine (std::string (word) + " " + what);
  }

  /** \brief Reads one line that is no comment.
   * \return true if it was the last one */
  bool takeLine (const Words& words)
  {
    const std::string_view key = words[0];
    if (key == "VERSION") {
    } else if (key == "FIELDS" || key == "COLUMNS")
      takeNames (words);
    else if (key == "SIZE")
      takeNumbers (words, sizes_);
    else if (key == "TYPE")
      takeTypes (words);
    else if (key == "COUNT")
      takeNumbers (words, counts_);
    else if (key == "WIDTH")
      width_ = takeNumber (words);
    else if (key == "HEIGHT")
      height_ = takeNumber (words);
    else if (key == "POINTS")
      points_ = takeNumber (words);
    else if (key == "VIEWPOINT")
      takeViewpoint (words);
    else if (key == "DATA") {
      takeData (words);
      return true;
    } else
      scanner_.failAtLine ("not a line of a PCD header: " + quoted (key));
    return false;
  }

  void takeNames (const Words& words)
  {
    if (words.size () < 2)
      fail (words[0], "names no field");
    names_.assign (words.begin () + 1, words.end ());
    sizes_.clear (); // of other fields, if this is the second such line
    types_.clear ();
    counts_.clear ();
  }

  void takeNumbers (const Words& words, std::vector<std::uint64_t>& numbers)
  {
    checkOnePerField (words);
    numbers.clear ();
    for (std::size_t i = 1; i < words.size (); ++i) {
      std::uint64_t number = 0;
      if (!parseNumber (words[i], number) || number == 0 || number > max_point_bytes)
        fail (words[0],
              "holds " + quoted (words[i]) + ", no number from 1 to " + std::to_string (max_point_bytes));
      numbers.push_back (number);
    }
  }

  void takeTypes (const Words& words)
  {
    checkOnePerField (words);
    types_.clear ();
    for (std::size_t i = 1; i < words.size (); ++i) {
      if (words[i] != "I" && words[i] != "U" && words[i] != "F" && words[i] != "B")
        fail (words[0], "holds " + quoted (words[i]) + ", none of I, U, F, B");
      types_.push_back (words[i][0]);
    }
  }

  void checkOnePerField (const Words& words) const
  {
    if (names_.empty ())
      fail (words[0], "comes before FIELDS");
    if (words.size () != names_.size () + 1)
      fail (words[0], "has " + std::to_string (words.size () - 1) + " entries for " +
                        std::to_string (names_.size ()) + " fields");
  }

  std::uint64_t takeNumber (const Words& words) const
  {
    std::uint64_t number = 0;
    if (words.size () != 2 || !parseNumber (words[1], number))
      fail (words[0], "is not followed by one whole number");
    // PCL counts points with 32 signed bits.
    if (number > std::numeric_limits<std::int32_t>::max ())
      fail (words[0], "is " + std::to_string (number) + ", more than PCL can hold");
    return number;
  }

  void takeViewpoint (const Words& words)
  {
    if (words.size () != 8)
      fail (words[0], "has " + std::to_string (words.size () - 1) + " entries instead of 7");
    for (std::size_t i = 0; i < 7; ++i)
      if (!parseNumber (words[i + 1], header_.viewpoint[i]))
        fail (words[0], "holds " + quoted (words[i + 1]) + ", no number");
  }

  void takeData (const Words& words)
  {
    const std::string_view kind = words.size () == 2 ? words[1] : std::string_view ();
    if (kind == "ascii")
      header_.data = PcdHeader::Data::ASCII;
    else if (kind == "binary")
      header_.data = PcdHeader::Data::BINARY;
    else if (kind == "binary_compressed")
      header_.data = PcdHeader::Data::BINARY_COMPRESSED;
    else
      fail (words[0], "is none of ascii, binary, binary_compressed");
  }

  void takePoints ()
  {
    if (!width_ && !points_)
      throw FileError ("the header has neither WIDTH nor POINTS");
    // A width alone is a row, as for PCL.
    const std::uint64_t height = height_.value_or (1);
    const std::uint64_t width = width_ ? *width_ : *points_;
    header_.points = points_.value_or (width * height);
    if (width * height != header_.points)
      throw FileError ("the header says WIDTH " + std::to_string (width) + " and HEIGHT " +
                       std::to_string (height) + ", but POINTS " + std::to_string (header_.points));
    if (header_.points == 0)
      throw FileError ("holds no point: the header says so");
    if (header_.points > std::numeric_limits<std::int32_t>::max ())
      throw FileError ("the header says " + std::to_string (header_.points) +
                       " points, more than PCL can hold");
    header_.layout.width = static_cast<pcl::uindex_t> (width);
    header_.layout.height = static_cast<pcl::uindex_t> (height);
  }

  void takeFields ()
  {
    if (names_.empty ())
      throw FileError ("the header has no FIELDS line");
    if (sizes_.empty () || types_.empty ())
      throw FileError (std::string ("the header has no ") + (sizes_.empty () ? "SIZE" : "TYPE") + " line");
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < names_.size (); ++i) {
      const int type = pcl::getFieldType (static_cast<int> (sizes_[i]), types_[i]);
      if (type < 0)
        throw FileError ("the header gives field " + quoted (names_[i]) + " the unknown type " + types_[i] +
                         " of " + std::to_string (sizes_[i]) + " bytes");
      const std::uint64_t count = counts_.empty () ? 1 : counts_[i];
      bytes += sizes_[i] * count;
      header_.values += count;
      if (bytes > max_point_bytes)
        throw FileError ("the header makes a point larger than " + std::to_string (max_point_bytes) +
                         " bytes");
      appendField (header_.layout, names_[i], static_cast<std::uint8_t> (type), count);
    }
  }

  void checkSize () const
  {
    // Every number of a text file takes a digit and, but for the last one, a separator.
    const bool text = header_.data == PcdHeader::Data::ASCII;
    const std::uint64_t needed =
      text ? 2 * header_.values * header_.points - 1 : header_.points * header_.layout.point_step;
    if (header_.data != PcdHeader::Data::BINARY_COMPRESSED && scanner_.remaining () < needed)
      throw FileError ("truncated or corrupt: the header promises " + std::to_string (header_.points) +
                       " points, which need " + (text ? "at least " : "") + std::to_string (needed) +
                       " bytes, but only " + std::to_string (scanner_.remaining ()) + " follow it at byte " +
                       std::to_string (scanner_.position ()));
    const std::uint64_t row = static_cast<std::uint64_t> (header_.layout.width) * header_.layout.point_step;
    if (row > std::numeric_limits<pcl::uindex_t>::max ())
      throw FileError ("a row of " + std::to_string (header_.layout.width) + " points of " +
                       std::to_string (header_.layout.point_step) + " bytes is more than PCL can hold");
  }

  Scanner& scanner_;
  PcdHeader header_;
  std::vector<std::string> names_;
  std::vector<std::uint64_t> sizes_, counts_;
  std::vector<char> types_;
  std::optional<std::uint64_t> width_, height_, points_;
};

} // namespace

PcdHeader
readPcdHeader (Scanner& scanner)
{
  return PcdHeaderParser (scanner).parse ();
}

} // namespace pcl::manifold
