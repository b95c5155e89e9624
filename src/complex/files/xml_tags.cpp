#include "complex/files/xml_tags.h"

#include "complex/files/file_error.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

std::string
unescapeXml (std::string_view text)
{
  constexpr std::pair<std::string_view, char> entities[] = {
    {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}};
  std::string plain;
  while (!text.empty ()) {
    const auto* const entity = std::find_if (std::begin (entities), std::end (entities), [&] (const auto& e) {
      return text.substr (0, e.first.size ()) == e.first;
    });
    const bool found = entity != std::end (entities);
    plain += found ? entity->second : text[0];
    text.remove_prefix (found ? entity->first.size () : 1);
  }
  return plain;
}

} // namespace

bool
XmlTags::next (XmlTag& tag)
{
  do {
    at_ = std::min (bytes_.find ('<', at_), bytes_.size ());
    last_ = at_;
  } while (skip ("<!--", "-->") || skip ("<?", "?>") || skip ("<!", ">"));
  if (at_ == bytes_.size ())
    return false;

  tag = XmlTag ();
  ++at_;
  tag.opens = at_ >= bytes_.size () || bytes_[at_] != '/';
  tag.closes = !tag.opens;
  if (tag.closes)
    ++at_;
  tag.name = readName ();
  for (skipBlanks (); at_ < bytes_.size () && bytes_[at_] != '>'; skipBlanks ()) {
    if (bytes_[at_] == '/') {
      tag.closes = true;
      ++at_;
    } else
      readAttribute (tag);
  }
  if (at_ == bytes_.size ())
    fail ("the tag has no end");
  ++at_;
  return true;
}

bool
XmlTags::skip (std::string_view open, std::string_view close)
{
  if (bytes_.substr (at_, open.size ()) != open)
    return false;
  const std::size_t end = bytes_.find (close, at_ + open.size ());
  at_ = end == std::string_view::npos ? bytes_.size () : end + close.size ();
  return true;
}

void
XmlTags::readAttribute (XmlTag& tag)
{
  const std::string_view name = readName ();
  skipBlanks ();
  if (at_ >= bytes_.size () || bytes_[at_] != '=')
    fail ("an attribute without a value");
  ++at_;
  skipBlanks ();
  const char quote = at_ < bytes_.size () ? bytes_[at_] : '\0';
  const std::size_t end =
    quote == '"' || quote == '\'' ? bytes_.find (quote, at_ + 1) : std::string_view::npos;
  if (end == std::string_view::npos)
    fail ("an attribute without a value in quotes");
  tag.attributes[std::string (name)] = unescapeXml (bytes_.substr (at_ + 1, end - at_ - 1));
  at_ = end + 1;
}

std::string_view
XmlTags::readName ()
{
  const std::size_t start = at_;
  while (at_ < bytes_.size () &&
         (std::isalnum (static_cast<unsigned char> (bytes_[at_])) != 0 || bytes_[at_] == '_' ||
          bytes_[at_] == '-' || bytes_[at_] == ':' || bytes_[at_] == '.'))
    ++at_;
  if (at_ == start)
    fail ("a tag that is not XML");
  return bytes_.substr (start, at_ - start);
}

void
XmlTags::skipBlanks ()
{
  while (at_ < bytes_.size () && std::isspace (static_cast<unsigned char> (bytes_[at_])) != 0)
    ++at_;
}

void
XmlTags::fail (const std::string& message) const
{
  const auto lines =
    std::count (bytes_.begin (), bytes_.begin () + static_cast<std::ptrdiff_t> (last_), '\n');
  throw FileError ("line " + std::to_string (lines + 1) + ": " + message);
}

} // namespace manifold
} // namespace pcl
