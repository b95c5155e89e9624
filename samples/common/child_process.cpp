#include "child_process.h"

#include <cerrno>
#include <csignal>
#include <initializer_list>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace pcl::manifold::apps {

bool
waitFor (pid_t process, std::chrono::milliseconds patience, int& status)
{
  const auto deadline = std::chrono::steady_clock::now () + patience;
  for (;;) {
    const pid_t ended = waitpid (process, &status, WNOHANG);
    if (ended == process || (ended < 0 && errno != EINTR))
      return true;
    if (std::chrono::steady_clock::now () > deadline)
      return false;
    std::this_thread::sleep_for (std::chrono::milliseconds (5));
  }
}

void
becomeQuietChild (pid_t parent)
{
#ifdef __linux__
  prctl (PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (getppid () != parent)
    _exit (1); // the parent ended in the meantime
  setpgid (0, 0);
  const rlimit no_core_file = {0, 0};
  setrlimit (RLIMIT_CORE, &no_core_file);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE})
    std::signal (signal, SIG_DFL);
  const int nowhere = open ("/dev/null", O_RDWR);
  if (nowhere >= 0)
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      dup2 (nowhere, descriptor);
}

} // namespace pcl::manifold::apps
