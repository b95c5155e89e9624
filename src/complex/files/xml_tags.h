#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace pcl {
namespace manifold {

/** \brief One tag of an XML file. */
struct XmlTag
{
  std::string name;
  bool opens = false;  ///< <name ...> or <name ... />
  bool closes = false; ///< </name> or <name ... />
  std::map<std::string, std::string> attributes;

  /** \brief An attribute's value, empty if it is missing. */
  std::string operator[] (const std::string& attribute) const
  {
    const auto found = attributes.find (attribute);
    return found == attributes.end () ? std::string () : found->second;
  }
};

/** \brief Goes through the tags of an XML file from the first to the last, over comments and instructions. */
class XmlTags
{
public:
  explicit XmlTags (std::string_view bytes) : bytes_ (bytes) {}

  /** \brief Finds the next tag.
   * \return false at the end of the file
   * \throw FileError with the line for a tag that is none */
  bool next (XmlTag& tag);

  /** \brief The text between the last tag and the one behind it. */
  std::string_view text () const { return bytes_.substr (at_, bytes_.find ('<', at_) - at_); }

  /** \brief Where the last tag ends. */
  std::size_t position () const { return at_; }

  /** \throw FileError with the line of the last tag */
  [[noreturn]] void fail (const std::string& message) const;

private:
  /** \brief Passes what begins with \a open, if it is next. */
  bool skip (std::string_view open, std::string_view close);

  void readAttribute (XmlTag& tag);

  std::string_view readName ();

  void skipBlanks ();

  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t last_ = 0; ///< start of the last tag
};

} // namespace manifold
} // namespace pcl
