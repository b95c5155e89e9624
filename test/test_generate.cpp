// The synthetic clouds that the other tests build on: do the points keep what the shapes promise?
#include <generate/catalogue.h>
#include <generate/closed_surfaces.h>
#include <generate/curves.h>
#include <generate/implicit.h>
#include <generate/labelled_cloud.h>
#include <generate/marching.h>
#include <generate/open_surfaces.h>
#include <generate/point_grid.h>
#include <generate/random.h>
#include <generate/sampling.h>
#include <generate/scenes.h>
#include <generate/solids.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace generate;

constexpr double PI = 3.14159265358979323846;

void
expectSameBytes (const LabelledCloud& a, const LabelledCloud& b)
{
  ASSERT_EQ (a.size (), b.size ());
  EXPECT_EQ (a.points, b.points);
  EXPECT_EQ (a.labels, b.labels);
  EXPECT_EQ (a.depth, b.depth);
  EXPECT_EQ (a.boundary, b.boundary);
  EXPECT_EQ (a.object, b.object);
}

double
smallestDistance (const std::vector<Eigen::Vector3d>& points)
{
  double smallest = 1e300;
  for (std::size_t i = 0; i < points.size (); ++i)
    for (std::size_t j = i + 1; j < points.size (); ++j)
      smallest = std::min (smallest, (points[i] - points[j]).squaredNorm ());
  return std::sqrt (smallest);
}

/** The spacing that makes a few hundred points of a shape. */
double
testSpacing (const Shape& shape)
{
  return spacingFor (shape, 600);
}

class EveryShape : public testing::TestWithParam<std::string>
{
protected:
  /** Made once for all tests: those of higher genus take a moment. */
  static const Shape& cached (const std::string& name)
  {
    static std::map<std::string, Shape> shapes;
    const auto found = shapes.find (name);
    return found != shapes.end () ? found->second : shapes.emplace (name, shapeByName (name)).first->second;
  }

  const Shape& shape = cached (GetParam ());
};

TEST_P (EveryShape, BlueNoiseKeepsItsSpacingAndLeavesNoGap)
{
  const double spacing = testSpacing (shape);
  const LabelledCloud cloud = blueNoise (shape, spacing, 7);
  EXPECT_GE (smallestDistance (cloud.points), spacing);
  EXPECT_GT (cloud.size (), 300U);
  EXPECT_LT (cloud.size (), 900U);

  PointGrid grid (spacing);
  for (const Eigen::Vector3d& point : cloud.points)
    grid.insert (point);
  const UniformDraw draw (shape);
  Random random (8);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d probe = draw (random);
    ASSERT_TRUE (grid.anyWithin (probe, 1.001 * spacing)) << probe.transpose ();
  }
}

TEST_P (EveryShape, PointsLieOnTheShapeAndAreLabelled)
{
  for (const LabelledCloud& cloud : {blueNoise (shape, testSpacing (shape), 3), uniform (shape, 500, 3)}) {
    bool any_boundary = false;
    for (std::size_t i = 0; i < cloud.size (); ++i) {
      ASSERT_LT (shape.nearest (cloud.points[i]).distance, 1e-6);
      ASSERT_EQ (cloud.labels[i], static_cast<std::uint32_t> (shape.dimension));
      ASSERT_NEAR (cloud.depth[i], shape.depth (cloud.points[i]), 1e-6);
      ASSERT_TRUE (shape.dimension == 3 || cloud.depth[i] == 0.0);
      any_boundary = any_boundary || cloud.boundary[i];
    }
    EXPECT_EQ (any_boundary, shape.topology.boundary_components > 0);
  }
}

TEST_P (EveryShape, SameSeedSamePoints)
{
  const double spacing = testSpacing (shape);
  expectSameBytes (blueNoise (shape, spacing, 11), blueNoise (shape, spacing, 11));
  expectSameBytes (uniform (shape, 300, 11), uniform (shape, 300, 11));
  EXPECT_NE (blueNoise (shape, spacing, 11, Strata::IGNORED).points,
             blueNoise (shape, spacing, 12, Strata::IGNORED).points);
  EXPECT_NE (uniform (shape, 300, 11).points, uniform (shape, 300, 12).points);
}

TEST_P (EveryShape, UniformGivesTheCountThatWasAsked)
{
  for (const std::size_t count : {0U, 1U, 17U, 400U})
    EXPECT_EQ (uniform (shape, count, 5).size (), count);
}

TEST_P (EveryShape, NearestPointOfAPlaceBesideIsTheFoot)
{
  if (shape.dimension != 2)
    return;
  const LabelledCloud cloud = uniform (shape, 200, 9, Strata::IGNORED);
  for (const Eigen::Vector3d& point : cloud.points) {
    const Eigen::Vector3d normal = shape.nearest (point).normal;
    EXPECT_NEAR (normal.norm (), 1.0, 1e-12);
    const Nearest found = shape.nearest (point + 0.05 * normal);
    EXPECT_NEAR (found.distance, 0.05, 1e-6);
    EXPECT_LT ((found.point - point).norm (), 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P (Generate, EveryShape, testing::ValuesIn (shapeNames ()),
                          [] (const testing::TestParamInfo<std::string>& shape_info) {
                            std::string name = shape_info.param;
                            name.erase (std::remove (name.begin (), name.end (), '-'), name.end ());
                            return name;
                          });

TEST (Generate, MeasuresAreThoseOfTheTextbook)
{
  EXPECT_NEAR (sphere (2.0).measure (), 16.0 * PI, 1e-7);
  EXPECT_NEAR (torus (1.0, 0.4).measure (), 4.0 * PI * PI * 0.4, 1e-9);
  EXPECT_NEAR (knottedTube (1.0, 0.2).measure (), trefoil (1.0).measure () * 2.0 * PI * 0.2, 1e-6);
  EXPECT_NEAR (hemisphere ().measure (), 2.0 * PI, 1e-7);
  EXPECT_NEAR (annulus (0.5, 1.0).measure (), 0.75 * PI, 1e-9);
  EXPECT_NEAR (ball (0.5).measure (), PI / 6.0, 1e-6);
  EXPECT_NEAR (solidTorus (1.0, 0.4).measure (), 2.0 * PI * PI * 0.16, 1e-6);
  EXPECT_NEAR (circle (3.0).measure (), 6.0 * PI, 1e-9);
}

/** Euler characteristic of the triangles that an implicit surface is made of, by its shared corners. */
int
eulerCharacteristic (const std::vector<MarchedTriangle>& triangles)
{
  using Key = std::array<double, 3>;
  std::map<Key, int> corners;
  std::map<std::pair<int, int>, int> edges;
  for (const MarchedTriangle& triangle : triangles) {
    std::array<int, 3> ids;
    for (std::size_t i = 0; i < 3; ++i)
      ids[i] = corners.emplace (Key{triangle[i].x (), triangle[i].y (), triangle[i].z ()}, corners.size ())
                 .first->second;
    for (std::size_t i = 0; i < 3; ++i)
      ++edges[std::minmax (ids[i], ids[(i + 1) % 3])];
  }
  for (const auto& edge : edges)
    EXPECT_EQ (edge.second, 2);
  return static_cast<int> (corners.size ()) - static_cast<int> (edges.size ()) +
         static_cast<int> (triangles.size ());
}

TEST (Generate, ChainedToriHaveTheirGenus)
{
  for (const int handles : {1, 2, 3}) {
    const Field field = chainedToriField (handles);
    const Eigen::Vector3d corner (1.2 * handles + 0.7, 1.7, 0.8);
    const auto triangles = marchTetrahedra ([&field] (const Eigen::Vector3d& p) { return field (p).value; },
                                            {-corner, corner}, 24 * handles);
    EXPECT_EQ (eulerCharacteristic (triangles), chainedTori (handles).topology.euler);
  }
}

TEST (Generate, EllipsoidDistanceIsTheSmallest)
{
  const Eigen::Vector3d axes (1.0, 0.75, 0.5);
  const Shape shape = ellipsoid (axes);
  const std::vector<Eigen::Vector3d> dense = uniform (shape, 20000, 1).points;
  Random random (2);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d place = 2.0 * random.cube () - Eigen::Vector3d::Ones ();
    const Nearest found = shape.nearest (place);
    EXPECT_NEAR (found.point.cwiseQuotient (axes).norm (), 1.0, 1e-12);
    for (const Eigen::Vector3d& point : dense)
      ASSERT_LE (found.distance, (point - place).norm () + 1e-12);
  }
  EXPECT_NEAR (shape.nearest (Eigen::Vector3d::Zero ()).distance, 0.5, 1e-9);
}

TEST (Generate, UniformIsUniform)
{
  // The part of a sphere above z has an area proportional to 1 - z, that of an annulus to the square.
  const std::size_t count = 40000;
  std::size_t above = 0, inside = 0, in_ball = 0;
  for (const Eigen::Vector3d& point : uniform (sphere (), count, 4).points)
    above += point.z () > 0.5;
  for (const Eigen::Vector3d& point : uniform (annulus (0.5, 1.0), count, 4, Strata::IGNORED).points)
    inside += point.norm () < 0.75;
  for (const Eigen::Vector3d& point : uniform (ball (), count, 4, Strata::IGNORED).points)
    in_ball += point.norm () < 0.5;
  EXPECT_NEAR (static_cast<double> (above) / count, 0.25, 0.01);
  EXPECT_NEAR (static_cast<double> (inside) / count, (0.5625 - 0.25) / 0.75, 0.01);
  EXPECT_NEAR (static_cast<double> (in_ball) / count, 0.125, 0.01);
}

TEST (Generate, EpsilonSampleHasAPointWithinEpsOfEveryPlace)
{
  const Shape shape = torus (1.0, 0.4);
  const LabelledCloud cloud = epsilonSample (shape, 0.3, 5);
  PointGrid grid (0.12);
  for (const Eigen::Vector3d& point : cloud.points)
    grid.insert (point);
  const UniformDraw draw (shape);
  Random random (6);
  for (int i = 0; i < 20000; ++i)
    ASSERT_TRUE (grid.anyWithin (draw (random), 0.3 * 0.4));
}

TEST (Generate, AdaptiveSampleIsAsDenseAsTheFeatureSizeAsks)
{
  const Eigen::Vector3d axes (1.0, 0.75, 0.5);
  const Shape shape = ellipsoid (axes);
  const auto size = [&axes] (const Eigen::Vector3d& place) { return ellipsoidFeatureSize (axes, place); };
  const LabelledCloud cloud = adaptiveSample (shape, size, 0.3, 5);
  expectSameBytes (cloud, adaptiveSample (shape, size, 0.3, 5));
  PointGrid grid (0.15);
  for (const Eigen::Vector3d& point : cloud.points) {
    EXPECT_LT (shape.nearest (point).distance, 1e-9);
    EXPECT_FALSE (grid.anyWithin (point, 0.9 * 0.3 * size (point))) << "more points than it takes";
    grid.insert (point);
  }
  const UniformDraw draw (shape);
  Random random (6);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d place = draw (random);
    ASSERT_TRUE (grid.anyWithin (place, 0.3 * size (place)));
  }
}

TEST (Generate, FeatureSizesAreDistancesToTheMedialAxis)
{
  const Eigen::Vector3d axes (1.0, 0.75, 0.5);
  // Where the sharpest bends are, and above the middle.
  EXPECT_NEAR (ellipsoidFeatureSize (axes, {1.0, 0.0, 0.0}), 0.25, 1e-12);
  EXPECT_NEAR (ellipsoidFeatureSize (axes, {0.0, -0.75, 0.0}), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR (ellipsoidFeatureSize (axes, {0.0, 0.0, 0.5}), 0.5, 1e-12);
  EXPECT_NEAR (torusFeatureSize (0.7, {0.3, 0.0, 0.0}), 0.3, 1e-12);
  EXPECT_NEAR (torusFeatureSize (0.7, {0.0, 1.7, 0.0}), 0.7, 1e-12);
  // Balls of that radius that touch the surface from either side are free of it.
  Random random (1);
  const auto expectFree = [&random] (const Shape& shape, const auto& size) {
    const UniformDraw draw (shape);
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d place = draw (random);
      const double radius = size (place);
      EXPECT_GE (radius, shape.feature_size - 1e-12);
      const Eigen::Vector3d normal = shape.nearest (place).normal;
      EXPECT_NEAR (shape.nearest (place + radius * normal).distance, radius, 1e-9);
      EXPECT_NEAR (shape.nearest (place - radius * normal).distance, radius, 1e-9);
    }
  };
  expectFree (ellipsoid (axes),
              [&axes] (const Eigen::Vector3d& place) { return ellipsoidFeatureSize (axes, place); });
  expectFree (torus (1.0, 0.7), [] (const Eigen::Vector3d& place) { return torusFeatureSize (0.7, place); });
}

TEST (Generate, MixedSceneIsFourShapesApart)
{
  for (const LabelledCloud& cloud : {mixedScene (0.12, 1), mixedSceneRandom (1500, 1)}) {
    const std::vector<std::uint32_t> labels = {2, 2, 1, 3};
    std::array<std::vector<Eigen::Vector3d>, 4> objects;
    for (std::size_t i = 0; i < cloud.size (); ++i) {
      ASSERT_LT (cloud.object[i], 4U);
      EXPECT_EQ (cloud.labels[i], labels[cloud.object[i]]);
      objects[cloud.object[i]].push_back (cloud.points[i]);
    }
    for (std::size_t a = 0; a < 4; ++a) {
      EXPECT_GT (objects[a].size (), 80U);
      for (std::size_t b = a + 1; b < 4; ++b)
        for (const Eigen::Vector3d& p : objects[a])
          for (const Eigen::Vector3d& q : objects[b])
            ASSERT_GE ((p - q).norm (), 1.0);
    }
  }
  expectSameBytes (mixedScene (0.12, 1), mixedScene (0.12, 1));
  const std::vector<std::uint32_t> objects = mixedSceneRandom (1500, 1).object;
  EXPECT_EQ (std::count (objects.begin (), objects.end (), 0U), 1500);
}

TEST (Generate, NoiseHasItsDeviation)
{
  LabelledCloud cloud = uniform (sphere (), 20000, 1);
  const LabelledCloud before = cloud;
  addNoise (cloud, 0.05, 2);
  double sum = 0.0;
  for (std::size_t i = 0; i < cloud.size (); ++i)
    sum += (cloud.points[i] - before.points[i]).squaredNorm ();
  EXPECT_NEAR (std::sqrt (sum / (3.0 * static_cast<double> (cloud.size ()))), 0.05, 0.001);
  LabelledCloud again = before;
  addNoise (again, 0.05, 2);
  expectSameBytes (cloud, again);
}

TEST (Generate, MovedShapeMovesEverything)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity ();
  motion.rotate (Eigen::AngleAxisd (1.0, Eigen::Vector3d (1.0, 2.0, 3.0).normalized ()));
  motion.pretranslate (Eigen::Vector3d (10.0, -4.0, 2.0));
  const Shape shape = hemisphere (), there = moved (shape, motion);
  const LabelledCloud a = blueNoise (shape, 0.2, 3), b = blueNoise (there, 0.2, 3);
  ASSERT_EQ (a.size (), b.size ());
  for (std::size_t i = 0; i < a.size (); ++i) {
    EXPECT_LT ((motion * a.points[i] - b.points[i]).norm (), 1e-12);
    EXPECT_LT (there.nearest (b.points[i]).distance, 1e-9);
  }
}

TEST (Generate, BadArgumentsAreRefused)
{
  const Shape shape = sphere ();
  EXPECT_THROW (blueNoise (shape, 0.0, 1), std::invalid_argument);
  EXPECT_THROW (blueNoise (shape, -1.0, 1), std::invalid_argument);
  EXPECT_THROW (blueNoise (shape, std::nan (""), 1), std::invalid_argument);
  EXPECT_THROW (blueNoise (shape, 1e-9, 1), std::invalid_argument);
  EXPECT_THROW (epsilonSample (shape, 0.0, 1), std::invalid_argument);
  EXPECT_THROW (epsilonSample (terrain (), 0.1, 1), std::invalid_argument);
  EXPECT_THROW (epsilonSample (segment (), 0.1, 1), std::invalid_argument);
  for (const double eps : {0.0, -0.1, 1.0, std::nan ("")})
    EXPECT_THROW (adaptiveSample (
                    shape, [] (const Eigen::Vector3d&) { return 1.0; }, eps, 1),
                  std::invalid_argument);
  EXPECT_THROW (shapeByName ("dodo"), std::invalid_argument);
  LabelledCloud cloud;
  EXPECT_THROW (addNoise (cloud, -1.0, 1), std::invalid_argument);
  EXPECT_TRUE (uniform (shape, 0, 1).points.empty ());
  EXPECT_EQ (blueNoise (shape, 100.0, 1).size (), 1U);
}

} // namespace
