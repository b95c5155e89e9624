#pragma once

#include <pcl/manifold/status.h>

#include <string>

namespace pcl::manifold::apps {

/** \brief Shows on standard error how far a computation is: a bar on a terminal, a line per ten percent
 * elsewhere, nothing if quiet. */
class Progress
{
public:
  /** \param[in] title what is computed, one or two words
   * \param[in] quiet show nothing */
  Progress (const std::string& title, bool quiet);

  Progress (const Progress&) = delete;
  Progress& operator= (const Progress&) = delete;

  /** \brief Ends the line of an unfinished bar. */
  ~Progress ();

  /** \brief Shows a fraction in [0, 1].
   * \return false once the user pressed Ctrl-C */
  bool update (float fraction);

  /** \brief update () as the library calls it; not to be called once this object is gone. */
  pcl::manifold::ProgressCallback callback ()
  {
    return [this] (float fraction) { return update (fraction); };
  }

private:
  void draw (int percent);

  std::string title_;
  bool quiet_;
  bool terminal_;
  int shown_ = -1;
};

} // namespace pcl::manifold::apps
