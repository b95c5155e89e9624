#pragma once

#include <pcl/manifold/export.h>

#include <functional>
#include <string>

namespace pcl {
namespace manifold {

/** \brief Why a computation ended as it did. Every class of the module answers with one of these from
 * getStatus ().
 * \ingroup manifold */
enum class Status
{
  OK,                     ///< done, the output is complete
  NOT_COMPUTED,           ///< compute () or reconstruct () was not called yet
  NO_INPUT,               ///< no input cloud was set, or it holds no finite point
  TOO_FEW_POINTS,         ///< fewer distinct points than the method needs
  DIMENSION_TOO_LOW,      ///< the points span no simplex that the method could output
  PARAMETER_OUT_OF_RANGE, ///< a setter was given a value outside of its documented range
  INPUT_TOO_COARSE,       ///< the coordinates are so large that their type cannot resolve the spacing
  INPUT_OUT_OF_RANGE,     ///< the extent of the points overflows or underflows double arithmetic
  TOO_MANY_POINTS,        ///< more points or Delaunay cells than indices of 32 bits can tell apart
  CANCELLED,              ///< the progress callback returned false
  OUT_OF_MEMORY,          ///< an allocation failed
  INTERNAL_ERROR          ///< an invariant of the library did not hold; please report it
};

/** \brief The name of a status, as in the enum.
 * \param[in] status any
 * \return a literal, "OK" for instance
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS const char* toString (Status status);

/** \brief Told how far a computation is, a fraction in [0, 1] that never decreases. Returning false cancels
 * the computation: the output is left empty and the status is CANCELLED. Called from the thread that called
 * compute () or reconstruct ().
 * \ingroup manifold */
using ProgressCallback = std::function<bool (float)>;

} // namespace manifold
} // namespace pcl
