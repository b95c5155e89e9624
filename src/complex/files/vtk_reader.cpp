#include "complex/files/formats.h"
#include "complex/files/vtk_data.h"
#include "complex/files/vtk_values.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

using Field = pcl::PCLPointField;

/** \brief VTK writes blanks and other special characters of names as %20 and so on. */
std::string
decodeName (std::string_view word)
{
  std::string name;
  for (std::size_t i = 0; i < word.size (); ++i) {
    unsigned char code = 0;
    const std::string_view digits = word.substr (i + 1, 2);
    if (word[i] == '%' && digits.size () == 2 &&
        std::from_chars (digits.data (), digits.data () + 2, code, 16).ptr == digits.data () + 2) {
      name += static_cast<char> (code);
      i += 2;
    } else
      name += word[i];
  }
  return name;
}

/** \brief Reads a legacy VTK file, section by section. */
class VtkReader
{
public:
  explicit VtkReader (std::string_view bytes) : values_ (bytes) {}

  FileContent read ()
  {
    readHeader ();
    for (std::string keyword = nextKeyword (); !keyword.empty (); keyword = nextKeyword ())
      readSection (keyword);
    return assembleVtk (points_, std::move (arrays_), cells_);
  }

private:
  /** \brief The next word in lower case. */
  std::string nextKeyword ()
  {
    std::string keyword (scanner_.word ());
    std::transform (keyword.begin (), keyword.end (), keyword.begin (),
                    [] (unsigned char c) { return static_cast<char> (std::tolower (c)); });
    return keyword;
  }

  void expect (const std::string& keyword)
  {
    if (const std::string found = nextKeyword (); found != keyword)
      scanner_.failAtWord (quoted (keyword), found);
  }

  std::size_t readCount () { return scanner_.number<std::size_t> (); }

  void readHeader ()
  {
    const std::string_view start = "# vtk DataFile Version ";
    const std::string_view first = scanner_.line ();
    if (first.substr (0, start.size ()) != start)
      scanner_.failAtLine ("not a legacy VTK file");
    // Since version 5, cells are written as offsets and connectivity.
    const std::string_view version = first.substr (start.size ());
    has_offsets_ = !version.empty () && version[0] >= '5' && version[0] <= '9';
    scanner_.line (); // the title
    const std::string encoding = nextKeyword ();
    if (encoding != "ascii" && encoding != "binary")
      scanner_.failAtWord ("ASCII or BINARY", encoding);
    values_.ascii = encoding == "ascii";
    expect ("dataset");
    const std::string kind = nextKeyword ();
    if (kind != "unstructured_grid" && kind != "polydata")
      scanner_.failAtWord ("UNSTRUCTURED_GRID or POLYDATA", kind);
  }

  void readSection (const std::string& keyword)
  {
    if (keyword == "points") {
      const std::size_t count = readCount ();
      points_ = values_.readTyped (keyword, count, 3);
    } else if (keyword == "cells")
      readCells ();
    else if (keyword == "cell_types") {
      const std::size_t count = readCount ();
      cells_.types = values_.readIntegers (count);
    } else if (keyword == "vertices")
      readCellsOfType (VTK_CELL_POLY_VERTEX);
    else if (keyword == "lines")
      readCellsOfType (VTK_CELL_POLY_LINE);
    else if (keyword == "polygons")
      readCellsOfType (VTK_CELL_POLYGON);
    else if (keyword == "triangle_strips")
      readCellsOfType (VTK_CELL_TRIANGLE_STRIP);
    else if (keyword == "point_data" || keyword == "cell_data") {
      of_points_ = keyword == "point_data";
      tuples_ = readCount ();
    } else if (keyword == "metadata")
      skipMetadata ();
    else if (keyword == "field")
      readFields ();
    else if (keyword == "lookup_table")
      readLookupTable ();
    else
      readAttribute (keyword);
  }

  /** \brief Reads cells behind the ones that there are. */
  void readCells ()
  {
    const std::size_t first = readCount (), second = readCount ();
    const auto shift = static_cast<std::int64_t> (cells_.vertices.size ());
    if (has_offsets_) {
      expect ("offsets");
      const std::vector<std::int64_t> offsets = wholeValues (values_.readTyped ("OFFSETS", first, 1));
      expect ("connectivity");
      const std::vector<std::int64_t> vertices = wholeValues (values_.readTyped ("CONNECTIVITY", second, 1));
      for (std::size_t i = 1; i < offsets.size (); ++i) {
        if (offsets[i] < 0 || static_cast<std::size_t> (offsets[i]) > vertices.size ())
          scanner_.failAtLine ("an offset beyond the list of vertices");
        cells_.ends.push_back (shift + offsets[i]);
      }
      cells_.vertices.insert (cells_.vertices.end (), vertices.begin (), vertices.end ());
      return;
    }
    const std::vector<std::int64_t> rows = values_.readIntegers (second);
    std::size_t at = 0;
    for (std::size_t c = 0; c < first; ++c) {
      const std::int64_t size = at < rows.size () ? rows[at++] : -1;
      if (size < 0 || static_cast<std::size_t> (size) > rows.size () - at)
        scanner_.failAtLine ("cell " + std::to_string (c) + " is outside of the list of cells");
      const auto begin = rows.begin () + static_cast<std::ptrdiff_t> (at);
      cells_.vertices.insert (cells_.vertices.end (), begin, begin + size);
      cells_.ends.push_back (static_cast<std::int64_t> (cells_.vertices.size ()));
      at += static_cast<std::size_t> (size);
    }
  }

  void readCellsOfType (VtkCellType type)
  {
    readCells ();
    cells_.types.resize (cells_.ends.size (), type);
  }

  /** \brief Reads point or cell data that begin with a keyword and a name. */
  void readAttribute (const std::string& keyword)
  {
    const std::string name = decodeName (scanner_.wordOnLine ());
    if (keyword == "scalars")
      keep (readScalars (name));
    else if (keyword == "color_scalars") {
      const std::size_t components = readCount ();
      keep (readColors (name, components));
    } else if (keyword == "vectors" || keyword == "normals")
      keep (values_.readTyped (name, tuples_, 3));
    else if (keyword == "tensors")
      keep (values_.readTyped (name, tuples_, 9));
    else if (keyword == "texture_coordinates") {
      const std::size_t components = readCount ();
      keep (values_.readTyped (name, tuples_, components));
    } else if (keyword == "global_ids" || keyword == "pedigree_ids")
      keep (values_.readTyped (name, tuples_, 1));
    else
      scanner_.failAtWord ("a section of a VTK file", keyword);
  }

  /** \brief Type, number of components (1 if left out), and the lookup table's name on the next line. */
  VtkArray readScalars (const std::string& name)
  {
    const ScalarType type = values_.readType ();
    std::size_t components = 1;
    const std::string_view word = scanner_.wordOnLine ();
    if (!word.empty () && !parseNumber (word, components))
      scanner_.failAtWord ("a number of components", word);
    const std::size_t behind = scanner_.position ();
    if (nextKeyword () == "lookup_table")
      scanner_.wordOnLine ();
    else
      scanner_.seek (behind);
    return values_.readArray (name, type, tuples_, components);
  }

  /** \brief Bytes, or in text fractions of 255. */
  VtkArray readColors (const std::string& name, std::size_t components)
  {
    if (!values_.ascii)
      return values_.readArray (name, Field::UINT8, tuples_, components);
    const VtkArray fractions = values_.readArray (name, Field::FLOAT32, tuples_, components);
    VtkArray colors{name, Field::UINT8, components, {}};
    for (std::size_t i = 0; i < fractions.values (); ++i) {
      const double fraction = toDouble (Field::FLOAT32, fractions.data.data () + i * sizeof (float));
      colors.data.push_back (
        static_cast<std::uint8_t> (fraction > 0 ? std::lround (255 * std::min (fraction, 1.0)) : 0));
    }
    return colors;
  }

  /** \brief Colours of scalars, which are nothing to a complex. */
  void readLookupTable ()
  {
    scanner_.word ();
    const std::size_t entries = readCount ();
    values_.readArray ("", values_.ascii ? Field::FLOAT32 : Field::UINT8, entries, 4);
  }

  /** \brief A name for all, their number, and for each name, components, tuples, type. */
  void readFields ()
  {
    scanner_.word ();
    const std::size_t count = readCount ();
    for (std::size_t i = 0; i < count; ++i) {
      std::string name = decodeName (scanner_.word ());
      while (name == "METADATA") { // of the array before
        skipMetadata ();
        name = decodeName (scanner_.word ());
      }
      if (name == "NULL_ARRAY")
        continue;
      const std::size_t components = readCount (), tuples = readCount ();
      keep (values_.readTyped (name, tuples, components));
    }
  }

  /** \brief Lines up to a blank one. */
  void skipMetadata ()
  {
    scanner_.line ();
    while (scanner_.remaining () > 0 && !scanner_.line ().empty ()) {
    }
  }

  void keep (VtkArray array)
  {
    if (of_points_)
      arrays_.push_back (std::move (array));
  }

  VtkValues values_;
  Scanner& scanner_ = values_.scanner;
  bool has_offsets_ = false;
  bool of_points_ = false;
  std::size_t tuples_ = 0; ///< of the current point or cell data
  VtkArray points_{"points", Field::FLOAT32, 3, {}};
  std::vector<VtkArray> arrays_; ///< point data
  VtkCells cells_;
};

} // namespace

FileContent
readVtk (std::string_view bytes)
{
  return VtkReader (bytes).read ();
}

} // namespace manifold
} // namespace pcl
