#include "output_stream.h"

#include "app_error.h"
#include "atomic_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

void
pcl::manifold::apps::writeStream (const std::string& file, const std::function<void (std::ostream&)>& write)
{
  writeAtomically (file, [&] (const std::string& temporary) {
    errno = 0;
    std::ofstream stream (temporary, std::ios::binary | std::ios::trunc);
    if (stream)
      write (stream);
    stream.close ();
    if (!stream)
      throw AppError (file,
                      "cannot be written" +
                        (errno != 0 ? ": " + std::generic_category ().message (errno) : std::string ()));
  });
}
