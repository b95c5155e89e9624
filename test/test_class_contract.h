#pragma once

#include "test_class_clouds.h"

#include <gtest/gtest.h>
#include <pcl/search/kdtree.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

/** What every public class keeps to. A `Run` gives
 *   Class object;                      with setters and getStatus ()
 *   bool operator() ()                 computes; true if the output is empty and all getters give nothing
 */
namespace class_contract {

using namespace class_clouds;
using pcl::manifold::Status;

template <typename Run>
void
expectFailure (Run& run, Status status)
{
  EXPECT_TRUE (run ());
  EXPECT_EQ (run.object.getStatus (), status) << pcl::manifold::toString (run.object.getStatus ());
}

template <typename Run>
void
checkInputs ()
{
  Run run;
  EXPECT_EQ (run.object.getStatus (), Status::NOT_COMPUTED);
  expectFailure (run, Status::NO_INPUT);
  run.object.setInputCloud (std::make_shared<Cloud> ());
  expectFailure (run, Status::NO_INPUT);
  run.object.setInputCloud (cloudOf (std::vector<Eigen::Vector3f> (10, {NOT_A_NUMBER, 0.0f, 0.0f})));
  expectFailure (run, Status::NO_INPUT);

  // After failures the same object still works.
  run.object.setInputCloud (cloudOf (torusAndKnot ()));
  EXPECT_FALSE (run ());
  EXPECT_EQ (run.object.getStatus (), Status::OK);

  run.object.setInputCloud (cloudOf (transformed (torusAndKnot (), 0.1f, {0.0f, 5569975.0f, 0.0f})));
  expectFailure (run, Status::INPUT_TOO_COARSE);
}

template <typename Run>
void
checkIndices ()
{
  Run run;
  run.object.setInputCloud (cloudOf (torusAndKnot ()));
  run.object.setIndices (std::make_shared<pcl::Indices> ());
  expectFailure (run, Status::NO_INPUT);
  for (const pcl::Indices& wrong : {pcl::Indices{0, 1, 2, 1000000}, pcl::Indices{-1, 0, 1, 2}}) {
    run.object.setIndices (std::make_shared<pcl::Indices> (wrong));
    expectFailure (run, Status::PARAMETER_OUT_OF_RANGE);
  }
}

template <typename Run>
void
checkRho ()
{
  for (const double rho : {0.0, -0.5, 1.5, std::nan ("")}) {
    Run run;
    run.object.setInputCloud (cloudOf (torusAndKnot ()));
    run.object.setRho (rho);
    expectFailure (run, Status::PARAMETER_OUT_OF_RANGE);
    run.object.setRho (0.3);
    EXPECT_EQ (run.object.getRho (), 0.3);
    EXPECT_FALSE (run ());
  }
}

template <typename Run>
void
checkThinning ()
{
  for (const double spacing : {-1.0, std::nan (""), HUGE_VAL}) {
    Run run;
    run.object.setInputCloud (cloudOf (torusAndKnot ()));
    run.object.setThinningDistance (spacing);
    expectFailure (run, Status::PARAMETER_OUT_OF_RANGE);
  }
  Run run;
  run.object.setInputCloud (cloudOf (torusAndKnot ()));
  run.object.setThinningNeighbors (-1);
  expectFailure (run, Status::PARAMETER_OUT_OF_RANGE);
}

/** Cancels at every call of the callback in turn, and throws there. */
template <typename Run>
void
checkProgress ()
{
  std::vector<float> fractions;
  {
    Run run;
    run.object.setInputCloud (cloudOf (torusAndKnot ()));
    run.object.setProgressCallback ([&] (float fraction) {
      fractions.push_back (fraction);
      return true;
    });
    EXPECT_FALSE (run ());
  }
  ASSERT_GE (fractions.size (), 4U);
  EXPECT_TRUE (std::is_sorted (fractions.begin (), fractions.end ()));
  EXPECT_GE (fractions.front (), 0.0f);
  EXPECT_LE (fractions.back (), 1.0f);
  for (std::size_t stop = 0; stop < fractions.size (); ++stop) {
    Run run;
    run.object.setInputCloud (cloudOf (torusAndKnot ()));
    std::size_t calls = 0;
    run.object.setProgressCallback ([&] (float) { return calls++ < stop; });
    expectFailure (run, Status::CANCELLED);
    EXPECT_EQ (calls, stop + 1) << "called again after cancelling";
    run.object.setProgressCallback ({});
    EXPECT_FALSE (run ());

    calls = 0;
    run.object.setProgressCallback ([&] (float) -> bool {
      if (calls++ == stop)
        throw std::runtime_error ("from the callback");
      return true;
    });
    EXPECT_NO_THROW (EXPECT_TRUE (run ()));
    EXPECT_NE (run.object.getStatus (), Status::OK);
  }
}

/** A status is that of the computation that ended last. */
template <typename Run>
void
checkStatusDuringRun ()
{
  Run run;
  run.object.setInputCloud (cloudOf (torusAndKnot ()));
  EXPECT_FALSE (run ());
  ASSERT_EQ (run.object.getStatus (), Status::OK);
  run.object.setProgressCallback ([&run] (float) {
    EXPECT_EQ (run.object.getStatus (), Status::NOT_COMPUTED);
    EXPECT_TRUE (run.object.getStages ().empty ());
    return true;
  });
  EXPECT_FALSE (run ());
  EXPECT_EQ (run.object.getStatus (), Status::OK);
}

/** 40 x 30 points of a sheet, a row after the other, seen from a place of its own. */
inline Cloud::Ptr
organizedCloud ()
{
  constexpr int WIDTH = 40;
  constexpr int HEIGHT = 30;
  std::vector<Eigen::Vector3f> points;
  for (int y = 0; y < HEIGHT; ++y)
    for (int x = 0; x < WIDTH; ++x)
      points.emplace_back (static_cast<float> (x), static_cast<float> (y),
                           0.05f * static_cast<float> (x * x % 7 + y));
  const Cloud::Ptr cloud = cloudOf (points);
  cloud->width = WIDTH;
  cloud->height = HEIGHT;
  cloud->header.frame_id = "camera";
  cloud->header.stamp = 1234567;
  cloud->header.seq = 5;
  cloud->sensor_origin_ = Eigen::Vector4f (1.0f, 2.0f, 3.0f, 0.0f);
  cloud->sensor_orientation_ = Eigen::Quaternionf (0.5f, 0.5f, 0.5f, 0.5f);
  return cloud;
}

/** The cloud of a mesh is that of the input, in its layout. */
template <typename Run>
void
checkLayoutOfMesh ()
{
  Run run;
  const Cloud::Ptr cloud = organizedCloud ();
  (*cloud)[7].x = NOT_A_NUMBER;
  cloud->is_dense = false;
  run.object.setInputCloud (cloud);
  run ();
  ASSERT_EQ (run.object.getStatus (), Status::OK);
  EXPECT_EQ (run.mesh.cloud.width, cloud->width);
  EXPECT_EQ (run.mesh.cloud.height, cloud->height);
  EXPECT_FALSE (run.mesh.cloud.is_dense);
  EXPECT_EQ (run.mesh.cloud.header.frame_id, "camera");
  EXPECT_EQ (run.mesh.cloud.header.stamp, 1234567U);
  EXPECT_EQ (run.mesh.header.frame_id, "camera");
}

/** What PCL prints to standard error while a body runs. */
template <typename Body>
std::string
printedBy (const Body& body)
{
  testing::internal::CaptureStderr ();
  body ();
  return testing::internal::GetCapturedStderr ();
}

/** A search that no class needs is named once. */
template <typename Run>
void
checkNeedlessSearch ()
{
  Run run;
  run.object.setInputCloud (cloudOf (torusAndKnot ()));
  EXPECT_EQ (printedBy ([&] { run (); }), "");
  run.object.setSearchMethod (std::make_shared<pcl::search::KdTree<pcl::PointXYZ>> ());
  EXPECT_NE (printedBy ([&] { run (); }).find ("setSearchMethod"), std::string::npos);
  EXPECT_EQ (run.object.getStatus (), Status::OK);
  EXPECT_EQ (printedBy ([&] { run (); }), "");
}

/** No crash, and an output that is empty exactly when the status is not OK. */
template <typename Run>
void
checkDegenerateClouds (Run& run)
{
  for (const Named& named : degenerateClouds ()) {
    SCOPED_TRACE (named.name);
    run.object.setInputCloud (cloudOf (named.points));
    for (const int k : {0, 1, 24}) {
      run.object.setThinningNeighbors (k);
      const bool empty = run ();
      EXPECT_EQ (empty, run.object.getStatus () != Status::OK)
        << pcl::manifold::toString (run.object.getStatus ());
      EXPECT_NE (run.object.getStatus (), Status::INTERNAL_ERROR);
    }
  }
}

} // namespace class_contract
