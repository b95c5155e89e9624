#pragma once

#include "command_line.h"
#include "report.h"

#include <pcl/manifold/reconstruct_graph.h>

#include <string>

namespace pcl::manifold::apps {

/** \brief The options of the apps of GraphReconstruction. */
struct GraphOptions
{
  GraphParameters parameters; ///< with what the options say, once they are completed
  CommonOptions common;

  /** \brief Declares the options of the class; of the common ones only those that are asked for. */
  void declare (CommandLine& command_line);

  /** \brief To be called once the command line was read.
   * \throws UsageError for a word that names no rule */
  void complete ();

  void describe (Report& report) const;

  /** \brief Sets the parameters on a GraphReconstruction. */
  template <typename Class>
  void apply (Class& object) const
  {
    object.setKSearch (parameters.k_search);
    object.setHops (parameters.hops);
    object.setRefine (parameters.refine);
    object.setAdjacencyThreshold (parameters.adjacency_threshold);
    object.setAdjacencyRule (parameters.adjacency_rule);
    object.setFaceRule (parameters.face_rule);
    object.setMaximumFaceLength (parameters.maximum_face_length);
    object.setTriangulate (parameters.triangulate);
    object.setSeed (parameters.seed);
    object.setNumberOfThreads (parameters.threads);
  }

private:
  std::string rule_ = "points";
  std::string faces_ = "rotation";
  bool uniform_ = false;
  bool polygons_ = false;
};

/** \brief The word of the command line for a rule. */
std::string nameOf (AdjacencyRule rule);
std::string nameOf (FaceRule rule);

} // namespace pcl::manifold::apps
