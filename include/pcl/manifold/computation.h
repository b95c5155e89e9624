#pragma once

#include <pcl/console/print.h>
#include <pcl/manifold/detail/guarded.h>
#include <pcl/manifold/impl/cloud_points.hpp>
#include <pcl/manifold/stage_log.h>
#include <pcl/manifold/status.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief What all classes of the module that compute have in common: a number of threads, a progress callback,
 * a status, and what the stages took.
 *
 * No exception leaves compute () or reconstruct (): where memory runs out, while the cloud is copied or the
 * result converted as well, the output is empty and the status OUT_OF_MEMORY; any other exception, one of the
 * progress callback among them, ends in INTERNAL_ERROR. The object can be used again.
 *
 * \tparam Base pcl::PCLBase<PointT> or a class that derives from it
 * \ingroup manifold */
template <typename Base>
class Computation : public Base
{
public:
  /** \brief How many threads may compute; the result is the same, bit for bit, for any number.
   * \param[in] threads 0 = all cores (the default); of more than there are, all */
  void setNumberOfThreads (unsigned int threads = 0) { threads_ = threads; }

  /** \brief The number of threads.
   * \return 0 = all cores */
  unsigned int getNumberOfThreads () const { return threads_; }

  /** \brief A function that is told how far the computation is, and can end it.
   * \param[in] callback see ProgressCallback; none (the default) where it is empty */
  void setProgressCallback (ProgressCallback callback) { progress_ = std::move (callback); }

  /** \brief How the last computation ended.
   * \return NOT_COMPUTED before the first one, and while one runs */
  Status getStatus () const { return status_; }

  /** \brief What each stage of the last computation took.
   * \return seconds and peak memory, in the order of the stages; those that were completed if it was cancelled
   */
  const std::vector<Stage>& getStages () const { return stages_; }

protected:
  /** \brief Runs a computation, sets the status and the stages, and says what is wrong through PCL_ERROR.
   * \param[in] where the function that was called, for the message
   * \param[in] body answers with a Status; gets a StageLog&
   * \return whether the status is OK */
  template <typename Body>
  bool run (const char* where, const Body& body)
  {
    status_ = Status::NOT_COMPUTED;
    stages_.clear ();
    status_ = guarded ([&] {
      StageLog log (progress_);
      const Status status = body (log);
      stages_ = log.stages ();
      return status;
    });
    if (status_ != Status::OK)
      PCL_ERROR ("[pcl::%s] %s\n", where, toString (status_));
    return status_ == Status::OK;
  }

  /** \brief Runs a part of a computation on the input cloud and its indices, unless there is none or an index
   * names no point.
   * \param[in] body answers with a Status
   * \return NO_INPUT, TOO_MANY_POINTS, PARAMETER_OUT_OF_RANGE, OUT_OF_MEMORY, or what \a body answers */
  template <typename Body>
  Status withInput (const Body& body)
  {
    // The base class would number the points with indices that overflow.
    if (this->input_ &&
        this->input_->size () > static_cast<std::size_t> (std::numeric_limits<std::int32_t>::max ()))
      return Status::TOO_MANY_POINTS;
    // initCompute () takes an empty cloud, and refuses nothing but a missing one.
    if (!this->input_ || !this->initCompute ())
      return Status::NO_INPUT;
    // It catches std::bad_alloc, and goes on with fewer indices than points.
    if (this->fake_indices_ && this->indices_->size () != this->input_->size ())
      return Status::OUT_OF_MEMORY;
    const Status status =
      areValid (*this->input_, *this->indices_) ? guarded (body) : Status::PARAMETER_OUT_OF_RANGE;
    this->deinitCompute ();
    return status;
  }

private:
  unsigned int threads_ = 0;
  ProgressCallback progress_;
  std::vector<Stage> stages_;
  Status status_ = Status::NOT_COMPUTED;
};

} // namespace manifold
} // namespace pcl
