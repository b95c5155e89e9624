#include "interrupt.h"

#include "app_error.h"

#include <csignal>

namespace pcl::manifold::apps {
namespace {

volatile std::sig_atomic_t noted = 0;

void
note (int)
{
  noted = 1;
}

} // namespace

void
noteInterrupts ()
{
  struct sigaction action = {};
  action.sa_handler = note;
  // The handler is gone after the first signal, and system calls under way go on.
  action.sa_flags = static_cast<int> (SA_RESETHAND | SA_RESTART);
  sigaction (SIGINT, &action, nullptr);
  sigaction (SIGTERM, &action, nullptr);
}

bool
interrupted ()
{
  return noted != 0;
}

void
throwIfInterrupted (const std::string& file)
{
  if (interrupted ())
    throw AppError (file, "cancelled");
}

} // namespace pcl::manifold::apps
