#pragma once

#include "cloud_reader.h"
#include "command_line.h"
#include "report.h"
#include "summary.h"
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
  int neighbors = 0;
  double distance = 0.0;
  CommonOptions common;

  /** \brief Declares `-thin`, `-thin-distance` and the common options. */
  void declare (CommandLine& command_line);

  /** \brief Checks early that what the common options ask for can be written. */
  void checkReport () const;

  void describe (Report& report) const;

  /** \brief Sets them on a class. */
  template <typename Class>
  void apply (Class& object) const
  {
    object.setThinningNeighbors (neighbors);
    object.setThinningDistance (distance);
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

/** \brief The counts of a cloud from those of its sample set. */
PointCounts countsOf (const InputCloud& input, const SampleSet& samples);

/** \brief Says on standard error what was left out that a user would not expect to be. */
void noteLeftOut (const InputCloud& input, const PointCounts& counts, bool quiet);

/** \brief Reports how many samples of curves lie beside others, and says what helps where that is most of all, on
 * standard error as well. */
void describeContradiction (const InputCloud& input, std::size_t contradicted, const PointCounts& counts,
                            const SampleOptions& options, Report& report);

/** \brief Reports and tabulates what became of the points of a cloud, and the stages of a computation. */
void describeInput (const InputCloud& input, const PointCounts& counts, Report& report, Table& table);
void describeStages (const std::vector<Stage>& stages, Report& report, Table& table);

} // namespace pcl::manifold::apps
