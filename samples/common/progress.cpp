#include "progress.h"

#include "interrupt.h"

#include <algorithm>
#include <cstdio>

#include <unistd.h>

namespace pcl::manifold::apps {

Progress::Progress (const std::string& title, bool quiet)
  : title_ (title), quiet_ (quiet), terminal_ (isatty (STDERR_FILENO) == 1)
{}

Progress::~Progress ()
{
  if (!quiet_ && terminal_ && shown_ >= 0 && shown_ < 100)
    std::fputc ('\n', stderr);
}

bool
Progress::update (float fraction)
{
  if (!quiet_ && fraction >= 0) {
    const int percent = static_cast<int> (100 * std::min (fraction, 1.0f));
    const int step = terminal_ ? 1 : 10;
    if (shown_ < 0 || percent / step > shown_ / step)
      draw (percent - percent % step);
  }
  return !interrupted ();
}

void
Progress::draw (int percent)
{
  shown_ = percent;
  if (!terminal_) {
    std::fprintf (stderr, "%s: %d %%\n", title_.c_str (), percent);
    return;
  }
  constexpr int width = 40;
  const int filled = width * percent / 100;
  const std::string bar = std::string (filled, '=') + std::string (width - filled, ' ');
  std::fprintf (stderr, "\r%s [%s] %3d %%%s", title_.c_str (), bar.c_str (), percent,
                percent == 100 ? "\n" : "");
  std::fflush (stderr);
}

} // namespace pcl::manifold::apps
