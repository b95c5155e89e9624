#include "files/file_error.h"
#include "files/pcd_header.h"

#include <pcl/io/lzf.h>

#include <cstring>

namespace pcl::manifold {
namespace {

/** \brief Reads one point a line, one number for every value of every field. Empty lines are skipped. */
void
readRows (Scanner& scanner, pcl::PCLPointCloud2& cloud, std::uint64_t values)
{
  allocatePoints (cloud);
  const std::size_t points = static_cast<std::size_t> (cloud.width) * cloud.height;
  std::vector<std::string_view> words;
  for (std::size_t point = 0; point < points;) {
    if (!scanner.wordsOfLine (words))
      throw FileError ("truncated: the file ends after line " + std::to_string (scanner.lineNumber ()) +
                       ", with " + std::to_string (point) + " of " + std::to_string (points) +
                       " lines of points");
    if (words.empty ())
      continue;
    if (words.size () != values)
      scanner.failAtLine (std::to_string (words.size ()) + " numbers instead of " + std::to_string (values));
    const std::string_view* word = words.data ();
    for (const pcl::PCLPointField& field : cloud.fields) {
      std::uint8_t* to = cloud.data.data () + point * cloud.point_step + field.offset;
      for (std::size_t i = 0; i < field.count; ++i, ++word, to += sizeOf (field.datatype))
        if (!parseValue (*word, field.datatype, to))
          scanner.failAtLine (quoted (*word) + " is no value for field " + quoted (field.name));
    }
    ++point;
  }
}

/** \brief Reads exactly so many bytes. */
std::string_view
take (Scanner& scanner, std::size_t size, const std::string& what)
{
  if (size > scanner.remaining ())
    throw FileError ("truncated or corrupt: " + what + " from byte " + std::to_string (scanner.position ()) +
                     " should have " + std::to_string (size) + " bytes, but only " +
                     std::to_string (scanner.remaining ()) + " follow");
  return scanner.take (size);
}

/** \brief Reads the two size words and the block behind them, and unpacks it: all values of the first field,
 * then all of the second and so on. */
std::vector<std::uint8_t>
readCompressedBlock (Scanner& scanner, std::uint64_t expected)
{
  std::uint32_t sizes[2] = {0, 0};
  std::memcpy (sizes, take (scanner, sizeof (sizes), "the sizes of the compressed block").data (),
               sizeof (sizes));
  const auto [packed_size, size] = sizes;
  const std::string at = "the compressed block at byte " + std::to_string (scanner.position ());
  const std::string_view block = take (scanner, packed_size, "the compressed block");
  if (size != expected)
    throw FileError ("corrupt: " + at + " should unpack to " + std::to_string (size) +
                     " bytes, but the points of the header have " + std::to_string (expected));
  // Three bytes of an LZF stream unpack to at most 264: refuse sizes that cannot be before allocating them.
  if (expected > (static_cast<std::uint64_t> (packed_size) + 2) / 3 * 264)
    throw FileError ("corrupt: a compressed block of " + std::to_string (packed_size) +
                     " bytes cannot hold the " + std::to_string (expected) +
                     " bytes of the points of the header");
  std::vector<std::uint8_t> unpacked (size);
  if (pcl::lzfDecompress (block.data (), packed_size, unpacked.data (), size) != size)
    throw FileError ("corrupt: " + at + " cannot be unpacked");
  return unpacked;
}

void
readCompressed (Scanner& scanner, pcl::PCLPointCloud2& cloud)
{
  // Padding is not stored in compressed files.
  pcl::PCLPointCloud2 layout;
  layout.width = cloud.width;
  layout.height = cloud.height;
  for (const pcl::PCLPointField& field : cloud.fields)
    if (field.name != "_")
      appendField (layout, field.name, field.datatype, field.count);
  const std::size_t points = static_cast<std::size_t> (layout.width) * layout.height;
  const std::vector<std::uint8_t> block =
    readCompressedBlock (scanner, static_cast<std::uint64_t> (points) * layout.point_step);
  allocatePoints (layout);
  const std::uint8_t* from = block.data ();
  for (const pcl::PCLPointField& field : layout.fields) {
    const std::size_t bytes = field.count * sizeOf (field.datatype);
    for (std::size_t i = 0; i < points; ++i, from += bytes)
      std::memcpy (&layout.data[i * layout.point_step + field.offset], from, bytes);
  }
  cloud = std::move (layout);
}

} // namespace

FileContent
readPcd (std::string_view bytes)
{
  Scanner scanner (bytes);
  PcdHeader header = readPcdHeader (scanner);
  FileContent content;
  content.viewpoint = header.viewpoint;
  content.cloud = std::move (header.layout);
  pcl::PCLPointCloud2& cloud = content.cloud;
  if (header.data == PcdHeader::Data::ASCII)
    readRows (scanner, cloud, header.values);
  else if (header.data == PcdHeader::Data::BINARY_COMPRESSED)
    readCompressed (scanner, cloud);
  else {
    const std::size_t size = static_cast<std::size_t> (cloud.point_step) * header.points;
    const std::string_view points = take (scanner, size, "the points");
    allocatePoints (cloud);
    std::memcpy (cloud.data.data (), points.data (), size);
  }
  if (findField (cloud, "_") != nullptr)
    cloud = packed (cloud);
  return content;
}

} // namespace pcl::manifold
