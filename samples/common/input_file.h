#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>

namespace pcl::manifold::apps {

/** \brief A regular file opened for reading, by lines or by bytes, that knows where it is, for messages that
 * say so. */
class InputFile
{
public:
  /** \throws AppError if there is no such file, it is no regular file, cannot be opened or is empty */
  explicit InputFile (const std::string& file);

  /** \brief Reads the next line, without its line end (`\n` or `\r\n`).
   * \return false at the end of the file
   * \throws AppError if reading fails */
  bool readLine (std::string& line);

  /** \brief Reads exactly `count` bytes.
   * \throws AppError if fewer are left; it says how many, and `what` they were to be */
  void readBytes (void* to, std::uint64_t count, const std::string& what);

  /** \brief Number of the line that was read last, counted from 1. */
  std::uint64_t lineNumber () const { return line_number_; }

  /** \brief Bytes read so far. */
  std::uint64_t offset () const { return offset_; }

  /** \brief Bytes left to read. */
  std::uint64_t remaining () const { return size_ - offset_; }

  const std::string& name () const { return file_; }

  /** \brief Throws an AppError about this file. */
  [[noreturn]] void fail (const std::string& what) const;

  /** \brief Throws an AppError about the line that was read last. */
  [[noreturn]] void failAtLine (const std::string& what) const;

private:
  std::string file_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  std::uint64_t offset_ = 0;
  std::uint64_t line_number_ = 0;
};

/** \brief A part of the file's text, fit for a message: short, and with nothing that would disturb a
 * terminal. */
std::string quoted (const std::string& text);

} // namespace pcl::manifold::apps
