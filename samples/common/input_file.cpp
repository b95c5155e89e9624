#include "input_file.h"

#include "app_error.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

namespace pcl::manifold::apps {

InputFile::InputFile (const std::string& file) : file_ (file)
{
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status (file, failure);
  if (!std::filesystem::exists (status))
    fail (failure ? failure.message () : "No such file");
  if (std::filesystem::is_directory (status))
    fail ("is a folder, not a file");
  if (!std::filesystem::is_regular_file (status))
    fail ("is not a regular file");
  size_ = std::filesystem::file_size (file, failure);
  if (failure)
    fail (failure.message ());
  errno = 0;
  stream_.open (file, std::ios::binary);
  if (!stream_)
    fail (errno != 0 ? std::generic_category ().message (errno) : "cannot be opened");
  if (size_ == 0)
    fail ("the file is empty");
}

bool
InputFile::readLine (std::string& line)
{
  if (!std::getline (stream_, line)) {
    if (stream_.bad ())
      fail ("reading failed after byte " + std::to_string (offset_));
    return false;
  }
  // The last line may lack its line end.
  offset_ = std::min (size_, offset_ + line.size () + (stream_.eof () ? 0 : 1));
  ++line_number_;
  if (!line.empty () && line.back () == '\r')
    line.pop_back ();
  return true;
}

void
InputFile::readBytes (void* to, std::uint64_t count, const std::string& what)
{
  const std::uint64_t before = offset_;
  stream_.read (static_cast<char*> (to), static_cast<std::streamsize> (count));
  const auto got = static_cast<std::uint64_t> (stream_.gcount ());
  offset_ = std::min (size_, offset_ + got);
  if (got != count)
    fail ("the file ends at byte " + std::to_string (offset_) + ", but " + what + " from byte " +
          std::to_string (before) + " needs " + std::to_string (count) + " bytes");
}

void
InputFile::fail (const std::string& what) const
{
  throw AppError (file_, what);
}

void
InputFile::failAtLine (const std::string& what) const
{
  throw AppError (file_, "line " + std::to_string (line_number_) + ": " + what);
}

std::string
quoted (const std::string& text)
{
  constexpr std::size_t longest = 40;
  std::string result = "'" + text.substr (0, longest);
  std::replace_if (
    result.begin (), result.end (), [] (char c) { return c < ' ' || c > '~'; }, '?');
  return result + (text.size () > longest ? "...'" : "'");
}

} // namespace pcl::manifold::apps
