#pragma once

#include "app_error.h"
#include "cloud_reader.h"
#include "files/cloud_fields.h"
#include "test_apps_folder.h"

#include <cmath>
#include <string>

namespace pcl::manifold::apps {

inline void
expectSameFields (const pcl::PCLPointCloud2& expected, const pcl::PCLPointCloud2& cloud)
{
  EXPECT_EQ (expected.width, cloud.width);
  EXPECT_EQ (expected.height, cloud.height);
  ASSERT_EQ (expected.fields.size (), cloud.fields.size ());
  for (std::size_t i = 0; i < cloud.fields.size (); ++i) {
    EXPECT_EQ (expected.fields[i].name, cloud.fields[i].name);
    EXPECT_EQ (expected.fields[i].datatype, cloud.fields[i].datatype);
    EXPECT_EQ (expected.fields[i].count, cloud.fields[i].count);
  }
  EXPECT_EQ (expected.data, cloud.data);
}

inline double
valueAt (const pcl::PCLPointCloud2& cloud, const std::string& name, std::size_t point)
{
  const pcl::PCLPointField* field = findField (cloud, name);
  EXPECT_NE (field, nullptr) << name;
  return field == nullptr ? std::nan ("")
                          : toDouble (field->datatype, &cloud.data[point * cloud.point_step + field->offset]);
}

/** \brief What readCloud () says about a bad file; empty if it reads it. */
inline std::string
readingError (const std::string& file)
{
  return messageOf<AppError> ([&file] { readCloud (file); });
}

} // namespace pcl::manifold::apps
