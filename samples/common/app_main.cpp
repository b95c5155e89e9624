#include "app_main.h"

#include "app_error.h"
#include "interrupt.h"

#include <pcl/console/print.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>

namespace pcl::manifold::apps {
namespace {

int
fail (int status, std::string line)
{
  std::replace_if (
    line.begin (), line.end (), [] (char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  std::cout.flush ();
  std::cerr << "error: " << line << std::endl;
  return status;
}

const char*
explain (Status status)
{
  switch (status) {
    case Status::OK:
      return "done";
    case Status::NOT_COMPUTED:
      return "nothing was computed";
    case Status::NO_INPUT:
      return "holds no point whose coordinates are all finite";
    case Status::TOO_FEW_POINTS:
      return "holds too few distinct points";
    case Status::DIMENSION_TOO_LOW:
      return "its points span too few dimensions";
    case Status::PARAMETER_OUT_OF_RANGE:
      return "an option is out of range, see -h";
    case Status::INPUT_TOO_COARSE:
      return "its coordinates are so large that their type does not resolve the points: subtract an origin, "
             "or store them as doubles";
    case Status::INPUT_OUT_OF_RANGE:
      return "its coordinates are too large or too small to compute with";
    case Status::TOO_MANY_POINTS:
      return "too many points for 32-bit indices (2 147 483 647 points, or Delaunay cells, 6 to 15 a point): "
             "take a part, or thin it with -thin-distance";
    case Status::CANCELLED:
      return "cancelled";
    case Status::OUT_OF_MEMORY:
      return "out of memory";
    case Status::INTERNAL_ERROR:
      break;
  }
  return "internal error, please report it";
}

} // namespace

int
runApp (int argc, const char* const* argv, CommandLine& command_line, const std::function<void ()>& body)
{
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  noteInterrupts ();
  try {
    if (!command_line.parse (argc, argv)) {
      command_line.printHelp (std::cout);
      return 0;
    }
    body ();
    std::cout.flush ();
    if (!std::cout)
      throw AppError ("standard output", "cannot be written to");
    return 0;
  } catch (const UsageError& error) {
    return fail (2, error.what ());
  } catch (const AppError& error) {
    return fail (1, error.what ());
  } catch (const std::bad_alloc&) {
    return fail (1, command_line.subject () + ": out of memory");
  } catch (const std::exception& error) {
    return fail (1, command_line.subject () + ": " + error.what ());
  } catch (...) {
    return fail (1, command_line.subject () + ": unknown failure");
  }
}

void
requireOk (const std::string& file, Status status)
{
  if (status != Status::OK)
    throw AppError (file, explain (status));
}

} // namespace pcl::manifold::apps
