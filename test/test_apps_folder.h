#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

/** \brief A folder of its own for a test, removed at the end. */
class TestFolder
{
public:
  TestFolder ()
  {
    std::string name = (std::filesystem::temp_directory_path () / "apps_XXXXXX").string ();
    EXPECT_NE (mkdtemp (name.data ()), nullptr);
    path_ = name;
  }

  TestFolder (const TestFolder&) = delete;
  TestFolder& operator= (const TestFolder&) = delete;

  ~TestFolder ()
  {
    std::error_code ignored;
    std::filesystem::remove_all (path_, ignored);
  }

  /** \brief The path of a file in the folder. */
  std::string operator/ (const std::string& name) const { return (path_ / name).string (); }

  /** \brief Writes a file.
   * \return its path */
  std::string write (const std::string& name, const std::string& content) const
  {
    std::ofstream (*this / name, std::ios::binary) << content;
    return *this / name;
  }

  std::string read (const std::string& name) const
  {
    std::ifstream stream (*this / name, std::ios::binary);
    return {std::istreambuf_iterator<char> (stream), std::istreambuf_iterator<char> ()};
  }

  /** \brief Number of files in the folder. */
  std::ptrdiff_t count () const
  {
    return std::distance (std::filesystem::directory_iterator (path_),
                          std::filesystem::directory_iterator ());
  }

private:
  std::filesystem::path path_;
};

/** \brief The text of the exception that a call throws; empty if it throws none. */
template <typename Exception, typename Call>
std::string
messageOf (const Call& call)
{
  try {
    call ();
  } catch (const Exception& error) {
    return error.what ();
  }
  return {};
}

inline bool
contains (const std::string& text, const std::string& part)
{
  return text.find (part) != std::string::npos;
}
