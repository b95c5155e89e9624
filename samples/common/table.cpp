#include "table.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace pcl::manifold::apps {

std::string
grouped (std::size_t count)
{
  std::string digits = std::to_string (count);
  for (std::size_t i = digits.size (); i > 3;) {
    i -= 3;
    digits.insert (i, " ");
  }
  return digits;
}

void
Table::row (const std::string& name, double value, const std::string& unit)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision (3) << value << (unit.empty () ? "" : " ") << unit;
  row (name, text.str ());
}

void
Table::print (std::ostream& stream) const
{
  std::size_t width = 0;
  for (const auto& [name, value] : rows_)
    width = std::max (width, name.size ());
  for (const auto& [name, value] : rows_) {
    stream << "  " << name << std::string (width - name.size () + 2, ' ');
    for (const char c : value) {
      stream << c;
      if (c == '\n')
        stream << std::string (width + 4, ' ');
    }
    stream << '\n';
  }
  stream.flush ();
}

} // namespace pcl::manifold::apps
