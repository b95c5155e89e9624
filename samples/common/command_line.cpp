#include "command_line.h"

#include "app_error.h"
#include "app_files.h"
#include "files/number_text.h"
#include "table.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <type_traits>

namespace pcl::manifold::apps {
namespace {

namespace po = boost::program_options;

// The argument without a name that is written.
const std::string OUTPUT = "OUTPUT";

template <typename T>
std::string
textOf (const T& value)
{
  std::ostringstream text;
  text << value;
  return text.str ();
}

std::string
describe (const Range& range)
{
  if (std::isinf (range.high))
    return (range.open ? "more than " : "at least ") + textOf (range.low);
  if (std::isinf (range.low))
    return (range.open ? "less than " : "at most ") + textOf (range.high);
  return (range.open ? "between " : "from ") + textOf (range.low) + (range.open ? " and " : " to ") +
         textOf (range.high);
}

bool
contains (const Range& range, double number)
{
  return range.open ? number > range.low && number < range.high : number >= range.low && number <= range.high;
}

/** \brief Reads a number into `target`. */
template <typename T>
std::function<void (const std::string&)>
numberReader (const std::string& name, T& target, const Range& range)
{
  return [name, &target, range] (const std::string& text) {
    T number{};
    if (!parseNumber (std::string_view (text), number))
      throw UsageError ("-" + name, "'" + text + "' is no " +
                                      (std::is_integral_v<T> ? "whole number that fits" : "number"));
    if (!contains (range, static_cast<double> (number)))
      throw UsageError ("-" + name, "'" + text + "' is not " + describe (range));
    target = number;
  };
}

/** \brief The message of the library for an option, in our words. */
UsageError
usageErrorOf (const po::error_with_option_name& error)
{
  std::string name = error.get_option_name ();
  name = "-" + name.substr (std::min (name.find_first_not_of ('-'), name.size ()));
  name = name.substr (0, name.find ('='));
  if (dynamic_cast<const po::unknown_option*> (&error) != nullptr)
    return UsageError (name, "unknown option, see -h");
  if (const auto* syntax = dynamic_cast<const po::invalid_command_line_syntax*> (&error)) {
    if (syntax->kind () == po::invalid_syntax::extra_parameter)
      return UsageError (name, "takes no value");
    return UsageError (name, "needs a value");
  }
  return UsageError (name, error.what ());
}

} // namespace

CommandLine::CommandLine (const std::string& app, const std::string& purpose)
  : app_ (app), purpose_ (purpose), subject_ (app)
{}

CommandLine&
CommandLine::positional (const std::string& name, const std::string& help, std::string& target)
{
  positionals_.push_back ({name, help, &target});
  if (name == OUTPUT)
    writes (name, target);
  return *this;
}

CommandLine&
CommandLine::option (const std::string& name, const std::string& value, const std::string& help,
                     double& target, const Range& range)
{
  options_.push_back ({name, value, help, textOf (target), numberReader (name, target, range)});
  return *this;
}

CommandLine&
CommandLine::option (const std::string& name, const std::string& value, const std::string& help, int& target,
                     const Range& range)
{
  options_.push_back ({name, value, help, textOf (target), numberReader (name, target, range)});
  return *this;
}

CommandLine&
CommandLine::option (const std::string& name, const std::string& value, const std::string& help,
                     std::uint64_t& target, const Range& range)
{
  options_.push_back ({name, value, help, textOf (target), numberReader (name, target, range)});
  return *this;
}

CommandLine&
CommandLine::option (const std::string& name, const std::string& value, const std::string& help,
                     std::string& target)
{
  options_.push_back ({name, value, help, target, [&target] (const std::string& text) { target = text; }});
  return *this;
}

CommandLine&
CommandLine::flag (const std::string& name, const std::string& help, bool& target)
{
  options_.push_back ({name, "", help, "", [&target] (const std::string&) { target = true; }});
  return *this;
}

CommandLine&
CommandLine::writes (const std::string& name, const std::string& file)
{
  outputs_.push_back ({name, &file});
  return *this;
}

CommandLine&
CommandLine::common (CommonOptions& target)
{
  option ("threads", "n", "number of threads, 0 = all", target.threads, {0, 1024});
  option ("report", "FILE.json", "write a report", target.report);
  options_.push_back (
    {"picture", "FILE.png", "draw a picture", target.picture, [&target] (const std::string& text) {
       requireType ("-picture", text, {".png"});
       target.picture = text;
     }});
  writes ("-report", target.report);
  writes ("-picture", target.picture);
  return flag ("quiet", "print nothing but errors", target.quiet);
}

CommandLine&
CommandLine::example (const std::string& line)
{
  examples_.push_back (line);
  return *this;
}

bool
CommandLine::parse (int argc, const char* const* argv)
{
  const std::vector<std::string> arguments (argv + std::min (argc, 1), argv + argc);
  const auto asks_for_help = [] (const std::string& argument) {
    return argument == "-h" || argument == "-help" || argument == "--help";
  };
  if (arguments.empty () || std::any_of (arguments.begin (), arguments.end (), asks_for_help))
    return false;

  po::options_description description;
  for (const Option& option : options_)
    if (option.value.empty ())
      description.add_options () (option.name.c_str (), "");
    else
      description.add_options () (option.name.c_str (), po::value<std::string> ());
  namespace style = po::command_line_style;
  std::vector<po::option> parsed;
  try {
    parsed = po::command_line_parser (arguments)
               .options (description)
               .style (style::allow_long_disguise | style::allow_long | style::long_allow_adjacent |
                       style::long_allow_next)
               .run ()
               .options;
  } catch (const po::error_with_option_name& error) {
    throw usageErrorOf (error);
  }

  std::vector<std::string> positionals;
  std::set<std::string> seen;
  for (const po::option& found : parsed) {
    if (found.string_key.empty ()) {
      positionals.insert (positionals.end (), found.value.begin (), found.value.end ());
      continue;
    }
    if (!seen.insert (found.string_key).second)
      throw UsageError ("-" + found.string_key, "given more than once");
    // The library takes a following option for the value if it is written with a single dash.
    for (const Option& option : options_)
      if (!found.value.empty () && found.value.front () == "-" + option.name)
        throw UsageError ("-" + found.string_key, "needs a value");
  }
  takePositionals (positionals);
  for (const po::option& found : parsed)
    for (const Option& option : options_)
      if (option.name == found.string_key)
        option.assign (found.value.empty () ? std::string () : found.value.front ());
  checkOutputs ();
  return true;
}

void
CommandLine::checkOutputs () const
{
  const auto areSame = [] (const std::string& a, const std::string& b) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    // Devices can take any number of outputs.
    if (a.empty () || b.empty () || (fs::exists (a, ignored) && !fs::is_regular_file (a, ignored)))
      return false;
    return fs::weakly_canonical (a, ignored) == fs::weakly_canonical (b, ignored);
  };
  for (auto output = outputs_.begin (); output != outputs_.end (); ++output) {
    for (auto other = outputs_.begin (); other != output; ++other)
      if (areSame (*output->file, *other->file))
        throw UsageError (output->name, "names the same file as " + other->name);
    for (const Positional& positional : positionals_)
      if (positional.target != output->file && output->name != OUTPUT &&
          areSame (*output->file, *positional.target))
        throw UsageError (output->name, "names the same file as " + positional.name);
  }
}

void
CommandLine::takePositionals (const std::vector<std::string>& values)
{
  // An unknown option with a single dash looks like a file to the library.
  for (const std::string& value : values)
    if (value.size () > 1 && value[0] == '-')
      throw UsageError (value, "unknown option, see -h");
  if (values.size () > positionals_.size ())
    throw UsageError ("'" + values[positionals_.size ()] + "'", "one argument too many, see -h");
  if (values.size () < positionals_.size ())
    throw UsageError (positionals_[values.size ()].name, "missing, see -h");
  for (std::size_t i = 0; i < values.size (); ++i) {
    if (values[i].empty ())
      throw UsageError (positionals_[i].name, "is empty");
    *positionals_[i].target = values[i];
  }
  if (!values.empty ())
    subject_ = values.front ();
}

void
CommandLine::printHelp (std::ostream& stream) const
{
  Table arguments;
  stream << "Usage: " << app_;
  for (const Positional& positional : positionals_) {
    stream << ' ' << positional.name;
    arguments.row (positional.name, positional.help);
  }
  Table options;
  for (const Option& option : options_)
    options.row ("-" + option.name + (option.value.empty () ? "" : " ") + option.value,
                 option.help +
                   (option.default_text.empty () ? "" : " (default " + option.default_text + ")"));
  options.row ("-h", "print this help");
  stream << " [-option value ...]\n\n" << purpose_ << "\n\n";
  arguments.print (stream);
  stream << "\nOptions:\n";
  options.print (stream);
  if (!examples_.empty ())
    stream << (examples_.size () == 1 ? "\nExample:\n" : "\nExamples:\n");
  for (const std::string& example : examples_)
    stream << "  " << example << '\n';
  stream << "\nExit status: 0 done, 1 bad input or failure, 2 wrong usage.\n";
}

} // namespace pcl::manifold::apps
