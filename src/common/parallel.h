#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

namespace pcl {
namespace manifold {

/** Calls body (i) for every i in [0, n), in parallel in the current arena. Bodies must not depend on each
 * other: results are then the same for any number of threads. */
template <typename Body>
void
parallelFor (std::size_t n, const Body& body, std::size_t grain = 1024)
{
  tbb::parallel_for (tbb::blocked_range<std::size_t> (0, n, grain),
                     [&body] (const tbb::blocked_range<std::size_t>& range) {
                       for (std::size_t i = range.begin (); i != range.end (); ++i)
                         body (i);
                     });
}

/** Calls body (begin, end) for pieces of [0, n): for bodies with scratch memory of their own. */
template <typename Body>
void
parallelRanges (std::size_t n, const Body& body, std::size_t grain = 1024)
{
  tbb::parallel_for (
    tbb::blocked_range<std::size_t> (0, n, grain),
    [&body] (const tbb::blocked_range<std::size_t>& range) { body (range.begin (), range.end ()); });
}

/** Runs body with at most `threads` threads; 0 stands for all cores, and so does a larger number than there
 * are: of more TBB would warn. */
template <typename Body>
void
withThreads (unsigned int threads, const Body& body)
{
  const auto cores = static_cast<unsigned int> (tbb::this_task_arena::max_concurrency ());
  tbb::task_arena arena (threads == 0 ? tbb::task_arena::automatic
                                      : static_cast<int> (std::min (threads, std::max (cores, 1U))));
  arena.execute (body);
}

} // namespace manifold
} // namespace pcl
