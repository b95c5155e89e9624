#include "pcd_reader.h"

#include "cloud_fields.h"
#include "pcd_header.h"
#include "text_rows.h"

#include <pcl/io/lzf.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl::manifold::apps {
namespace {

/** \brief Reads the two size words and the block behind them, and unpacks it: all values of the first field,
 * then all of the second and so on. */
std::vector<std::uint8_t>
readCompressedBlock (InputFile& file, std::uint64_t expected)
{
  std::uint32_t sizes[2] = {0, 0};
  file.readBytes (sizes, sizeof (sizes), "the sizes of the compressed block");
  const auto [packed_size, size] = sizes;
  if (packed_size > file.remaining ())
    file.fail ("truncated or corrupt: the compressed block at byte " + std::to_string (file.offset ()) +
               " should have " + std::to_string (packed_size) + " bytes, but only " +
               std::to_string (file.remaining ()) + " follow");
  if (size != expected)
    file.fail ("corrupt: the compressed block at byte " + std::to_string (file.offset ()) +
               " should unpack to " + std::to_string (size) + " bytes, but the points of the header have " +
               std::to_string (expected));
  // Three bytes of an LZF stream unpack to at most 264: refuse sizes that cannot be before allocating them.
  if (expected > (static_cast<std::uint64_t> (packed_size) + 2) / 3 * 264)
    file.fail ("corrupt: a compressed block of " + std::to_string (packed_size) + " bytes cannot hold the " +
               std::to_string (expected) + " bytes of the points of the header");
  std::vector<std::uint8_t> block (packed_size);
  std::vector<std::uint8_t> unpacked (size);
  const std::uint64_t begin = file.offset ();
  file.readBytes (block.data (), packed_size, "the compressed block");
  if (pcl::lzfDecompress (block.data (), packed_size, unpacked.data (), size) != size)
    file.fail ("corrupt: the compressed block at byte " + std::to_string (begin) + " cannot be unpacked");
  return unpacked;
}

void
readCompressed (InputFile& file, pcl::PCLPointCloud2& cloud)
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
    readCompressedBlock (file, static_cast<std::uint64_t> (points) * layout.point_step);
  allocatePoints (layout);
  const std::uint8_t* from = block.data ();
  for (const pcl::PCLPointField& field : layout.fields) {
    const std::uint32_t bytes = fieldBytes (field);
    for (std::size_t i = 0; i < points; ++i, from += bytes)
      std::memcpy (&layout.data[i * layout.point_step + field.offset], from, bytes);
  }
  cloud = std::move (layout);
}

} // namespace

pcl::PCLPointCloud2
readPcd (const std::string& file, std::array<double, 7>& viewpoint)
{
  InputFile input (file);
  PcdHeader header = readPcdHeader (input);
  viewpoint = header.viewpoint;
  pcl::PCLPointCloud2& cloud = header.layout;
  switch (header.data) {
    case PcdHeader::Data::ASCII:
      readTextRows (input, cloud, "points");
      break;
    case PcdHeader::Data::BINARY:
      allocatePoints (cloud);
      input.readBytes (cloud.data.data (), cloud.data.size (), "the points");
      break;
    case PcdHeader::Data::BINARY_COMPRESSED:
      readCompressed (input, cloud);
      break;
  }
  const bool padded = findField (cloud, "_") != nullptr;
  return padded ? packed (cloud) : std::move (cloud);
}

} // namespace pcl::manifold::apps
