#include "sample_input.h"

#include "app_files.h"

#include <pcl/conversions.h>

#include <algorithm>
#include <iostream>

namespace pcl::manifold::apps {

void
ThinningOptions::declare (CommandLine& command_line)
{
  command_line
    .option ("thin", "k",
             "thin the cloud: no two samples among each other's k nearest neighbours; 0 = off.\n"
             "4 to 8 for airborne scans, 12 to 48 for random or noisy points: no more than it takes",
             neighbors, {0, 100000})
    .option ("thin-distance", "h", "thin the cloud: no two samples nearer than h; 0 = off", distance,
             {0, 1e300})
    .renamed ("k", "thin")
    .renamed ("spacing", "thin-distance")
    .common (common);
}

void
ThinningOptions::checkReport () const
{
  if (!common.report.empty ())
    checkWritable (common.report);
}

void
ThinningOptions::describe (Report& report) const
{
  report.parameter ("thin", neighbors);
  report.parameter ("thin_distance", distance);
  report.parameter ("threads", common.threads);
}

void
SampleOptions::declare (CommandLine& command_line)
{
  command_line.option ("rho", "r", "largest ratio of heights that still makes a normal direction, in (0, 1]",
                       rho, {1e-9, 1.0});
  ThinningOptions::declare (command_line);
}

void
SampleOptions::describe (Report& report) const
{
  report.parameter ("rho", rho);
  ThinningOptions::describe (report);
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
pointsOf (const InputCloud& input)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> ();
  pcl::fromPCLPointCloud2 (input.cloud, *cloud);
  return cloud;
}

void
printNotes (const InputCloud& input, bool quiet)
{
  if (!quiet)
    for (const std::string& note : input.notes)
      std::cerr << input.file << ": " << note << "\n";
}

PointCounts
countsOf (const InputCloud& input, const SampleSet& samples)
{
  PointCounts counts;
  counts.points = input.size ();
  counts.dropped = samples.non_finite - input.no_measurement; // these are NaN by now
  counts.no_measurement = samples.no_measurement + input.no_measurement;
  counts.duplicates = samples.duplicates;
  counts.thinned = samples.thinned;
  counts.samples = static_cast<std::size_t> (samples.size ());
  return counts;
}

void
noteLeftOut (const InputCloud& input, const PointCounts& counts, bool quiet)
{
  if (!quiet && counts.no_measurement > 0)
    std::cerr << input.file << ": " << counts.no_measurement
              << " points at one place far from all others left out: no measurement\n";
}

void
describeContradiction (const InputCloud& input, std::size_t contradicted, const PointCounts& counts,
                       const SampleOptions& options, Report& report)
{
  constexpr int K = 8; // made one surface of most such clouds
  report.result ("contradicted", Json::UInt64 (contradicted));
  if (2 * contradicted <= counts.samples)
    return;
  const std::string note = std::to_string (100 * contradicted / counts.samples) +
                           " % of the samples look like ones of curves, but others lie beside these: points "
                           "of a surface in rows, or noisy "
                           "ones. Try -thin " +
                           std::to_string (std::max (K, 2 * options.neighbors)) +
                           ", or for surfaces pcl_fixed_point_reconstruction";
  report.say ({note});
  if (!options.common.quiet)
    std::cerr << input.file << ": " << note << "\n";
}

void
describeInput (const InputCloud& input, const PointCounts& counts, Report& report, Table& table)
{
  report.input ("file", input.file);
  report.input ("points", Json::UInt64 (counts.points));
  report.input ("dropped", Json::UInt64 (counts.dropped));
  report.input ("no_measurement", Json::UInt64 (counts.no_measurement));
  report.input ("duplicates", Json::UInt64 (counts.duplicates));
  report.input ("thinned", Json::UInt64 (counts.thinned));
  report.input ("samples", Json::UInt64 (counts.samples));
  Json::Value origin (Json::arrayValue);
  for (const double coordinate : input.origin)
    origin.append (coordinate + 0.0); // no -0
  report.input ("origin", origin);
  Json::Value notes (Json::arrayValue);
  for (const std::string& note : input.notes)
    notes.append (note);
  report.input ("notes", notes);
  report.say ({inWords (counts)});
  table.row ("samples", counts.samples);
}

void
describeStages (const std::vector<Stage>& stages, Report& report, Table& table)
{
  double total = 0.0;
  for (const Stage& stage : stages) {
    report.stage (stage.name, stage.seconds, stage.peak_bytes);
    total += stage.seconds;
  }
  table.row ("time", total, "s");
}

} // namespace pcl::manifold::apps
