#include <pcl/manifold/stage_log.h>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

namespace pcl {
namespace manifold {

namespace {

std::size_t
peakBytes ()
{
#if defined(__APPLE__)
  constexpr std::size_t UNIT = 1;
#elif defined(__unix__)
  constexpr std::size_t UNIT = 1024;
#endif
#if defined(__unix__) || defined(__APPLE__)
  rusage usage{};
  return getrusage (RUSAGE_SELF, &usage) == 0 ? static_cast<std::size_t> (usage.ru_maxrss) * UNIT : 0;
#else
  return 0;
#endif
}

} // namespace

bool
StageLog::begin (const std::string& name, float fraction)
{
  const auto now = std::chrono::steady_clock::now ();
  if (!current_.empty ())
    stages_.push_back ({current_, std::chrono::duration<double> (now - start_).count (), peakBytes ()});
  current_ = name;
  start_ = now;
  return proceed (fraction);
}

bool
StageLog::proceed (float fraction)
{
  if (callback_ && !cancelled_)
    cancelled_ = !callback_ (fraction);
  return !cancelled_;
}

} // namespace manifold
} // namespace pcl
