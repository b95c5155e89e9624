#include "complex/files/formats.h"
#include "complex/files/scanner.h"
#include "complex/files/simplex_collector.h"
#include "complex/files/value_writer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace pcl {
namespace manifold {

namespace {

using Field = pcl::PCLPointField;

/** \brief Is a coordinate beyond the range of float, or written with more digits than tell every float from
 * every other? */
bool
needsDouble (std::string_view text, double value)
{
  const auto narrow = static_cast<float> (value);
  if (std::isinf (narrow) != std::isinf (value) || (narrow == 0) != (value == 0))
    return true;
  text = text.substr (0, text.find_first_of ("eE"));
  text.remove_prefix (std::min (text.find_first_of ("123456789"), text.size ()));
  return std::count_if (text.begin (), text.end (), [] (unsigned char c) { return std::isdigit (c) != 0; }) >
         std::numeric_limits<float>::max_digits10;
}

/** \brief Reads the statements of an OBJ file, line by line. */
class ObjReader
{
public:
  explicit ObjReader (std::string_view bytes) : scanner_ (bytes) {}

  FileContent read ()
  {
    SimplexCollector collector (content_.complex);
    for (; scanner_.remaining () > 0; scanner_.line ()) {
      const std::string_view keyword = scanner_.wordOnLine ();
      if (keyword == "v")
        readPoint ();
      else if (keyword == "l" || keyword == "f") {
        readIndices ();
        if (keyword == "l")
          collector.addPolyline (indices_.data (), indices_.size ());
        else
          collector.addPolygon (indices_.data (), indices_.size ());
      } else if (!keyword.empty () && keyword[0] != '#' && !isKeyword (keyword))
        scanner_.failAtWord ("a statement", keyword);
    }
    checkLargest ();
    content_.cloud = makeCloud (columns (), coordinates_.size () / 3);
    return std::move (content_);
  }

private:
  /** \brief Statements that mean nothing here are still made of letters, unlike the bytes of other files. */
  static bool isKeyword (std::string_view word)
  {
    return std::all_of (word.begin (), word.end (),
                        [] (unsigned char c) { return std::isalnum (c) != 0 || c == '_'; });
  }

  void readPoint ()
  {
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = scanner_.wordOnLine ();
      double value = 0;
      if (!parseNumber (word, value))
        scanner_.failAtWord ("a coordinate", word);
      coordinates_.push_back (value);
      wide_ = wide_ || needsDouble (word, value);
    }
  }

  /** \brief Reads "7", "7/1", "7//3", "7/1/3", "-1", ... to the end of the line. */
  void readIndices ()
  {
    indices_.clear ();
    for (std::string_view word = scanner_.wordOnLine (); !word.empty () && word[0] != '#';
         word = scanner_.wordOnLine ()) {
      pcl::index_t index = 0;
      if (!parseNumber (word.substr (0, word.find ('/')), index) || index == 0)
        scanner_.failAtWord ("the number of a point", word);
      const auto points = static_cast<std::int64_t> (coordinates_.size () / 3);
      const std::int64_t vertex = index > 0 ? index - std::int64_t (1) : points + index;
      if (vertex < 0)
        scanner_.failAtLine ("there is no point " + std::to_string (index));
      if (vertex > largest_) {
        largest_ = static_cast<pcl::index_t> (vertex);
        largest_end_ = scanner_.position ();
      }
      indices_.push_back (static_cast<pcl::index_t> (vertex));
    }
  }

  /** \brief A face may stand before its points, so that this is known at the end only. */
  void checkLargest ()
  {
    if (largest_ < static_cast<std::int64_t> (coordinates_.size () / 3))
      return;
    scanner_.seek (largest_end_);
    scanner_.wordOnLine ();
    scanner_.failAtLine ("there is no point " + std::to_string (static_cast<std::int64_t> (largest_) + 1));
  }

  std::vector<CloudColumn> columns () const
  {
    const std::size_t size = wide_ ? sizeof (double) : sizeof (float);
    std::vector<CloudColumn> columns;
    for (std::size_t k = 0; k < 3; ++k) {
      columns.push_back ({std::string (1, static_cast<char> ('x' + k)),
                          static_cast<ScalarType> (wide_ ? Field::FLOAT64 : Field::FLOAT32),
                          1,
                          {}});
      std::vector<std::uint8_t>& data = columns.back ().data;
      data.resize (coordinates_.size () / 3 * size);
      for (std::size_t i = 0; i < coordinates_.size () / 3; ++i) {
        const double value = coordinates_[3 * i + k];
        const auto narrow = static_cast<float> (value);
        std::memcpy (data.data () + i * size, wide_ ? static_cast<const void*> (&value) : &narrow, size);
      }
    }
    return columns;
  }

  Scanner scanner_;
  FileContent content_;
  std::vector<double> coordinates_;
  bool wide_ = false; ///< is float not enough for some coordinate?
  pcl::Indices indices_;
  pcl::index_t largest_ = -1;   ///< vertex of any line or face
  std::size_t largest_end_ = 0; ///< where it was read
};

void
writeRow (ValueWriter& writer, const char* keyword, const pcl::index_t* begin, const pcl::index_t* end)
{
  writer.text (keyword);
  for (const pcl::index_t* v = begin; v != end; ++v)
    writer.value (static_cast<std::int64_t> (*v) + 1);
  writer.endRow ();
}

template <std::size_t N>
void
writeRows (ValueWriter& writer, const char* keyword,
           const std::vector<std::array<pcl::index_t, N>>& simplices)
{
  for (const auto& simplex : simplices)
    writeRow (writer, keyword, simplex.data (), simplex.data () + N);
}

} // namespace

FileContent
readObj (std::string_view bytes)
{
  return ObjReader (bytes).read ();
}

void
writeObj (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool /* always text */)
{
  ValueWriter writer (file, Encoding::TEXT);
  writer.text ("# written by pcl_manifold\n");
  const auto xyz = cloud.coordinates ();
  for (std::size_t i = 0; i < cloud.points (); ++i) {
    writer.text ("v ");
    for (const CloudField& field : xyz)
      writer.values (field.type, cloud.point (i) + field.offset, 1);
    writer.endRow ();
  }
  writeRows (writer, "l ", cells.complex.edges);
  writeRows (writer, "f ", cells.complex.triangles);
  writeRows (writer, "f ", boundaryTriangles (cells.complex.tetrahedra));
  const FaceRows& polygons = cells.polygons;
  for (std::size_t f = 0; f < polygons.size (); ++f)
    writeRow (writer, "f ", polygons.vertices.data () + polygons.starts[f],
              polygons.vertices.data () + polygons.starts[f + 1]);
  writer.finish ();
}

} // namespace manifold
} // namespace pcl
