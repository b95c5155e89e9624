#include <pcl/manifold/status.h>

const char*
pcl::manifold::toString (Status status)
{
  switch (status) {
    case Status::OK:
      return "OK";
    case Status::NOT_COMPUTED:
      return "NOT_COMPUTED";
    case Status::NO_INPUT:
      return "NO_INPUT";
    case Status::TOO_FEW_POINTS:
      return "TOO_FEW_POINTS";
    case Status::DIMENSION_TOO_LOW:
      return "DIMENSION_TOO_LOW";
    case Status::PARAMETER_OUT_OF_RANGE:
      return "PARAMETER_OUT_OF_RANGE";
    case Status::INPUT_TOO_COARSE:
      return "INPUT_TOO_COARSE";
    case Status::INPUT_OUT_OF_RANGE:
      return "INPUT_OUT_OF_RANGE";
    case Status::TOO_MANY_POINTS:
      return "TOO_MANY_POINTS";
    case Status::CANCELLED:
      return "CANCELLED";
    case Status::OUT_OF_MEMORY:
      return "OUT_OF_MEMORY";
    case Status::INTERNAL_ERROR:
      return "INTERNAL_ERROR";
  }
  return "UNKNOWN";
}
