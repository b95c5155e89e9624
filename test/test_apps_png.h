#pragma once

#include <boost/crc.hpp>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>

inline std::uint32_t
bigEndian (const std::string& bytes, std::size_t at)
{
  std::uint32_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    value = value << 8 | static_cast<std::uint8_t> (bytes.at (i));
  return value;
}

/** \brief Walks through a PNG file and checks the sums of its chunks. */
inline void
expectPng (const std::string& png, std::uint32_t width, std::uint32_t height)
{
  ASSERT_GT (png.size (), 33u);
  EXPECT_EQ (png.substr (0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ (bigEndian (png, 16), width);
  EXPECT_EQ (bigEndian (png, 20), height);
  std::string type;
  std::size_t at = 8;
  while (type != "IEND" && at + 12 <= png.size ()) {
    const std::uint32_t size = bigEndian (png, at);
    type = png.substr (at + 4, 4);
    ASSERT_LE (at + 12 + size, png.size ());
    boost::crc_32_type sum;
    sum.process_bytes (&png[at + 4], size + 4);
    EXPECT_EQ (sum.checksum (), bigEndian (png, at + 8 + size)) << type;
    at += 12 + size;
  }
  EXPECT_EQ (type, "IEND");
  EXPECT_EQ (at, png.size ());
}
