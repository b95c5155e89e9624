#pragma once

#include "cloud_reader.h"
#include "command_line.h"
#include "report.h"
#include "table.h"

#include <pcl/manifold/sample_set.h>
#include <pcl/manifold/stage_log.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

namespace pcl::manifold::apps {

/** \brief The options that all apps of the Delaunay family hand on to their class. */
struct ThinningOptions
{
  int k = 0;
  double spacing = 0.0;
  CommonOptions common;

  /** \brief Declares `-k`, `-spacing` and the common options. */
  void declare (CommandLine& command_line);

  /** \brief Checks early that what the common options ask for can be written. */
  void checkReport () const;

  void describe (Report& report) const;

  /** \brief Sets them on a class. */
  template <typename Class>
  void apply (Class& object) const
  {
    object.setThinningNeighbors (k);
    object.setThinningDistance (spacing);
    object.setNumberOfThreads (static_cast<unsigned int> (common.threads));
  }
};

/** \brief Those of the apps that detect dimensions. */
struct SampleOptions : ThinningOptions
{
  double rho = 0.3;

  /** \brief Declares `-rho`, too. */
  void declare (CommandLine& command_line);

  void describe (Report& report) const;

  /** \brief Sets them on a DimensionDetection or CoconeShape. */
  template <typename Class>
  void apply (Class& object) const
  {
    object.setRho (rho);
    ThinningOptions::apply (object);
  }
};

/** \brief The coordinates of a cloud that was read, for the classes of the library. */
pcl::PointCloud<pcl::PointXYZ>::Ptr pointsOf (const InputCloud& input);

/** \brief Tells the user what was noticed while the cloud was read, on standard error. */
void printNotes (const InputCloud& input, bool quiet);

/** \brief What became of the points of a cloud. */
struct PointCounts
{
  std::size_t dropped = 0;        ///< not finite
  std::size_t no_measurement = 0; ///< stored at one place, most often (0, 0, 0), by the sensor's driver
  std::size_t duplicates = 0;     ///< of other points
  std::size_t thinned = 0;        ///< left out by thinning
  std::size_t samples = 0;        ///< all others
};

/** \brief The counts of a cloud from those of its sample set. */
PointCounts countsOf (const InputCloud& input, const SampleSet& samples);

/** \brief Says on standard error what was left out that a user would not expect to be. */
void noteLeftOut (const InputCloud& input, const PointCounts& counts, bool quiet);

/** \brief Reports how many samples of curves lie beside others, and says on standard error what helps where
 * that is most of all. */
void describeContradiction (const InputCloud& input, std::size_t contradicted, const PointCounts& counts,
                            const SampleOptions& options, Report& report);

/** \brief Reports and tabulates what became of the points of a cloud, and the stages of a computation. */
void describeInput (const InputCloud& input, const PointCounts& counts, Report& report, Table& table);
void describeStages (const std::vector<Stage>& stages, Report& report, Table& table);

} // namespace pcl::manifold::apps
