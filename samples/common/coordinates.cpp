#include "coordinates.h"

#include "app_error.h"
#include "files/cloud_fields.h"

#include <pcl/PCLPointField.h>

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

/** \brief The origin to shift to: zeros where floats resolve the cloud as it is. Points that are not finite
 * do not count. */
std::array<double, 3>
originOf (const std::array<Axis, 3>& axes)
{
  constexpr double infinity = std::numeric_limits<double>::infinity ();
  std::array<double, 3> low{infinity, infinity, infinity};
  std::array<double, 3> high{-infinity, -infinity, -infinity};
  for (std::size_t i = 0; i < axes[0].size (); ++i) {
    const std::array<double, 3> point{axes[0][i], axes[1][i], axes[2][i]};
    if (!std::all_of (point.begin (), point.end (), [] (double value) { return std::isfinite (value); }))
      continue;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min (low[axis], point[axis]);
      high[axis] = std::max (high[axis], point[axis]);
    }
  }
  double extent = 0;
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    extent = std::max (extent, high[axis] - low[axis]);
    largest = std::max ({largest, std::abs (low[axis]), std::abs (high[axis])});
  }
  // Within 16 extents of zero a float still resolves a millionth of the extent. (No finite point: no extent.)
  if (!(extent > 0) || !(largest > 16 * extent))
    return {};
  const double step = std::pow (10.0, std::ceil (std::log10 (extent)));
  std::array<double, 3> origin{};
  for (int axis = 0; axis < 3; ++axis)
    origin[axis] = std::round ((low[axis] + (high[axis] - low[axis]) / 2) / step) * step;
  return origin;
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

std::array<double, 3>
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
  const std::array<double, 3> origin = originOf (axes);
  for (int i = 0; i < 3; ++i)
    replaceAxis (cloud, "xyz"[i], axes[i], origin[i], file);
  return origin;
}

} // namespace pcl::manifold::apps
