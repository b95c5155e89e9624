// Where memory runs out, at any allocation, in any thread: a status, an empty output, and an object that can
// be used again.
#include "test_class_memory.h"
#include "test_class_memory_runs.h"

namespace {

using namespace class_memory;

TYPED_TEST_SUITE (OutOfMemory, Runs);

/** Of so many allocations those that are made to fail: all of the first and the last, and a share of the
 * rest. */
std::vector<long>
chosen (long allocations)
{
  constexpr long ENDS = 60;
  constexpr long BETWEEN = 60;
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
      if (status == Status::OUT_OF_MEMORY && failures % 16 == 0) {
        again.compute ();
        ASSERT_EQ (again.object.getStatus (), Status::OK);
        ASSERT_EQ (again.result (), expected) << number;
      }
    }
    EXPECT_GT (failures, 60);
  }
}

} // namespace
