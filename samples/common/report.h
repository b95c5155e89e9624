#pragma once

#include "command_line.h"
#include "table.h"

#include <json/value.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief Largest amount of memory that the program had resident so far, in bytes. */
std::uint64_t peakResidentBytes ();

/** \brief What an app did, as JSON: `app`, `version`, `summary`, `input`, `parameters`, `stages` and `result`. The keys
 * of an object are in alphabetical order, numbers at full precision; a number that is not finite becomes
 * null. */
class Report
{
public:
  /** \param[in] app name of the app */
  explicit Report (const std::string& app);

  /** \brief Sets an entry of `input`, such as `file`, `points`, `dropped`, `duplicates`, `samples`, `origin`.
   */
  void input (const std::string& name, const Json::Value& value);

  /** \brief Sets an entry of `parameters`: a parameter as it was used. */
  void parameter (const std::string& name, const Json::Value& value);

  /** \brief Sets an entry of `result`. */
  void result (const std::string& name, const Json::Value& value);

  /** \brief Appends lines to `summary`: what a user should know first, in words. */
  void say (const std::vector<std::string>& lines);

  /** \brief Appends a stage with the time it took and the peak of memory so far. */
  void stage (const std::string& name, double seconds);

  /** \brief Appends a stage with the time it took and the peak of memory when it ended. */
  void stage (const std::string& name, double seconds, std::uint64_t peak_bytes);

  /** \brief The whole report. */
  const Json::Value& json () const { return root_; }

  /** \brief Writes it, atomically.
   * \throws AppError if that fails */
  void write (const std::string& file) const;

  /** \brief The end of an app: writes the report if that was asked for, and prints the summary and a table
   * unless quiet.
   * \throws AppError if writing fails */
  void finish (const CommonOptions& options, const Table& table) const;

private:
  Json::Value root_;
};

/** \brief Measures a stage, from its construction to its destruction. */
class StageTimer
{
public:
  StageTimer (Report& report, const std::string& name) : report_ (report), name_ (name) {}

  StageTimer (const StageTimer&) = delete;
  StageTimer& operator= (const StageTimer&) = delete;

  ~StageTimer ()
  {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now () - begin_;
    report_.stage (name_, seconds.count ());
  }

private:
  Report& report_;
  std::string name_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now ();
};

} // namespace pcl::manifold::apps
