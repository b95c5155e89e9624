#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/common/io.h>
#include <pcl/manifold/simplicial_complex.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

using pcl::PCLPointCloud2;
using pcl::PCLPointField;
using pcl::SimplicialComplex;

struct Field
{
  std::string name;
  std::uint8_t type;
  pcl::uindex_t count;
};

/** \brief A cloud whose bytes are all zero. */
inline PCLPointCloud2
blankCloud (const std::vector<Field>& fields, std::size_t points)
{
  PCLPointCloud2 cloud;
  for (const Field& field : fields) {
    PCLPointField own;
    own.name = field.name;
    own.datatype = field.type;
    own.count = field.count;
    own.offset = cloud.point_step;
    cloud.point_step += field.count * static_cast<pcl::uindex_t> (pcl::getFieldSize (field.type));
    cloud.fields.push_back (own);
  }
  cloud.height = 1;
  cloud.width = static_cast<pcl::uindex_t> (points);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize (cloud.row_step);
  cloud.is_dense = true;
  return cloud;
}

inline const PCLPointField&
fieldOf (const PCLPointCloud2& cloud, const std::string& name)
{
  for (const PCLPointField& field : cloud.fields)
    if (field.name == name)
      return field;
  throw std::out_of_range ("no field " + name);
}

template <typename T>
T
get (const PCLPointCloud2& cloud, const std::string& name, std::size_t point, std::size_t value = 0)
{
  T result;
  std::memcpy (&result,
               cloud.data.data () + point * cloud.point_step + fieldOf (cloud, name).offset +
                 value * sizeof (T),
               sizeof (T));
  return result;
}

template <typename T>
void
put (PCLPointCloud2& cloud, const std::string& name, std::size_t point, std::size_t value, T what)
{
  std::memcpy (cloud.data.data () + point * cloud.point_step + fieldOf (cloud, name).offset +
                 value * sizeof (T),
               &what, sizeof (T));
}

/** \brief All bytes of all points of one field. */
inline std::vector<std::uint8_t>
bytesOf (const PCLPointCloud2& cloud, const std::string& name)
{
  const PCLPointField& field = fieldOf (cloud, name);
  const std::size_t size =
    std::max (1u, field.count) * static_cast<std::size_t> (pcl::getFieldSize (field.datatype));
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < cloud.width * cloud.height; ++i) {
    const auto first =
      cloud.data.begin () + static_cast<std::ptrdiff_t> (i * cloud.point_step + field.offset);
    bytes.insert (bytes.end (), first, first + static_cast<std::ptrdiff_t> (size));
  }
  return bytes;
}

/** \brief The x, y, z of a few points, in float. */
inline PCLPointCloud2
pointsXYZ (std::size_t points)
{
  PCLPointCloud2 cloud = blankCloud (
    {{"x", PCLPointField::FLOAT32, 1}, {"y", PCLPointField::FLOAT32, 1}, {"z", PCLPointField::FLOAT32, 1}},
    points);
  std::mt19937_64 random (points);
  for (std::size_t i = 0; i < points; ++i)
    for (const char* const name : {"x", "y", "z"})
      put<float> (cloud, name, i, 0, static_cast<float> (random ()) * 1e-19f);
  return cloud;
}

/** \brief Many kinds of fields with random contents. */
inline PCLPointCloud2
richCloud (std::size_t points, std::uint8_t coordinate)
{
  PCLPointCloud2 cloud = blankCloud ({{"intensity", PCLPointField::FLOAT32, 1},
                                      {"x", coordinate, 1},
                                      {"y", coordinate, 1},
                                      {"z", coordinate, 1},
                                      {"rgb", PCLPointField::FLOAT32, 1},
                                      {"label", PCLPointField::UINT32, 1},
                                      {"fpfh", PCLPointField::FLOAT32, 33},
                                      {"time", PCLPointField::FLOAT64, 1},
                                      {"ring", PCLPointField::UINT16, 1},
                                      {"angle", PCLPointField::INT16, 2},
                                      {"class", PCLPointField::UINT8, 1},
                                      {"offset", PCLPointField::INT8, 1},
                                      {"id", PCLPointField::INT32, 1}},
                                     points);
  std::mt19937_64 random (7);
  for (std::uint8_t& byte : cloud.data)
    byte = static_cast<std::uint8_t> (random ());
  for (std::size_t i = 0; i < points; ++i) {
    // Random bits may be a NaN, of which text keeps no more than that it is one.
    put<float> (cloud, "intensity", i, 0, static_cast<float> (i) / 3);
    for (std::size_t k = 0; k < 33; ++k)
      put<float> (cloud, "fpfh", i, k, static_cast<float> (random ()) * 1e-20f);
    put<double> (cloud, "time", i, 0, 1.7e9 + static_cast<double> (i) / 7);
    for (const char* const name : {"x", "y", "z"})
      if (coordinate == PCLPointField::FLOAT64)
        put<double> (cloud, name, i, 0, 5e6 + static_cast<double> (random ()) * 1e-19);
      else
        put<float> (cloud, name, i, 0, static_cast<float> (random ()) * 1e-19f);
    put<std::uint32_t> (cloud, "rgb", i, 0, get<std::uint32_t> (cloud, "rgb", i) | 0xff000000u);
  }
  return cloud;
}

/** \brief Edges, triangles and tetrahedra over ten points. */
inline SimplicialComplex
mixedComplex ()
{
  SimplicialComplex complex;
  complex.edges = {{0, 1}, {1, 2}};
  complex.triangles = {{2, 3, 4}, {4, 3, 5}};
  complex.tetrahedra = {{5, 6, 7, 8}, {6, 7, 8, 9}};
  return complex;
}
