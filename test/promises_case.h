#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

/** What the classes promise for every input; shared by the fuzz target and by the test of seeded inputs. */
namespace promises {

/** \brief A small cloud and what the classes are to be set to, all of it within the documented ranges. */
struct Case
{
  std::vector<Eigen::Vector3f> points;
  int thinning_neighbors = 0;
  double thinning_distance = 0.0;
  double rho = 0.3;
  bool watertight = false;
  double ratio = 0.8;
  int votes = 3;
  int neighbors = 15;
  int hops = 5;
  int threshold = 7;
  int rule = 0; ///< of adjacency
  int longest_face = 8;
  bool shortest_cycles = false;
  bool refine = true;
  bool triangulate = true;
  std::uint64_t seed = 1;
};

/** \brief Bytes one after the other; zeros after the last. */
class Bytes
{
public:
  Bytes (const std::uint8_t* data, std::size_t size) : data_ (data), size_ (size) {}

  bool atEnd () const { return size_ == 0; }

  std::uint8_t next ()
  {
    if (size_ == 0)
      return 0;
    --size_;
    return *data_++;
  }

  int below (int limit) { return next () % limit; }

  /** \brief One of 256 numbers from -1 to 1. */
  float unit () { return static_cast<float> (next ()) / 127.5f - 1.0f; }

  /** \brief Any number, NaN and infinity among them. */
  float any ()
  {
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i)
      bits = bits << 8U | next ();
    float number;
    std::memcpy (&number, &bits, sizeof number);
    return number;
  }

private:
  const std::uint8_t* data_;
  std::size_t size_;
};

/** \brief The next point of a family of clouds: any numbers, grids with duplicates, on a line, in a plane, on a
 * sphere (exactly, as far as floats go), on sheets and spheres with noise. */
inline Eigen::Vector3f
pointOf (int family, int number, Bytes& bytes)
{
  const auto small = [&bytes] (int limit) { return static_cast<float> (bytes.below (limit)); };
  switch (family) {
    case 0: {
      const float x = bytes.any (), y = bytes.any ();
      return {x, y, bytes.any ()};
    }
    case 1: {
      const int cell = bytes.next ();
      return {static_cast<float> (cell % 4), static_cast<float> (cell / 4 % 4),
              static_cast<float> (cell / 16 % 5)};
    }
    case 2:
      return Eigen::Vector3f (0.1f, 0.2f, 0.7f) * small (64);
    case 3: {
      const float x = small (12);
      return {x, small (12), 2.0f - x};
    }
    case 4: { // of norm 15, in integers
      static const int corners[4][3] = {{2, 10, 11}, {2, 5, 14}, {5, 10, 10}, {0, 9, 12}};
      const int which = bytes.next (), order = bytes.below (6);
      const int* corner = corners[which % 4];
      const int first = order % 3, second = (first + 1 + order / 3) % 3;
      Eigen::Vector3f point (static_cast<float> (corner[first]), static_cast<float> (corner[second]),
                             static_cast<float> (corner[3 - first - second]));
      for (int axis = 0; axis < 3; ++axis)
        if ((which >> (2 + axis)) % 2 == 1)
          point[axis] = -point[axis];
      return point;
    }
    case 5: {
      const float x = static_cast<float> (number % 12) + 0.1f * bytes.unit ();
      return {x, static_cast<float> (number / 12) + 0.1f * bytes.unit (), 0.2f * bytes.unit ()};
    }
    case 6: { // golden angle
      const float z = 1.0f - static_cast<float> (2 * (number % 100) + 1) / 100.0f;
      const float angle = 2.399963f * static_cast<float> (number % 100);
      const float radius = 1.0f + 0.05f * bytes.unit ();
      const float around = std::sqrt (1.0f - z * z);
      return Eigen::Vector3f (around * std::cos (angle), around * std::sin (angle), z) * radius;
    }
    default: {
      const float x = bytes.unit (), y = bytes.unit ();
      return {x, y, bytes.unit ()};
    }
  }
}

/** \brief A case for any bytes. */
inline Case
caseOf (const std::uint8_t* data, std::size_t size)
{
  constexpr std::size_t MOST_POINTS = 160;
  Bytes bytes (data, size);
  Case result;
  const int family = bytes.below (8);
  const int place = bytes.next ();
  const int switches = bytes.next ();
  result.watertight = switches % 2 == 1;
  result.shortest_cycles = (switches >> 1) % 2 == 1;
  result.refine = (switches >> 2) % 2 == 0;
  result.triangulate = (switches >> 3) % 2 == 0;
  result.rule = (switches >> 4) % 3;
  const int thinning = bytes.next ();
  result.thinning_neighbors = thinning % 4 == 1 ? 1 + thinning / 32 : 0;
  result.thinning_distance = thinning % 4 == 2 ? std::ldexp (1.0, thinning / 16 - 8) : 0.0;
  result.rho = 1.0 / (1 + bytes.below (8));
  result.ratio = 0.25 * (1 + bytes.below (6));
  result.votes = 1 + bytes.below (3);
  result.neighbors = 1 + bytes.below (20);
  result.hops = 1 + bytes.below (6);
  result.threshold = bytes.below (10);
  result.longest_face = 3 + bytes.below (8);
  result.seed = bytes.next ();
  while (!bytes.atEnd () && result.points.size () < MOST_POINTS)
    result.points.push_back (pointOf (family, static_cast<int> (result.points.size ()), bytes));
  // Far from the origin, huge, tiny: of three clouds one.
  if (place % 3 == 0)
    for (Eigen::Vector3f& point : result.points)
      point = (point * std::ldexp (1.0f, place / 3 * 3 - 126)).eval ();
  else if (place % 15 == 1)
    for (Eigen::Vector3f& point : result.points)
      point += Eigen::Vector3f (1e3f, -1e4f, static_cast<float> (place));
  return result;
}

} // namespace promises
