#include "report.h"

#include "app_files.h"

#include <json/writer.h>

#include <cmath>
#include <iostream>

#include <sys/resource.h>

namespace pcl::manifold::apps {
namespace {

/** \brief The value with null for every number that JSON cannot express. */
Json::Value
finite (Json::Value value)
{
  if (value.isDouble () && !std::isfinite (value.asDouble ()))
    return Json::Value ();
  if (value.isArray () || value.isObject ())
    for (Json::Value& child : value)
      child = finite (child);
  return value;
}

} // namespace

std::uint64_t
peakResidentBytes ()
{
  struct rusage usage = {};
  getrusage (RUSAGE_SELF, &usage);
  constexpr std::uint64_t unit = 1024; // Linux counts in kilobytes
  return static_cast<std::uint64_t> (usage.ru_maxrss) * unit;
}

Report::Report (const std::string& app)
{
  root_["app"] = app;
  root_["version"] = PCL_MANIFOLD_VERSION;
  for (const char* const part : {"input", "parameters", "result"})
    root_[part] = Json::Value (Json::objectValue);
  for (const char* const part : {"summary", "stages"})
    root_[part] = Json::Value (Json::arrayValue);
}

void
Report::input (const std::string& name, const Json::Value& value)
{
  root_["input"][name] = finite (value);
}

void
Report::parameter (const std::string& name, const Json::Value& value)
{
  root_["parameters"][name] = finite (value);
}

void
Report::result (const std::string& name, const Json::Value& value)
{
  root_["result"][name] = finite (value);
}

void
Report::say (const std::vector<std::string>& lines)
{
  for (const std::string& line : lines)
    root_["summary"].append (line);
}

void
Report::stage (const std::string& name, double seconds)
{
  stage (name, seconds, peakResidentBytes ());
}

void
Report::stage (const std::string& name, double seconds, std::uint64_t peak_bytes)
{
  Json::Value entry (Json::objectValue);
  entry["name"] = name;
  entry["seconds"] = finite (seconds);
  entry["peak_bytes"] = Json::Value::UInt64 (peak_bytes);
  root_["stages"].append (entry);
}

void
Report::write (const std::string& file) const
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "  ";
  builder["precision"] = 17;
  writeFile (file, Json::writeString (builder, root_) + '\n');
}

void
Report::finish (const CommonOptions& options, const Table& table) const
{
  if (!options.report.empty ())
    write (options.report);
  if (options.quiet)
    return;
  for (const Json::Value& line : root_["summary"])
    std::cout << line.asString () << '\n';
  table.print (std::cout);
}

} // namespace pcl::manifold::apps
