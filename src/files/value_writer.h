#pragma once

#include "files/output_file.h"
#include "files/scalar_type.h"

#include <charconv>
#include <string>
#include <string_view>

namespace pcl::manifold {

/** \brief How numbers are written. */
enum class Encoding
{
  TEXT, ///< the fewest digits that read back as the same bits
  BINARY_LITTLE,
  BINARY_BIG
};

/** \brief Writes text and numbers through a buffer of its own; finish () when done. */
class ValueWriter
{
public:
  ValueWriter (OutputFile& file, Encoding encoding) : file_ (file), encoding_ (encoding) {}

  void text (std::string_view text)
  {
    buffer_ += text;
    spill ();
  }

  template <typename Number>
  void value (Number number)
  {
    if (encoding_ == Encoding::TEXT) {
      char digits[32];
      const auto result = std::to_chars (digits, digits + sizeof (digits), number);
      if (!row_starts_)
        buffer_ += ' ';
      buffer_.append (digits, result.ptr);
      row_starts_ = false;
    } else {
      if (host_is_big_endian != (encoding_ == Encoding::BINARY_BIG))
        swapBytes (&number, sizeof (number), 1);
      buffer_.append (reinterpret_cast<const char*> (&number), sizeof (number));
    }
    spill ();
  }

  /** \brief Values that lie somewhere in memory, in this machine's byte order. */
  void values (ScalarType type, const std::uint8_t* data, std::size_t count)
  {
    withType (type, [&] (auto number) {
      for (std::size_t i = 0; i < count; ++i) {
        std::memcpy (&number, data + i * sizeof (number), sizeof (number));
        value (number);
      }
    });
  }

  /** \brief Ends a row of numbers; binary rows have no end. */
  void endRow ()
  {
    if (encoding_ == Encoding::TEXT)
      buffer_ += '\n';
    row_starts_ = true;
  }

  void finish ()
  {
    file_.write (buffer_);
    buffer_.clear ();
  }

private:
  void spill ()
  {
    if (buffer_.size () > (1u << 18))
      finish ();
  }

  OutputFile& file_;
  const Encoding encoding_;
  std::string buffer_;
  bool row_starts_ = true;
};

} // namespace pcl::manifold
