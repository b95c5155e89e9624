#pragma once

#include "files/number_text.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace pcl::manifold {

/** \brief Reads words, lines and bytes one after the other from the bytes of a file, never beyond their end.
 */
class Scanner
{
public:
  explicit Scanner (std::string_view bytes) : bytes_ (bytes) {}

  std::size_t position () const { return at_; }

  std::size_t remaining () const { return bytes_.size () - at_; }

  /** \brief Go on at another place; beyond the end is the end. */
  void seek (std::size_t position) { at_ = position < bytes_.size () ? position : bytes_.size (); }

  /** \brief The rest of the current line, without its end. Empty at the end of the file. */
  std::string_view line ();

  /** \brief The next word, on whatever line. Empty at the end of the file. */
  std::string_view word ();

  /** \brief The next word of the current line. Empty at the end of the line, which is not passed. A backslash
   * before the end of a line continues it. */
  std::string_view wordOnLine ();

  /** \brief The next word as a number. \throw FileError with the line if it is none */
  template <typename Number>
  Number number ()
  {
    const std::string_view text = word ();
    Number value{};
    if (!parseNumber (text, value))
      failAtWord (std::is_floating_point_v<Number> ? "a number" : "a whole number", text);
    return value;
  }

  /** \brief The words of the next line, empty for an empty one.
   * \return false at the end of the file */
  bool wordsOfLine (std::vector<std::string_view>& words);

  /** \brief Number of the line of the last word or line, counted from 1. */
  std::size_t lineNumber () const;

  /** \brief The next so many bytes. \throw FileError with the byte if there are fewer */
  std::string_view take (std::size_t size);

  /** \brief Give up. \throw FileError "line n: message", of the line of the last word or line */
  [[noreturn]] void failAtLine (const std::string& message) const;

  /** \brief Give up. \throw FileError "line n: expected ..., found ..." */
  [[noreturn]] void failAtWord (const std::string& expected, std::string_view found) const;

  /** \brief Give up. \throw FileError "byte n: message" */
  [[noreturn]] void failAtByte (const std::string& message) const;

private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t last_ = 0; ///< start of the last word or line, for messages
};

/** \brief A word of a file for a message: short, printable, in quotes. */
std::string quoted (std::string_view word);

} // namespace pcl::manifold
