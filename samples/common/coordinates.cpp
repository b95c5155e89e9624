#include "coordinates.h"

#include "app_error.h"
#include "files/cloud_fields.h"

#include <pcl/PCLPointField.h>
#include <pcl/manifold/bulk_box.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace pcl::manifold::apps {
namespace {

using Axis = std::vector<double>;

const pcl::PCLPointField&
axisField (const pcl::PCLPointCloud2& cloud, char axis, const std::string& file)
{
  const pcl::PCLPointField* field = findField (cloud, std::string (1, axis));
  if (field == nullptr)
    throw AppError (file, std::string ("has no field '") + axis + "'");
  if (field->count > 1)
    throw AppError (file, std::string ("field '") + axis + "' has " + std::to_string (field->count) +
                            " values per point instead of one");
  return *field;
}

Axis
valuesOf (const pcl::PCLPointCloud2& cloud, const pcl::PCLPointField& field)
{
  Axis values (static_cast<std::size_t> (cloud.width) * cloud.height);
  for (std::size_t i = 0; i < values.size (); ++i)
    values[i] = toDouble (field.datatype, &cloud.data[i * cloud.point_step + field.offset]);
  return values;
}

Eigen::Matrix3Xd
pointsOf (const std::array<Axis, 3>& axes)
{
  Eigen::Matrix3Xd points (3, static_cast<Eigen::Index> (axes[0].size ()));
  for (Eigen::Index i = 0; i < points.cols (); ++i)
    for (int axis = 0; axis < 3; ++axis)
      points (axis, i) = axes[axis][static_cast<std::size_t> (i)];
  return points;
}

/** \brief The origin to shift to: zeros where floats resolve the bulk of the cloud as it is. */
std::array<double, 3>
originOf (const std::array<Axis, 3>& axes)
{
  const Eigen::AlignedBox3d bulk = bulkBox (pointsOf (axes));
  if (bulk.isEmpty ())
    return {};
  const double extent = bulk.sizes ().maxCoeff ();
  const double largest = std::max (bulk.min ().cwiseAbs ().maxCoeff (), bulk.max ().cwiseAbs ().maxCoeff ());
  // Within 16 extents of zero a float still resolves a millionth of the extent.
  if (!(extent > 0) || !(largest > 16 * extent))
    return {};
  const double step = std::pow (10.0, std::ceil (std::log10 (extent)));
  std::array<double, 3> origin{};
  for (int axis = 0; axis < 3; ++axis)
    // Adding zero turns -0 into 0.
    origin[axis] = std::round ((bulk.min ()[axis] + bulk.sizes ()[axis] / 2) / step) * step + 0.0;
  return origin;
}

/** \brief Makes points at (0, 0, 0) NaN if there are two or more.
 * \return how many there were */
std::size_t
dropZeros (std::array<Axis, 3>& axes)
{
  std::vector<std::size_t> zeros;
  for (std::size_t i = 0; i < axes[0].size (); ++i)
    if (axes[0][i] == 0 && axes[1][i] == 0 && axes[2][i] == 0)
      zeros.push_back (i);
  if (zeros.size () < 2)
    return 0;
  for (const std::size_t i : zeros)
    for (Axis& axis : axes)
      axis[i] = std::numeric_limits<double>::quiet_NaN ();
  return zeros.size ();
}

/** \brief Replaces the field by a FLOAT32 one in its place. */
void
replaceAxis (pcl::PCLPointCloud2& cloud, char axis, const Axis& values, double origin,
             const std::string& file)
{
  std::vector<float> floats (values.size ());
  for (std::size_t i = 0; i < values.size (); ++i) {
    const double value = values[i] - origin;
    if (std::isfinite (value) && std::abs (value) > std::numeric_limits<float>::max ())
      throw AppError (file, std::string ("coordinate '") + axis + "' of point " + std::to_string (i) +
                              " is larger than PCL's floats can hold");
    floats[i] = static_cast<float> (value);
  }
  setField (cloud, std::string (1, axis), floats);
}

} // namespace

CoordinateShift
makeCoordinatesFloat (pcl::PCLPointCloud2& cloud, const std::string& file)
{
  std::array<Axis, 3> axes;
  bool floats = true;
  for (const char axis : {'x', 'y', 'z'})
    floats = axisField (cloud, axis, file).datatype == pcl::PCLPointField::FLOAT32 && floats;
  if (floats)
    return {};
  for (int i = 0; i < 3; ++i)
    axes[i] = valuesOf (cloud, axisField (cloud, "xyz"[i], file));
  CoordinateShift shift;
  shift.origin = originOf (axes);
  if (shift.origin != std::array<double, 3>{})
    shift.no_measurement = dropZeros (axes);
  for (int i = 0; i < 3; ++i)
    replaceAxis (cloud, "xyz"[i], axes[i], shift.origin[i], file);
  return shift;
}

} // namespace pcl::manifold::apps
