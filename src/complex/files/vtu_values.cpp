#include "complex/files/vtu_values.h"

#include "complex/files/file_error.h"
#include "complex/files/scanner.h"

#include <algorithm>
#include <cctype>
#include <limits>

#include <zlib.h>

namespace pcl {
namespace manifold {

namespace {

/** \brief Hands out bytes that are raw, or decodes them from base64. Each of VTK's pieces, such as a length,
 * may be encoded and padded on its own, so that padding is no end. */
class ByteSource
{
public:
  ByteSource (std::string_view bytes, bool base64) : bytes_ (bytes), base64_ (base64) {}

  /** \brief No more bytes than this are left. */
  std::size_t limit () const
  {
    return base64_ ? (bytes_.size () - at_) / 4 * 3 + pending_.size () : bytes_.size () - at_;
  }

  void read (std::uint8_t* out, std::size_t size)
  {
    if (size > limit ())
      throw FileError ("the file ends too early");
    if (!base64_) {
      std::copy_n (bytes_.begin () + static_cast<std::ptrdiff_t> (at_), size, out);
      at_ += size;
      return;
    }
    for (std::size_t i = 0; i < size; ++i) {
      if (pending_.empty ())
        decodeFour ();
      out[i] = pending_.back ();
      pending_.pop_back ();
    }
  }

private:
  static int valueOf (char c)
  {
    if (c >= 'A' && c <= 'Z')
      return c - 'A';
    if (c >= 'a' && c <= 'z')
      return c - 'a' + 26;
    if (c >= '0' && c <= '9')
      return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
  }

  /** \brief Decodes four characters to one, two or three pending bytes, the next one last. */
  void decodeFour ()
  {
    std::uint32_t bits = 0;
    int characters = 0, padding = 0;
    for (; characters < 4 && at_ < bytes_.size (); ++at_) {
      const char c = bytes_[at_];
      if (std::isspace (static_cast<unsigned char> (c)) != 0)
        continue;
      const int value = valueOf (c);
      if (c == '=' && characters >= 2)
        ++padding;
      else if (value < 0 || padding > 0)
        throw FileError ("an array that is not base64");
      bits = bits << 6 | static_cast<std::uint32_t> (c == '=' ? 0 : value);
      ++characters;
    }
    if (characters < 4)
      throw FileError ("the file ends too early");
    for (int byte = padding; byte < 3; ++byte)
      pending_.push_back (static_cast<std::uint8_t> (bits >> 8 * byte));
  }

  std::string_view bytes_;
  const bool base64_;
  std::size_t at_ = 0;
  std::vector<std::uint8_t> pending_;
};

std::uint64_t
readLength (ByteSource& source, const VtuEncoding& encoding)
{
  std::uint8_t bytes[8];
  const std::size_t size = encoding.wide_header ? 8 : 4;
  source.read (bytes, size);
  std::uint64_t length = 0;
  for (std::size_t i = 0; i < size; ++i)
    length = length << 8 | bytes[encoding.big_endian ? i : size - 1 - i];
  return length;
}

std::vector<std::uint8_t>
readPlain (ByteSource& source, const VtuEncoding& encoding)
{
  const std::uint64_t length = readLength (source, encoding);
  if (length > source.limit ())
    throw FileError ("an array of " + std::to_string (length) + " bytes, more than the file has");
  std::vector<std::uint8_t> data (length);
  source.read (data.data (), data.size ());
  return data;
}

/** \brief Number of blocks, size of a block, size of the last one (0: as the others), compressed sizes,
 * blocks. */
std::vector<std::uint8_t>
readCompressed (ByteSource& source, const VtuEncoding& encoding)
{
  constexpr std::uint64_t most_ratio = 1032; // zlib cannot do better
  const std::uint64_t blocks = readLength (source, encoding);
  const std::uint64_t block_size = readLength (source, encoding);
  const std::uint64_t last_size = readLength (source, encoding);
  const auto fail = [] { throw FileError ("an array with wrong sizes of compressed blocks"); };
  const std::uint64_t most = source.limit () > std::numeric_limits<std::uint64_t>::max () / most_ratio
                               ? std::numeric_limits<std::uint64_t>::max ()
                               : source.limit () * most_ratio;
  if (blocks > source.limit () || block_size > most || last_size > block_size ||
      (blocks > 0 && block_size > most / blocks))
    fail ();
  std::vector<std::uint64_t> sizes (blocks);
  for (std::uint64_t& size : sizes) {
    size = readLength (source, encoding);
    if (size > source.limit ())
      fail ();
  }
  std::vector<std::uint8_t> data, compressed;
  for (std::size_t i = 0; i < sizes.size (); ++i) {
    compressed.resize (sizes[i]);
    source.read (compressed.data (), compressed.size ());
    const std::size_t begin = data.size ();
    const bool is_short = i + 1 == sizes.size () && last_size > 0;
    data.resize (begin + (is_short ? last_size : block_size));
    auto size = static_cast<uLongf> (data.size () - begin);
    if (uncompress (data.data () + begin, &size, compressed.data (),
                    static_cast<uLong> (compressed.size ())) != Z_OK ||
        size != data.size () - begin)
      throw FileError ("an array that zlib cannot uncompress");
  }
  return data;
}

} // namespace

std::vector<std::uint8_t>
readVtuBinary (std::string_view bytes, bool base64, ScalarType type, const VtuEncoding& encoding)
{
  ByteSource source (bytes, base64);
  std::vector<std::uint8_t> data =
    encoding.zlib ? readCompressed (source, encoding) : readPlain (source, encoding);
  if (data.size () % sizeOf (type) != 0)
    throw FileError ("an array that ends within a number");
  if (encoding.big_endian != host_is_big_endian)
    swapBytes (data.data (), sizeOf (type), data.size () / sizeOf (type));
  return data;
}

std::vector<std::uint8_t>
readVtuText (std::string_view text, ScalarType type)
{
  std::vector<std::uint8_t> data;
  Scanner scanner (text);
  withType (type, [&] (auto value) {
    for (std::string_view word = scanner.word (); !word.empty (); word = scanner.word ()) {
      if (!parseNumber (word, value))
        throw FileError ("expected a number, found " + quoted (word));
      const auto* const bytes = reinterpret_cast<const std::uint8_t*> (&value);
      data.insert (data.end (), bytes, bytes + sizeof (value));
    }
  });
  return data;
}

} // namespace manifold
} // namespace pcl
