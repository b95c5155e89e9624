#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace pcl::manifold::apps {

/** \brief A count, its digits in groups of three: 1 234 567. */
std::string grouped (std::size_t count);

/** \brief Text in two aligned columns; the second one may have several lines. */
class Table
{
public:
  void row (const std::string& name, const std::string& value) { rows_.emplace_back (name, value); }

  void row (const std::string& name, std::size_t count) { row (name, grouped (count)); }

  /** \brief A number with its unit, to three digits behind the point. */
  void row (const std::string& name, double value, const std::string& unit);

  /** \brief Prints all rows, each indented by two spaces. */
  void print (std::ostream& stream) const;

private:
  std::vector<std::pair<std::string, std::string>> rows_;
};

} // namespace pcl::manifold::apps
