#pragma once

#include <boost/program_options.hpp>

#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief The values that a number on the command line may have, both ends among them; never NaN. */
struct Range
{
  double low = -1e300;
  double high = 1e300;
};

/** \brief The options that every app has. */
struct CommonOptions
{
  int threads = 0;     ///< 0 = all
  std::string report;  ///< file of the report; empty: none
  std::string picture; ///< file of the picture; empty: none
  bool quiet = false;  ///< print nothing but errors
};

/** \brief The command line of an app: Boost's, with the options and the messages of PCL's tools. Options are
 * written `-rho 0.3`; `--rho 0.3`, `-rho=0.3` and negative numbers as values are understood. Every one is
 * bound to a variable, whose value at the time is the default that the help shows. */
class CommandLine
{
public:
  CommandLine (const std::string& app, const std::string& purpose)
    : app_ (app), purpose_ (purpose), subject_ (app)
  {}

  /** \brief Declares the next argument without a name, such as INPUT: all of them, before all options. */
  CommandLine& positional (const std::string& name, const std::string& help, std::string& target);

  /** \brief Declares an option with a value: a double, int, std::uint64_t or std::string.
   * \param[in] name without a dash
   * \param[in] value what the help calls the value
   * \param[in] help what it means; may have several lines
   * \param[in,out] target its default; set by parse ()
   * \param[in] range the numbers that are accepted */
  template <typename T>
  CommandLine& option (const std::string& name, const std::string& value, const std::string& help, T& target,
                       const Range& range = {});

  /** \brief Declares an option with several numbers behind it, `-origin 0 0 1.7`.
   * \param[in] values what the help calls them
   * \param[in] count how many there are
   * \param[out] target none, or that many */
  CommandLine& numbers (const std::string& name, const std::string& values, const std::string& help,
                        std::size_t count, std::vector<double>& target);

  /** \brief Declares an option without a value; parse () sets `target` to true if it is there, else false. */
  CommandLine& flag (const std::string& name, const std::string& help, bool& target);

  /** \brief Declares `-threads`, `-report`, `-picture` and `-quiet`. */
  CommandLine& common (CommonOptions& target);

  /** \brief Says that a file will be written: no two of these may be the same, and only OUTPUT may be one that
   * is read. OUTPUT, `-report` and `-picture` are known.
   * \param[in] name of the option or argument, for the message
   * \param[in] file a variable that another call declares */
  CommandLine& writes (const std::string& name, const std::string& file);

  /** \brief Who uses a former name of an option is told the present one; both without a dash. */
  CommandLine& renamed (const std::string& former, const std::string& name);

  /** \brief Adds a line to the examples of the help. */
  CommandLine& example (const std::string& line);

  /** \brief Reads the command line into the variables.
   * \return false if the user asked for help: by `-h`, `-help`, `--help` or by no argument at all
   * \throws UsageError that names the option or argument which is wrong */
  bool parse (int argc, const char* const* argv);

  void printHelp (std::ostream& stream) const;

  /** \brief What failures of no other file are about: the first argument without a name, or else the app. */
  const std::string& subject () const { return subject_; }

private:
  struct File
  {
    std::string name;
    const std::string* file;
    bool is_written;
  };

  void checkParsed (const std::vector<boost::program_options::option>& parsed);
  void checkFiles () const;

  std::string app_, purpose_, subject_, examples_;
  boost::program_options::options_description arguments_, options_;
  std::vector<File> files_;
  std::map<std::string, std::string> renamed_;
  std::map<std::string, std::size_t> counts_; // of numbers behind options
};

} // namespace pcl::manifold::apps
