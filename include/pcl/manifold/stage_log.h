#pragma once

#include <pcl/manifold/export.h>
#include <pcl/manifold/status.h>

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief What one stage of a computation took.
 * \ingroup manifold */
struct Stage
{
  std::string name;     ///< in lower-case words
  double seconds = 0.0; ///< of wall clock
  std::size_t peak_bytes =
    0; ///< largest resident memory of the process by the end of the stage; 0 if unknown
};

/** \brief Times the stages of a computation and passes its progress on.
 * \ingroup manifold */
class StageLog
{
public:
  /** \brief A log without stages.
   * \param[in] callback told of the progress, if there is one */
  explicit StageLog (ProgressCallback callback = {}) : callback_ (std::move (callback)) {}

  /** \brief Ends the stage that is under way, and begins another one.
   * \param[in] name of the new stage, or empty at the end of all of them
   * \param[in] fraction of the whole computation that is done
   * \return false if the user cancelled */
  PCL_MANIFOLD_CORE_EXPORTS bool begin (const std::string& name, float fraction);

  /** \brief Tells how far the stage that is under way is.
   * \param[in] fraction of the whole computation that is done
   * \return false if the user cancelled */
  PCL_MANIFOLD_CORE_EXPORTS bool proceed (float fraction);

  /** \brief Whether the callback has ended the computation.
   * \return true if so */
  bool cancelled () const { return cancelled_; }

  /** \brief The stages that have ended.
   * \return in their order */
  const std::vector<Stage>& stages () const { return stages_; }

private:
  ProgressCallback callback_;
  std::vector<Stage> stages_;
  std::string current_;
  std::chrono::steady_clock::time_point start_;
  bool cancelled_ = false;
};

} // namespace manifold
} // namespace pcl
