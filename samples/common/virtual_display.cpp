#include "virtual_display.h"

#include "child_process.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace pcl::manifold::apps {
namespace {

using namespace std::chrono_literals;

/** \brief The path of the program; empty if it is not installed. */
std::string
findServer ()
{
  const char* const path = std::getenv ("PATH"); // NOLINT(concurrency-mt-unsafe): nothing sets it
  const std::string folders = std::string (path == nullptr ? "" : path);
  for (std::size_t begin = 0; begin < folders.size ();) {
    const std::size_t end = std::min (folders.find (':', begin), folders.size ());
    std::string file = folders.substr (begin, end - begin) + "/Xvfb";
    if (access (file.c_str (), X_OK) == 0)
      return file;
    begin = end + 1;
  }
  return {};
}

/** \brief Reads a line with a number from a pipe, as the server writes its display when it is ready. */
std::string
readNumber (int descriptor, std::chrono::milliseconds patience)
{
  const auto deadline = std::chrono::steady_clock::now () + patience;
  std::string text;
  while (text.empty () || text.back () != '\n') {
    const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds> (deadline - std::chrono::steady_clock::now ());
    pollfd ready = {descriptor, POLLIN, 0};
    const int answer = left.count () > 0 ? poll (&ready, 1, static_cast<int> (left.count ())) : 0;
    if (answer < 0 && errno == EINTR)
      continue;
    char character = 0;
    if (answer <= 0 || read (descriptor, &character, 1) != 1)
      return {};
    text += character;
  }
  text.pop_back ();
  return text;
}

} // namespace

VirtualDisplay::VirtualDisplay ()
{
  const std::string server = findServer ();
  if (server.empty ())
    throw std::runtime_error ("Xvfb is not installed");
  int ends[2] = {-1, -1};
  if (pipe2 (ends, O_CLOEXEC) != 0)
    throw std::system_error (errno, std::generic_category (), "Xvfb cannot be started");
  // Everything that allocates is done before the fork: other threads may hold locks then.
  const std::string descriptor = std::to_string (ends[1]);
  const char* const arguments[] = {
    server.c_str (), "-displayfd", descriptor.c_str (), "-screen", "0", "1600x900x24",
    "-nolisten",     "tcp",        "-noreset",          nullptr};
  const pid_t parent = getpid ();
  process_ = fork ();
  if (process_ == 0) {
    becomeQuietChild (parent);
    fcntl (ends[1], F_SETFD, 0);
    execv (server.c_str (), const_cast<char* const*> (arguments));
    _exit (127);
  }
  close (ends[1]);
  const std::string number = process_ > 0 ? readNumber (ends[0], 20s) : std::string ();
  close (ends[0]);
  if (number.empty ()) {
    stop ();
    throw std::runtime_error ("Xvfb does not start");
  }
  name_ = ":" + number;
}

VirtualDisplay::~VirtualDisplay ()
{
  stop ();
}

void
VirtualDisplay::stop ()
{
  if (process_ <= 0)
    return;
  int status = 0;
  kill (process_, SIGTERM);
  if (!waitFor (process_, 3s, status)) {
    kill (process_, SIGKILL);
    waitFor (process_, 3s, status);
  }
  process_ = -1;
}

} // namespace pcl::manifold::apps
