// Every promise of every class, on seeded bytes: the clouds are those of test/fuzz/fuzz_classes.cpp.
#include "promises.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr int FAMILIES = 8;
constexpr std::size_t OPTION_BYTES = 13;

class Promises : public testing::TestWithParam<int>
{};

TEST_P (Promises, AreKept)
{
  constexpr std::uint64_t CLOUDS = 300;
  for (std::uint64_t seed = 1; seed <= CLOUDS; ++seed) {
    std::mt19937_64 random (seed * FAMILIES + static_cast<std::uint64_t> (GetParam ()));
    // From nothing to about a hundred and fifty points, few more often than many.
    std::vector<std::uint8_t> bytes (OPTION_BYTES + random () % (1 + random () % 450));
    for (std::uint8_t& byte : bytes)
      byte = static_cast<std::uint8_t> (random ());
    bytes[0] = static_cast<std::uint8_t> (GetParam ());
    ASSERT_EQ (promises::broken (promises::caseOf (bytes.data (), bytes.size ())), "") << "seed " << seed;
  }
}

// The checks themselves: what they have to notice.
TEST (PromisesOfAComplex, AreChecked)
{
  promises::Case input;
  for (int i = 0; i < 5; ++i)
    input.points.emplace_back (static_cast<float> (i % 2), static_cast<float> (i / 2),
                               static_cast<float> (i * i));
  input.points.emplace_back (std::numeric_limits<float>::quiet_NaN (), 0.0f, 0.0f);
  const auto broken = [&input] (const pcl::SimplicialComplex& complex) {
    return promises::brokenByComplex (input, complex);
  };
  EXPECT_EQ (broken ({{{3, 4}}, {{0, 1, 2}, {2, 1, 3}}, {}}), "");
  EXPECT_NE (broken ({{{0, 6}}, {}, {}}), "");
  EXPECT_NE (broken ({{{0, 5}}, {}, {}}), "");
  EXPECT_NE (broken ({{{0, 1}, {0, 2}, {0, 3}}, {}, {}}), "");
  EXPECT_NE (broken ({{}, {{0, 1, 2}, {1, 2, 3}}, {}}), "");
  EXPECT_NE (broken ({{}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, {}}), "");
  EXPECT_NE (broken ({{}, {{0, 1, 2}, {0, 3, 4}}, {}}), "");
  EXPECT_NE (broken ({{}, {}, {{0, 1, 2, 3}, {0, 1, 2, 4}}}), "");
}

INSTANTIATE_TEST_SUITE_P (Families, Promises, testing::Range (0, FAMILIES));

} // namespace
