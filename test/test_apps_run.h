#pragma once

#include "test_apps_folder.h"

#include <sys/wait.h>

#include <cstdlib>
#include <string>

/** Apps as a user runs them. */
namespace apps_run {

struct Outcome
{
  int exit_status; ///< -1 if a signal ended it
  std::string out, error;
};

/** Runs an app in a shell.
 * \param[in] before commands ahead of it
 * \param[in] out where its output goes */
inline Outcome
run (const TestFolder& logs, const std::string& app, const std::string& arguments,
     const std::string& before = {}, const std::string& out = {})
{
  const std::string to = out.empty () ? logs / "out" : out;
  const std::string command =
    before + "'" + app + "' " + arguments + " > '" + to + "' 2> '" + logs / "error" + "' < /dev/null";
  const int status = std::system (command.c_str ());
  return {WIFEXITED (status) ? WEXITSTATUS (status) : -1, out.empty () ? logs.read ("out") : std::string (),
          logs.read ("error")};
}

/** A PCD file in text, with this header for its points. */
inline std::string
pcd (std::size_t points, const std::string& data)
{
  const std::string n = std::to_string (points);
  return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + n +
         "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + n + "\nDATA ascii\n" + data;
}

} // namespace apps_run
