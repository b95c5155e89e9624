#include "command_line.h"

#include "app_error.h"
#include "app_files.h"
#include "files/number_text.h"
#include "table.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace pcl::manifold::apps {
namespace {

namespace po = boost::program_options;
namespace fs = std::filesystem;

constexpr int STYLE = po::command_line_style::allow_long_disguise | po::command_line_style::allow_long |
                      po::command_line_style::long_allow_adjacent | po::command_line_style::long_allow_next;

/** \brief Reads a number, which Boost would do too, but that it takes -1 for a large number without a sign. */
template <typename T>
void
assign (const std::string& option, const std::string& word, const Range& range, T& target)
{
  T number{};
  if (!parseNumber (std::string_view (word), number))
    throw UsageError (option, "'" + word + "' is no " + (T (0.5) == 0 ? "whole number that fits" : "number"));
  if (const auto real = static_cast<double> (number); !(real >= range.low && real <= range.high)) {
    std::ostringstream text;
    text << "'" << word << "' is not from " << range.low << " to " << range.high;
    throw UsageError (option, text.str ());
  }
  target = number;
}

void
assign (const std::string&, const std::string& word, const Range&, std::string& target)
{
  target = word;
}

} // namespace

CommandLine&
CommandLine::positional (const std::string& name, const std::string& help, std::string& target)
{
  arguments_.add_options () (name.c_str (), po::value (&target)->required (), help.c_str ());
  files_.push_back ({name, &target, name == "OUTPUT"});
  return *this;
}

template <typename T>
CommandLine&
CommandLine::option (const std::string& name, const std::string& value, const std::string& help, T& target,
                     const Range& range)
{
  std::ostringstream text;
  text << target;
  const std::string shown = text.str ().empty () ? help : help + " (default " + text.str () + ")";
  const auto assigner = [=, &target] (const std::string& word) { assign ("-" + name, word, range, target); };
  options_.add_options () (name.c_str (), po::value<std::string> ()->value_name (value)->notifier (assigner),
                           shown.c_str ());
  return *this;
}

CommandLine&
CommandLine::numbers (const std::string& name, const std::string& values, const std::string& help,
                      std::size_t count, std::vector<double>& target)
{
  const auto assigner = [=, &target] (const std::string& words) {
    std::istringstream stream (words);
    std::vector<double> read;
    for (std::string word; stream >> word;)
      assign ("-" + name, word, Range (), read.emplace_back ());
    if (read.size () != count)
      throw UsageError ("-" + name, "needs " + std::to_string (count) + " numbers");
    target = read;
  };
  options_.add_options () (name.c_str (), po::value<std::string> ()->value_name (values)->notifier (assigner),
                           help.c_str ());
  counts_["-" + name] = count;
  return *this;
}

// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name)
using Text = const std::string&;
template CommandLine& CommandLine::option (Text, Text, Text, double&, const Range&);
template CommandLine& CommandLine::option (Text, Text, Text, int&, const Range&);
template CommandLine& CommandLine::option (Text, Text, Text, std::uint64_t&, const Range&);
template CommandLine& CommandLine::option (Text, Text, Text, std::string&, const Range&);
// NOLINTEND(readability-inconsistent-declaration-parameter-name)

CommandLine&
CommandLine::flag (const std::string& name, const std::string& help, bool& target)
{
  options_.add_options () (name.c_str (), po::bool_switch (&target), help.c_str ());
  return *this;
}

CommandLine&
CommandLine::common (CommonOptions& target)
{
  return option ("threads", "n", "number of threads, 0 = all", target.threads, {0, 1024})
    .option ("report", "FILE.json", "write a report", target.report)
    .option ("picture", "FILE.png", "draw a picture", target.picture)
    .flag ("quiet", "print nothing but errors", target.quiet)
    .writes ("-report", target.report)
    .writes ("-picture", target.picture);
}

CommandLine&
CommandLine::writes (const std::string& name, const std::string& file)
{
  files_.push_back ({name, &file, true});
  return *this;
}

CommandLine&
CommandLine::renamed (const std::string& former, const std::string& name)
{
  renamed_["-" + former] = "now -" + name + ", ";
  return *this;
}

CommandLine&
CommandLine::example (const std::string& line)
{
  examples_ += "  " + line + "\n";
  return *this;
}

bool
CommandLine::parse (int argc, const char* const* argv)
{
  std::vector<std::string> words (argv + std::min (argc, 1), argv + argc);
  if (words.empty () || std::any_of (words.begin (), words.end (), [] (const std::string& word) {
        return word == "-h" || word == "-help" || word == "--help";
      }))
    return false;
  // Boost takes one value behind an option: the numbers that belong together become one word.
  for (std::size_t i = 0; i + 1 < words.size (); ++i)
    if (const auto count = counts_.find (words[i]); count != counts_.end ())
      for (std::size_t more = 1; more < count->second && i + 2 < words.size (); ++more) {
        words[i + 1] += ' ' + words[i + 2];
        words.erase (words.begin () + static_cast<std::ptrdiff_t> (i) + 2);
      }
  po::options_description all;
  all.add (arguments_).add (options_);
  po::positional_options_description order;
  for (const auto& argument : arguments_.options ())
    order.add (argument->long_name ().c_str (), 1);
  order.add ("more", -1); // what is too much is told below by its name
  po::command_line_parser parser (words);
  try {
    const po::parsed_options parsed = parser.options (all).positional (order).style (STYLE).run ();
    checkParsed (parsed.options);
    po::variables_map values;
    po::store (parsed, values);
    po::notify (values);
  } catch (const po::required_option& error) {
    throw UsageError (error.get_option_name ().substr (2), "missing, see -h");
  } catch (const po::error_with_option_name& error) {
    // Boost names an option with one dash or two, and with its value.
    std::string name = error.get_option_name ();
    name = "-" + name.substr (name.find_first_not_of ('-'), name.find ('=') - name.find_first_not_of ('-'));
    if (dynamic_cast<const po::unknown_option*> (&error) != nullptr)
      throw UsageError (name, "unknown option, " + renamed_[name] + "see -h");
    if (dynamic_cast<const po::multiple_occurrences*> (&error) != nullptr)
      throw UsageError (name, "given more than once");
    const auto* const syntax = dynamic_cast<const po::invalid_syntax*> (&error);
    const bool is_extra = syntax != nullptr && syntax->kind () == po::invalid_syntax::extra_parameter;
    throw UsageError (name, is_extra ? "takes no value" : "needs a value");
  }
  checkFiles ();
  return true;
}

/** \brief Finds the mistakes that Boost does not see. */
void
CommandLine::checkParsed (const std::vector<po::option>& parsed)
{
  for (const po::option& found : parsed) {
    const std::string value = found.value.empty () ? "" : found.value.front ();
    const bool has_dash = value.size () > 1 && value[0] == '-';
    // With a single dash the next option looks like a value to Boost, and an unknown one like a file.
    if (found.position_key < 0 && has_dash && options_.find_nothrow (value.substr (1), false) != nullptr)
      throw UsageError ("-" + found.string_key, "needs a value");
    if (found.string_key == "picture")
      requireType ("-picture", value, {".png"});
    if (found.position_key < 0)
      continue;
    if (has_dash)
      throw po::unknown_option (value);
    if (static_cast<std::size_t> (found.position_key) >= arguments_.options ().size ())
      throw UsageError ("'" + value + "'", "one argument too many, see -h");
    if (value.empty ())
      throw UsageError (found.string_key, "is empty");
    if (found.position_key == 0)
      subject_ = value;
  }
}

void
CommandLine::checkFiles () const
{
  std::map<fs::path, File> places;
  for (const auto& [name, file, is_written] : files_) {
    std::error_code ignored;
    // Devices can take any number of outputs.
    if (file->empty () || (fs::exists (*file, ignored) && !fs::is_regular_file (*file, ignored)))
      continue;
    // A relative name of a file that is not there yet would stay as it is.
    const fs::path path = fs::weakly_canonical (fs::absolute (*file, ignored), ignored);
    const auto [place, is_new] = places.emplace (path, File{name, file, is_written});
    if (!is_new && is_written && (name != "OUTPUT" || place->second.is_written))
      throw UsageError (name, "names the same file as " + place->second.name);
  }
}

void
CommandLine::printHelp (std::ostream& stream) const
{
  Table arguments;
  Table options;
  stream << "Usage: " << app_;
  for (const auto& argument : arguments_.options ()) {
    stream << ' ' << argument->long_name ();
    arguments.row (argument->long_name (), argument->description ());
  }
  for (const auto& option : options_.options ())
    options.row (option->canonical_display_name (po::command_line_style::allow_long_disguise) + " " +
                   option->format_parameter (),
                 option->description ());
  options.row ("-h", "print this help");
  stream << " [-option value ...]\n\n" << purpose_ << "\n\n";
  arguments.print (stream);
  stream << "\nOptions:\n";
  options.print (stream);
  stream << "\nFor example:\n"
         << examples_ << "\nExit status: 0 done, 1 bad input or failure, 2 wrong usage.\n";
}

} // namespace pcl::manifold::apps
