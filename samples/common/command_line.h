#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief The values that a number on the command line may have. NaN is never in a range. */
struct Range
{
  double low = -std::numeric_limits<double>::infinity ();
  double high = std::numeric_limits<double>::infinity ();
  bool open = false; ///< low and high themselves are not allowed
};

/** \brief The options that every app has. */
struct CommonOptions
{
  int threads = 0;     ///< 0 = all
  std::string report;  ///< file of the report; empty: none
  std::string picture; ///< file of the picture; empty: none
  bool quiet = false;  ///< print nothing but errors
};

/** \brief The command line of an app: declared once, from which it is read and its help is printed. Options
 * are written as in PCL's tools, `-rho 0.3`; `--rho 0.3`, `-rho=0.3` and negative numbers as values are
 * understood.
 *
 * Every option is bound to a variable, whose value at the time is the default that the help shows. */
class CommandLine
{
public:
  /** \param[in] app its name
   * \param[in] purpose what it does, in a line or a few */
  CommandLine (const std::string& app, const std::string& purpose);

  /** \brief Declares the next argument without a name, such as INPUT; all of them are required. */
  CommandLine& positional (const std::string& name, const std::string& help, std::string& target);

  /** \brief Declares an option with a value.
   * \param[in] name without a dash
   * \param[in] value what the help calls the value
   * \param[in] help what it means; may have several lines
   * \param[in,out] target its default; set by parse ()
   * \param[in] range the values that are accepted */
  CommandLine& option (const std::string& name, const std::string& value, const std::string& help,
                       double& target, const Range& range = {});
  CommandLine& option (const std::string& name, const std::string& value, const std::string& help,
                       int& target, const Range& range = {});
  CommandLine& option (const std::string& name, const std::string& value, const std::string& help,
                       std::uint64_t& target, const Range& range = {});
  CommandLine& option (const std::string& name, const std::string& value, const std::string& help,
                       std::string& target);

  /** \brief Declares an option without a value; parse () sets `target` to true if it is there. */
  CommandLine& flag (const std::string& name, const std::string& help, bool& target);

  /** \brief Says that the file an option or argument names will be written: no two of these may be the same,
   * and only OUTPUT may be one that is read. OUTPUT, `-report` and `-picture` are known to be written.
   * \param[in] name for the error message
   * \param[in] file a variable that another call declares */
  CommandLine& writes (const std::string& name, const std::string& file);

  /** \brief Declares `-threads`, `-report`, `-picture` and `-quiet`. */
  CommandLine& common (CommonOptions& target);

  /** \brief Adds a line to the examples of the help. */
  CommandLine& example (const std::string& line);

  /** \brief Reads the command line into the variables.
   * \return false if the user asked for help: by `-h`, `-help`, `--help` or by no argument at all
   * \throws UsageError that names the option or argument which is wrong */
  bool parse (int argc, const char* const* argv);

  void printHelp (std::ostream& stream) const;

  const std::string& app () const { return app_; }

  /** \brief What failures of no other file are about: the first argument without a name, or else the app. */
  const std::string& subject () const { return subject_; }

private:
  struct Positional
  {
    std::string name, help;
    std::string* target;
  };

  struct Option
  {
    std::string name, value, help, default_text;
    std::function<void (const std::string&)> assign; ///< throws UsageError
  };

  struct Output
  {
    std::string name;
    const std::string* file;
  };

  void takePositionals (const std::vector<std::string>& values);
  void checkOutputs () const;

  std::string app_, purpose_, subject_;
  std::vector<Positional> positionals_;
  std::vector<Option> options_;
  std::vector<Output> outputs_;
  std::vector<std::string> examples_;
};

} // namespace pcl::manifold::apps
