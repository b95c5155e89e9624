#include "peak_memory.h"

#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace benchmark {
namespace {

/** \brief An entry of Linux' status of this process, in bytes; 0 if there is none. */
std::size_t
statusEntry (const std::string& name)
{
  std::ifstream status ("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == name + ":") {
      std::size_t kilobytes = 0;
      status >> kilobytes;
      return kilobytes * 1024;
    }
  return 0;
}

} // namespace

std::size_t
resetPeakMemory ()
{
#ifdef __GLIBC__
  malloc_trim (0);
#endif
  std::ofstream references ("/proc/self/clear_refs");
  references << "5" << std::flush; // proc(5): resets the peak of the resident set
  return references ? statusEntry ("VmRSS") : 0;
}

std::size_t
peakMemory ()
{
  return statusEntry ("VmHWM");
}

} // namespace benchmark
