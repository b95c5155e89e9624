#include "files/formats.h"
#include "files/scanner.h"
#include "files/simplex_collector.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace pcl::manifold {
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
  explicit ObjReader (std::string_view bytes)
    : scanner_ (bytes), most_points_ (bytes.size () / std::strlen ("v 0 0 0"))
  {}

  FileContent read ()
  {
    SimplexCollector collector (content_.complex);
    for (; scanner_.remaining () > 0; scanner_.line ()) {
      const std::string_view keyword = scanner_.wordOnLine ();
      if (keyword == "v")
        readPoint ();
      else if (keyword == "vn")
        readNormal ();
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
    std::vector<CloudColumn> columns = coordinateColumns ();
    takeColors (columns);
    takeNormals (columns);
    content_.cloud = makeCloud (columns, points ());
    return std::move (content_);
  }

private:
  /** \brief Statements that mean nothing here are still made of letters, unlike the bytes of other files. */
  static bool isKeyword (std::string_view word)
  {
    return std::all_of (word.begin (), word.end (),
                        [] (unsigned char c) { return std::isalnum (c) != 0 || c == '_'; });
  }

  std::size_t points () const { return coordinates_.size () / 3; }

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
    float color[3];
    for (float& channel : color)
      if (!parseNumber (scanner_.wordOnLine (), channel))
        return; // fewer numbers are a weight
    colors_.insert (colors_.end (), color, color + 3);
  }

  void readNormal ()
  {
    float normal[3] = {};
    for (float& coordinate : normal) {
      const std::string_view word = scanner_.wordOnLine ();
      if (!parseNumber (word, coordinate))
        scanner_.failAtWord ("a coordinate", word);
    }
    normals_.insert (normals_.end (), normal, normal + 3);
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
      const std::int64_t vertex =
        index > 0 ? index - std::int64_t (1) : static_cast<std::int64_t> (points ()) + index;
      if (vertex < 0)
        scanner_.failAtLine ("there is no point " + std::to_string (index));
      if (vertex > largest_) {
        largest_ = static_cast<pcl::index_t> (vertex);
        largest_end_ = scanner_.position ();
      }
      indices_.push_back (static_cast<pcl::index_t> (vertex));
      noteNormal (static_cast<std::size_t> (vertex), word);
    }
  }

  /** \brief Notes which normal "7//3" or "7/1/3" gives to a point. */
  void noteNormal (std::size_t vertex, std::string_view word)
  {
    const std::size_t slash = word.rfind ('/');
    std::int64_t index = 0;
    if (slash == word.find ('/') || !parseNumber (word.substr (slash + 1), index) || index == 0)
      return;
    if (index < 0)
      index += static_cast<std::int64_t> (normals_.size () / 3) + 1;
    if (vertex >= normal_of_.size () && vertex < most_points_)
      normal_of_.resize (vertex + 1, 0);
    if (vertex >= normal_of_.size () || (normal_of_[vertex] != 0 && normal_of_[vertex] != index))
      one_normal_each_ = false;
    else
      normal_of_[vertex] = index;
  }

  /** \brief A face may stand before its points, so that this is known at the end only. */
  void checkLargest ()
  {
    if (largest_ < static_cast<std::int64_t> (points ()))
      return;
    scanner_.seek (largest_end_);
    scanner_.wordOnLine ();
    scanner_.failAtLine ("there is no point " + std::to_string (static_cast<std::int64_t> (largest_) + 1));
  }

  template <typename Number>
  static CloudColumn makeColumn (const std::string& name, ScalarType type, const std::vector<Number>& values)
  {
    const auto* bytes = reinterpret_cast<const std::uint8_t*> (values.data ());
    return {name, type, 1, {bytes, bytes + values.size () * sizeof (Number)}};
  }

  std::vector<CloudColumn> coordinateColumns () const
  {
    std::vector<CloudColumn> columns;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string name (1, "xyz"[k]);
      std::vector<double> values (points ());
      for (std::size_t i = 0; i < points (); ++i)
        values[i] = coordinates_[3 * i + k];
      if (wide_)
        columns.push_back (makeColumn (name, Field::FLOAT64, values));
      else
        columns.push_back (
          makeColumn (name, Field::FLOAT32, std::vector<float> (values.begin (), values.end ())));
    }
    return columns;
  }

  /** \brief Adds the colours if every point has one. They go from 0 to 1, or to 255 if one is larger than 1. */
  void takeColors (std::vector<CloudColumn>& columns)
  {
    if (colors_.empty ())
      return;
    if (colors_.size () != coordinates_.size ()) {
      content_.notes.push_back ("colours left out: not every point has one");
      return;
    }
    const float white = *std::max_element (colors_.begin (), colors_.end ()) > 1 ? 1 : 255;
    CloudColumn column{"rgb", Field::UINT8, 3, {}};
    for (const float channel : colors_) {
      const float scaled = std::isfinite (channel) ? channel * white : 0;
      column.data.push_back (static_cast<std::uint8_t> (std::lround (std::clamp (scaled, 0.f, 255.f))));
    }
    columns.push_back (std::move (column));
  }

  /** \brief Adds the normals if every point has one: by the faces, or in their order. */
  void takeNormals (std::vector<CloudColumn>& columns)
  {
    const std::size_t normals = normals_.size () / 3;
    if (normals == 0)
      return;
    if (normal_of_.empty () && normals == points ())
      for (std::size_t i = 0; i < points (); ++i)
        normal_of_.push_back (static_cast<std::int64_t> (i) + 1);
    const bool known = std::all_of (normal_of_.begin (), normal_of_.end (), [&] (std::int64_t normal) {
      return normal > 0 && static_cast<std::size_t> (normal) <= normals;
    });
    if (!one_normal_each_ || !known || normal_of_.size () != points ()) {
      content_.notes.push_back ("normals left out: not every point has one of its own");
      return;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<float> values (points ());
      for (std::size_t i = 0; i < points (); ++i)
        values[i] = normals_[3 * static_cast<std::size_t> (normal_of_[i] - 1) + k];
      columns.push_back (makeColumn (std::string ("normal_") + "xyz"[k], Field::FLOAT32, values));
    }
  }

  Scanner scanner_;
  const std::size_t most_points_; ///< that the file can hold
  FileContent content_;
  std::vector<double> coordinates_;
  std::vector<float> colors_;
  std::vector<float> normals_;
  std::vector<std::int64_t> normal_of_; ///< of each point, counted from 1; 0 for none
  bool one_normal_each_ = true;         ///< has no point two of them?
  bool wide_ = false;                   ///< is float not enough for some coordinate?
  pcl::Indices indices_;
  pcl::index_t largest_ = -1;   ///< vertex of any line or face
  std::size_t largest_end_ = 0; ///< where it was read
};

} // namespace

FileContent
readObj (std::string_view bytes)
{
  return ObjReader (bytes).read ();
}

} // namespace pcl::manifold
