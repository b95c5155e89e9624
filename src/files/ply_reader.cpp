#include "files/cloud_fields.h"
#include "files/formats.h"
#include "files/ply_header.h"
#include "files/simplex_collector.h"

#include <pcl/types.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

namespace pcl::manifold {
namespace {

using Field = pcl::PCLPointField;

/** \brief Reads the body of a PLY file, element by element. */
class PlyReader
{
public:
  explicit PlyReader (std::string_view bytes) : scanner_ (bytes), header_ (readPlyHeader (scanner_)) {}

  FileContent read ()
  {
    for (const PlyElement& element : header_.elements)
      if (element.name == "vertex")
        vertices_ = element.count;
    if (vertices_ > static_cast<std::size_t> (std::numeric_limits<pcl::index_t>::max ()))
      fail ("more vertices than a cloud can have");
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex")
        readVertices (element);
      else if (element.name == "edge")
        readEdges (element);
      else if (element.name == "face")
        readFaces (element);
      else if (element.name == "camera")
        readCamera (element);
      else
        readRows (element, [] {});
    }
    pcl::PCLPointCloud2& cloud = content_.cloud;
    if (rows_ > 1 && vertices_ % rows_ == 0 && vertices_ / rows_ == columns_) {
      cloud.height = static_cast<pcl::uindex_t> (rows_);
      cloud.width = static_cast<pcl::uindex_t> (columns_);
      cloud.row_step = cloud.point_step * cloud.width;
    }
    return std::move (content_);
  }

private:
  [[noreturn]] void fail (const std::string& message) const
  {
    if (header_.encoding == Encoding::TEXT)
      scanner_.failAtLine (message);
    scanner_.failAtByte (message);
  }

  /** \brief Reads one value into this machine's memory. */
  void readValue (ScalarType type, std::uint8_t* out)
  {
    withType (type, [&] (auto value) {
      if (header_.encoding == Encoding::TEXT)
        value = scanner_.number<decltype (value)> ();
      else {
        std::memcpy (&value, scanner_.take (sizeof (value)).data (), sizeof (value));
        if (host_is_big_endian != (header_.encoding == Encoding::BINARY_BIG))
          swapBytes (&value, sizeof (value), 1);
      }
      std::memcpy (out, &value, sizeof (value));
    });
  }

  /** \brief Reads one whole number: the length of a list or an index. */
  std::int64_t readWhole (ScalarType type)
  {
    std::uint8_t value[8];
    readValue (type, value);
    return static_cast<std::int64_t> (toDouble (type, value)); // exact: PLY's integers have 32 bits
  }

  /** \brief Reads the values of one property of one row into values_. */
  void readProperty (const PlyProperty& property)
  {
    std::size_t length = 1;
    if (property.is_list) {
      const std::int64_t stated = readWhole (property.length_type);
      if (stated < 0)
        fail ("a list of negative length");
      length = static_cast<std::size_t> (stated);
    }
    const std::size_t size = sizeOf (property.type);
    const std::size_t least = header_.encoding == Encoding::TEXT ? 2 : size;
    if (length > (scanner_.remaining () + 1) / least)
      fail ("the file ends too early");
    values_.resize (length * size);
    for (std::size_t i = 0; i < length; ++i)
      readValue (property.type, values_.data () + i * size);
  }

  /** \brief Reads all rows of an element; \a take is called after each property, with its values in values_,
   * its number in property_ and the row's in row_. */
  template <typename Function>
  void readRows (const PlyElement& element, Function take)
  {
    if (element.properties.empty ())
      return; // whatever their number, such rows hold nothing
    for (row_ = 0; row_ < element.count; ++row_)
      for (property_ = 0; property_ < element.properties.size (); ++property_) {
        readProperty (element.properties[property_]);
        take ();
      }
  }

  void readVertices (const PlyElement& element)
  {
    if (element.count > 0 && element.properties.empty ())
      fail ("vertices without properties");
    std::vector<CloudColumn> columns;
    std::vector<bool> is_field (element.properties.size (), true);
    for (const PlyProperty& property : element.properties) {
      columns.push_back ({property.name, property.type, 1, {}});
      if (!property.is_list)
        columns.back ().data.reserve (element.count * sizeOf (property.type));
    }
    readRows (element, [&] {
      CloudColumn& column = columns[property_];
      const std::size_t count = values_.size () / sizeOf (column.type);
      if (row_ == 0)
        column.count = count;
      if (count == 0 || count != column.count) {
        is_field[property_] = false;
        column.data = {};
      }
      if (is_field[property_])
        column.data.insert (column.data.end (), values_.begin (), values_.end ());
    });
    std::vector<CloudColumn> fields;
    std::string dropped; // names of the first few
    std::size_t lost = 0;
    for (std::size_t i = 0; i < columns.size (); ++i)
      if (is_field[i])
        fields.push_back (std::move (columns[i]));
      else if (++lost <= 5)
        dropped += (lost == 1 ? "" : ", ") + quoted (columns[i].name);
    if (lost > 0)
      content_.notes.push_back ("left out, lists of the vertices that are empty or of several lengths: " +
                                dropped + (lost > 5 ? ", ..." : ""));
    joinColors (fields);
    content_.cloud = makeCloud (fields, element.count);
  }

  /** \brief Makes one column of red, green, blue and, if there is one, alpha, in the place of red. */
  static void joinColors (std::vector<CloudColumn>& columns)
  {
    std::vector<std::size_t> channels;
    for (const char* const name : {"red", "green", "blue", "alpha"}) {
      const auto column = std::find_if (columns.begin (), columns.end (), [&] (const CloudColumn& c) {
        return c.name == name && c.type == Field::UINT8 && c.count == 1;
      });
      if (column != columns.end ())
        channels.push_back (static_cast<std::size_t> (column - columns.begin ()));
      else if (channels.size () < 3)
        return;
    }
    CloudColumn color{channels.size () == 4 ? "rgba" : "rgb", Field::UINT8, channels.size (), {}};
    const std::size_t points = columns[channels[0]].data.size ();
    color.data.resize (points * color.count);
    for (std::size_t c = 0; c < channels.size (); ++c)
      for (std::size_t i = 0; i < points; ++i)
        color.data[i * color.count + c] = columns[channels[c]].data[i];
    columns[channels[0]] = std::move (color);
    std::sort (channels.begin () + 1, channels.end (), std::greater<> ());
    for (auto c = channels.begin () + 1; c != channels.end (); ++c)
      columns.erase (columns.begin () + static_cast<std::ptrdiff_t> (*c));
  }

  /** \brief The value number i in values_ as a vertex. */
  pcl::index_t vertexAt (ScalarType type, std::size_t i) const
  {
    const double value = toDouble (type, values_.data () + i * sizeOf (type));
    const auto vertex = static_cast<std::int64_t> (value);
    if (vertex < 0 || static_cast<std::size_t> (vertex) >= vertices_)
      fail ("there is no vertex " + std::to_string (vertex));
    return static_cast<pcl::index_t> (vertex);
  }

  static bool isWholeType (ScalarType type) { return type != Field::FLOAT32 && type != Field::FLOAT64; }

  void readEdges (const PlyElement& element)
  {
    std::size_t ends[2] = {element.properties.size (), element.properties.size ()};
    for (std::size_t p = 0; p < element.properties.size (); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.is_list || !isWholeType (property.type))
        continue;
      if (property.name == "vertex1")
        ends[0] = p;
      if (property.name == "vertex2")
        ends[1] = p;
    }
    const std::size_t last = std::max (ends[0], ends[1]);
    SimplexCollector collector (content_.complex);
    pcl::index_t edge[2] = {};
    readRows (element, [&] {
      for (int end = 0; end < 2 && last < element.properties.size (); ++end)
        if (property_ == ends[end])
          edge[end] = vertexAt (element.properties[property_].type, 0);
      if (property_ == last)
        collector.addEdge (edge[0], edge[1]);
    });
  }

  void readFaces (const PlyElement& element)
  {
    SimplexCollector collector (content_.complex);
    pcl::Indices face;
    readRows (element, [&] {
      const PlyProperty& property = element.properties[property_];
      if (!property.is_list || !isWholeType (property.type) ||
          (property.name != "vertex_indices" && property.name != "vertex_index"))
        return;
      face.resize (values_.size () / sizeOf (property.type));
      for (std::size_t i = 0; i < face.size (); ++i)
        face[i] = vertexAt (property.type, i);
      collector.addPolygon (face.data (), face.size ());
    });
  }

  /** \brief Reads where the sensor stood and the layout of an organised cloud, as PCL writes them. */
  void readCamera (const PlyElement& element)
  {
    constexpr const char* names[] = {"view_px", "view_py", "view_pz", "x_axisx", "x_axisy", "x_axisz",
                                     "y_axisx", "y_axisy", "y_axisz", "z_axisx", "z_axisy", "z_axisz"};
    std::array<double, 12> pose{};
    readRows (element, [&] {
      const PlyProperty& property = element.properties[property_];
      if (property.is_list)
        return;
      const double value = toDouble (property.type, values_.data ());
      for (std::size_t k = 0; k < pose.size (); ++k)
        if (property.name == names[k])
          pose[k] = value;
      if (property.name == "viewportx" && value >= 1 && value <= static_cast<double> (vertices_))
        columns_ = static_cast<std::size_t> (value);
      if (property.name == "viewporty" && value >= 1 && value <= static_cast<double> (vertices_))
        rows_ = static_cast<std::size_t> (value);
    });
    const Eigen::Matrix3d axes = Eigen::Map<Eigen::Matrix3d> (pose.data () + 3).transpose ();
    // Other programs write cameras of other kinds.
    if (!(axes * axes.transpose ()).isIdentity (1e-3) || axes.determinant () < 0)
      return;
    const Eigen::Quaterniond q (axes);
    content_.viewpoint = {pose[0], pose[1], pose[2], q.w (), q.x (), q.y (), q.z ()};
  }

  Scanner scanner_;
  const PlyHeader header_;
  FileContent content_;
  std::size_t vertices_ = 0;
  std::size_t columns_ = header_.columns; ///< of an organised cloud, with rows; unchecked
  std::size_t rows_ = header_.rows;
  std::size_t row_ = 0;
  std::size_t property_ = 0;
  std::vector<std::uint8_t> values_;
};

} // namespace

FileContent
readPly (std::string_view bytes)
{
  return PlyReader (bytes).read ();
}

} // namespace pcl::manifold
