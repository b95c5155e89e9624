#include <pcl/manifold/detail/guarded.h>
#include <pcl/manifold/mesh_pieces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

namespace {

/** \brief Reads the coordinates of single points of a cloud. */
class Coordinates
{
public:
  explicit Coordinates (const pcl::PCLPointCloud2& cloud)
    : cloud_ (cloud), points_ (static_cast<std::size_t> (cloud.width) * cloud.height)
  {
    const std::array<const char*, 3> names = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto field = std::find_if (cloud.fields.begin (), cloud.fields.end (),
                                       [&] (const auto& some) { return some.name == names[axis]; });
      if (field == cloud.fields.end () ||
          (field->datatype != pcl::PCLPointField::FLOAT32 && field->datatype != pcl::PCLPointField::FLOAT64))
        return;
      is_double_[axis] = field->datatype == pcl::PCLPointField::FLOAT64;
      offset_[axis] = field->offset;
      if (offset_[axis] + (is_double_[axis] ? sizeof (double) : sizeof (float)) > cloud.point_step)
        return;
    }
    complete_ = cloud.data.size () >= points_ * cloud.point_step;
  }

  /** \brief Whether there are three coordinates a point. */
  bool complete () const { return complete_; }

  bool has (pcl::index_t point) const { return point >= 0 && static_cast<std::size_t> (point) < points_; }

  Eigen::Vector3d operator[] (pcl::index_t point) const
  {
    const std::uint8_t* const data =
      cloud_.data.data () + static_cast<std::size_t> (point) * cloud_.point_step;
    Eigen::Vector3d result;
    for (std::size_t axis = 0; axis < 3; ++axis)
      result[static_cast<Eigen::Index> (axis)] =
        is_double_[axis] ? read<double> (data + offset_[axis]) : read<float> (data + offset_[axis]);
    return result;
  }

private:
  template <typename T>
  static T read (const std::uint8_t* from)
  {
    T value;
    std::memcpy (&value, from, sizeof (T));
    return value;
  }

  const pcl::PCLPointCloud2& cloud_;
  std::size_t points_ = 0;
  std::array<std::size_t, 3> offset_{};
  std::array<bool, 3> is_double_{};
  bool complete_ = false;
};

Status
collect (const pcl::PolygonMesh& mesh, FlatPieces& pieces)
{
  const Coordinates coordinates (mesh.cloud);
  if (!coordinates.complete ())
    return Status::PARAMETER_OUT_OF_RANGE;
  std::vector<pcl::index_t> used;
  for (const pcl::Vertices& polygon : mesh.polygons) {
    const pcl::Indices& corners = polygon.vertices;
    if (!std::all_of (corners.begin (), corners.end (),
                      [&] (pcl::index_t point) { return coordinates.has (point); }))
      return Status::PARAMETER_OUT_OF_RANGE;
    if (corners.size () < 3)
      continue;
    used.insert (used.end (), corners.begin (), corners.end ());
    for (std::size_t i = 2; i < corners.size (); ++i)
      pieces.triangles.push_back ({corners[0], corners[i - 1], corners[i]});
  }
  if (pieces.triangles.empty ())
    return Status::PARAMETER_OUT_OF_RANGE;

  // The points that no face has may be anything.
  std::sort (used.begin (), used.end ());
  used.erase (std::unique (used.begin (), used.end ()), used.end ());
  for (auto& triangle : pieces.triangles)
    for (std::int32_t& vertex : triangle)
      vertex =
        static_cast<std::int32_t> (std::lower_bound (used.begin (), used.end (), vertex) - used.begin ());
  pieces.vertices.resize (3, static_cast<Eigen::Index> (used.size ()));
  for (std::size_t i = 0; i < used.size (); ++i)
    pieces.vertices.col (static_cast<Eigen::Index> (i)) = coordinates[used[i]];
  return pieces.vertices.allFinite () ? Status::OK : Status::PARAMETER_OUT_OF_RANGE;
}

} // namespace

Status
meshPieces (const pcl::PolygonMesh& mesh, FlatPieces& pieces) noexcept
{
  pieces = FlatPieces ();
  const Status status = guarded ([&] { return collect (mesh, pieces); });
  if (status != Status::OK)
    pieces = FlatPieces ();
  return status;
}

} // namespace manifold
} // namespace pcl
