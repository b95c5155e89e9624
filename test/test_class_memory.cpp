// Where memory runs out, at any allocation, in any thread: a status, an empty output, and an object that can
// be used again.
#include "test_class_memory.h"
#include "test_class_clouds.h"

#include <gtest/gtest.h>
#include <pcl/console/print.h>
#include <pcl/manifold/cocone_shape.h>
#include <pcl/manifold/dimension_detection.h>
#include <pcl/manifold/fixed_point_reconstruction.h>
#include <pcl/manifold/graph_reconstruction.h>

#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <memory>

namespace {

using namespace class_clouds;
using pcl::manifold::Status;

std::vector<pcl::Indices>
indicesOf (const pcl::PolygonMesh& mesh)
{
  std::vector<pcl::Indices> polygons;
  for (const pcl::Vertices& polygon : mesh.polygons)
    polygons.push_back (polygon.vertices);
  return polygons;
}

struct Detection
{
  pcl::DimensionDetection<pcl::PointXYZ> object;
  pcl::PointCloud<pcl::Label> labels;

  void compute () { object.compute (labels); }

  bool givesNothing () const { return labels.empty () && object.getSampleDimensions () == nullptr; }

  std::vector<std::uint32_t> result () const
  {
    std::vector<std::uint32_t> values;
    for (const pcl::Label& label : labels)
      values.push_back (label.label);
    return values;
  }
};

template <typename Class>
struct Meshing
{
  Class object;
  pcl::PolygonMesh mesh;

  void compute () { object.reconstruct (mesh); }

  bool givesNothing () const { return mesh.polygons.empty () && mesh.cloud.data.empty (); }

  std::vector<pcl::Indices> result () const { return indicesOf (mesh); }
};

using Shape = Meshing<pcl::CoconeShape<pcl::PointXYZ>>;
using FixedPoint = Meshing<pcl::FixedPointReconstruction<pcl::PointXYZ>>;

struct Graph : Meshing<pcl::GraphReconstruction<pcl::PointXYZ>>
{
  Graph () { object.setHops (3); }

  bool givesNothing () const { return Meshing::givesNothing () && object.getLandmarks ().empty (); }
};

/** From a mesh, which is converted, too. */
struct FixedPointOfMesh : FixedPoint
{
  FixedPointOfMesh ()
  {
    FixedPoint start;
    start.object.setInputCloud (cloudOf (torusAndKnot (2)));
    start.compute ();
    object.setInitialMesh (std::make_shared<pcl::PolygonMesh> (start.mesh));
  }
};

template <typename Run>
class OutOfMemory : public testing::Test
{
protected:
  // A message for each failure would hide the one that counts.
  OutOfMemory () { pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS); }
};

using Runs = testing::Types<Detection, Shape, FixedPoint, FixedPointOfMesh, Graph>;
TYPED_TEST_SUITE (OutOfMemory, Runs);

/** Of so many allocations those that are made to fail: all of the first and the last, and a share of the
 * rest. */
std::vector<long>
chosen (long allocations)
{
  constexpr long ENDS = 100;
  constexpr long BETWEEN = 200;
  std::vector<long> numbers;
  const long step = std::max (1L, (allocations - 2 * ENDS) / BETWEEN);
  for (long i = 0; i < allocations; i += i < ENDS || i >= allocations - ENDS ? 1 : step)
    numbers.push_back (i);
  return numbers;
}

TYPED_TEST (OutOfMemory, AtAnyAllocationLeavesNothing)
{
  if (!failing_malloc::AVAILABLE)
    GTEST_SKIP () << "malloc is not the test's own";
  TypeParam run;
  run.object.setInputCloud (cloudOf (torusAndKnot ()));
  run.object.setNumberOfThreads (2);
  run.compute ();
  ASSERT_EQ (run.object.getStatus (), Status::OK);
  const auto expected = run.result ();
  ASSERT_FALSE (expected.empty ());
  for (const bool once : {true, false}) {
    TypeParam first; // its cloud has no indices yet
    first.object.setInputCloud (run.object.getInputCloud ());
    first.object.setNumberOfThreads (2);
    const long allocations = failing_malloc::countDuring ([&] { first.compute (); });
    long failures = 0;
    for (const long number : chosen (allocations)) {
      TypeParam again;
      again.object.setInputCloud (run.object.getInputCloud ());
      again.object.setNumberOfThreads (2);
      const bool failed = failing_malloc::failDuring (number, once, [&] { again.compute (); });
      const Status status = again.object.getStatus ();
      failures += status == Status::OUT_OF_MEMORY ? 1 : 0;
      // The standard library does without some of its buffers.
      if (status == Status::OK)
        ASSERT_EQ (again.result (), expected) << number;
      else {
        ASSERT_TRUE (failed) << number;
        ASSERT_EQ (status, Status::OUT_OF_MEMORY) << pcl::manifold::toString (status) << " " << number;
        ASSERT_TRUE (again.givesNothing ()) << number;
      }
      if (number % 16 == 0) {
        again.compute ();
        ASSERT_EQ (again.object.getStatus (), Status::OK);
        ASSERT_EQ (again.result (), expected) << number;
      }
    }
    EXPECT_GT (failures, 100);
  }
}

/** The pages that the process has mapped, in bytes. */
rlim_t
addressSpace ()
{
  std::size_t pages = 0;
  std::ifstream ("/proc/self/statm") >> pages;
  return static_cast<rlim_t> (pages) * static_cast<rlim_t> (sysconf (_SC_PAGESIZE));
}

enum Outcome
{
  DONE,
  FAILED,
  WRONG
};

/** Runs with so many bytes more than there are now, and then without a limit. */
template <typename Run>
Outcome
runWithin (rlim_t bytes)
{
  Run run;
  run.object.setInputCloud (cloudOf (floats (generate::blueNoise (generate::torus (), 0.02, 1))));
  run.object.setNumberOfThreads (1);
  rlimit limit{};
  getrlimit (RLIMIT_AS, &limit);
  const rlim_t before = limit.rlim_cur;
  limit.rlim_cur = addressSpace () + bytes;
  setrlimit (RLIMIT_AS, &limit);
  run.compute ();
  limit.rlim_cur = before;
  setrlimit (RLIMIT_AS, &limit);
  const Status status = run.object.getStatus ();
  if (status != Status::OK && (status != Status::OUT_OF_MEMORY || !run.givesNothing ()))
    return WRONG;
  run.compute ();
  if (run.object.getStatus () != Status::OK || run.result ().empty ())
    return WRONG;
  return status == Status::OK ? DONE : FAILED;
}

TYPED_TEST (OutOfMemory, UnderALimitLeavesNothing)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP () << "sanitizers map far more than a limit would leave";
#endif
  int outcomes[] = {0, 0, 0};
  for (int megabytes = 0; megabytes <= 1024; megabytes = std::max (1, megabytes * 2)) {
    // No thread is left out of the child: nothing has computed in this process before.
    const pid_t child = fork ();
    ASSERT_GE (child, 0);
    if (child == 0)
      _exit (runWithin<TypeParam> (static_cast<rlim_t> (megabytes) << 20));
    int status = 0;
    ASSERT_EQ (waitpid (child, &status, 0), child);
    ASSERT_TRUE (WIFEXITED (status)) << "signal " << WTERMSIG (status) << " with " << megabytes << " MiB";
    ASSERT_LT (WEXITSTATUS (status), WRONG) << megabytes << " MiB";
    ++outcomes[WEXITSTATUS (status)];
  }
  EXPECT_GT (outcomes[FAILED], 1);
  EXPECT_GT (outcomes[DONE], 0);
}

} // namespace
