// Under a limit of the address space, in a process of its own: a status, an empty output, and an object that
// can be used again without the limit.
#include "test_class_memory_runs.h"

#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>

namespace {

using namespace class_memory;

TYPED_TEST_SUITE (OutOfMemory, Runs);

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
runWithin (rlim_t bytes, const Cloud::Ptr& cloud)
{
  Run run;
  run.object.setInputCloud (cloud);
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
  const Cloud::Ptr cloud = cloudOf (floats (generate::blueNoise (generate::torus (), 0.04, 1)));
  std::array<int, WRONG> outcomes{};
  for (int megabytes = 0; megabytes <= 256; megabytes = std::max (1, megabytes * 2)) {
    // No thread is left out of the child: nothing has computed in this process before.
    const pid_t child = fork ();
    ASSERT_GE (child, 0);
    if (child == 0)
      _exit (runWithin<TypeParam> (static_cast<rlim_t> (megabytes) << 20, cloud));
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
