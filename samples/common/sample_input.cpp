#include "sample_input.h"

#include "atomic_file.h"

#include <pcl/conversions.h>

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

void
describeInput (const InputCloud& input, const SampleSet& samples, Report& report, Table& table)
{
  describeInput (input,
                 {input.size (), samples.non_finite, samples.duplicates, samples.thinned,
                  static_cast<std::size_t> (samples.size ())},
                 report, table);
}

void
describeInput (const InputCloud& input, const PointCounts& counts, Report& report, Table& table)
{
  report.input ("file", input.file);
  report.input ("points", Json::UInt64 (counts.points));
  report.input ("dropped", Json::UInt64 (counts.dropped));
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
