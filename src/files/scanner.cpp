#include "files/scanner.h"

#include "files/file_error.h"

#include <algorithm>

namespace pcl::manifold {
namespace {

bool
isBlank (char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

} // namespace

std::string_view
Scanner::line ()
{
  last_ = at_;
  const std::size_t end = std::min (bytes_.find ('\n', at_), bytes_.size ());
  std::string_view text = bytes_.substr (at_, end - at_);
  at_ = std::min (end + 1, bytes_.size ());
  if (!text.empty () && text.back () == '\r')
    text.remove_suffix (1);
  return text;
}

std::string_view
Scanner::word ()
{
  while (at_ < bytes_.size () && (isBlank (bytes_[at_]) || bytes_[at_] == '\n'))
    ++at_;
  last_ = at_;
  while (at_ < bytes_.size () && !isBlank (bytes_[at_]) && bytes_[at_] != '\n')
    ++at_;
  return bytes_.substr (last_, at_ - last_);
}

std::string_view
Scanner::wordOnLine ()
{
  for (; at_ < bytes_.size (); ++at_) {
    if (bytes_[at_] == '\\') {
      const std::string_view next = bytes_.substr (at_ + 1, 2);
      if (next != "\r\n" && next.substr (0, 1) != "\n")
        break;
      at_ += next[0] == '\r' ? 2 : 1;
    } else if (!isBlank (bytes_[at_]))
      break;
  }
  last_ = at_;
  while (at_ < bytes_.size () && !isBlank (bytes_[at_]) && bytes_[at_] != '\n')
    ++at_;
  return bytes_.substr (last_, at_ - last_);
}

std::string_view
Scanner::take (std::size_t size)
{
  if (size > remaining ())
    failAtByte ("the file ends too early");
  const std::string_view taken = bytes_.substr (at_, size);
  at_ += size;
  return taken;
}

bool
Scanner::wordsOfLine (std::vector<std::string_view>& words)
{
  words.clear ();
  if (remaining () == 0)
    return false;
  const std::size_t start = at_;
  Scanner rest (line ());
  for (std::string_view next = rest.word (); !next.empty (); next = rest.word ())
    words.push_back (next);
  last_ = start;
  return true;
}

std::size_t
Scanner::lineNumber () const
{
  const auto end = bytes_.begin () + static_cast<std::ptrdiff_t> (last_);
  return static_cast<std::size_t> (std::count (bytes_.begin (), end, '\n')) + 1;
}

void
Scanner::failAtLine (const std::string& message) const
{
  throw FileError ("line " + std::to_string (lineNumber ()) + ": " + message);
}

void
Scanner::failAtWord (const std::string& expected, std::string_view found) const
{
  failAtLine (found.empty ()
                ? "expected " + expected + ", but the " + (at_ < bytes_.size () ? "line" : "file") + " ends"
                : "expected " + expected + ", found " + quoted (found));
}

void
Scanner::failAtByte (const std::string& message) const
{
  throw FileError ("byte " + std::to_string (at_) + ": " + message);
}

std::string
quoted (std::string_view word)
{
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : word.substr (0, longest))
    text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size () > longest ? "...'" : "'");
}

} // namespace pcl::manifold
