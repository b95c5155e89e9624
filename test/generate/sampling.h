#pragma once

#include <generate/labelled_cloud.h>
#include <generate/shape.h>

#include <cstddef>
#include <cstdint>
#include <functional>

namespace generate {

/** Samples of shapes. The same arguments give the same points. Labels are the dimension of the shape, also
 * on its rim or skin. Points come stratum by stratum: corners, rim or skin, then the inside. */

/** \brief Whether strata (rims, ends, skins) get points of their own. */
enum class Strata
{
  SAMPLED,
  IGNORED
};

/** \brief A maximal Poisson-disk sample: no two points are nearer than \a spacing, and no place of the shape
 * (or of one of its strata) is further than 1.001 times \a spacing from a point, in Euclidean distance.
 * \param[in] spacing positive; std::invalid_argument otherwise, or if it gives more than 2 * 10^9 points
 * \param[in] tick told how far it is; may be empty */
LabelledCloud blueNoise (const Shape& shape, double spacing, std::uint64_t seed,
                         Strata strata = Strata::SAMPLED, const Tick& tick = {});

/** \brief Independent random points, uniform in length, area or volume.
 * \param[in] count number of points in all. Where strata are sampled each gets the part of them that makes it
 * as dense as the rest (corners and ends one point each, as far as \a count allows). */
LabelledCloud uniform (const Shape& shape, std::size_t count, std::uint64_t seed,
                       Strata strata = Strata::SAMPLED);

/** \brief A sample with a point within \a eps times the local feature size of every place of the shape: blue
 * noise at \a eps times Shape::feature_size.
 * \throws std::invalid_argument if the feature size is not known or infinite, or \a eps is not positive */
LabelledCloud epsilonSample (const Shape& shape, double eps, std::uint64_t seed);

/** \brief The local feature size at a place of a shape: a positive function that changes by no more than the
 * distance between two places. */
using FeatureSize = std::function<double (const Eigen::Vector3d& place)>;

/** \brief As epsilonSample, but as sparse as the feature size allows at each place.
 * \param[in] shape without strata
 * \param[in] eps between 0 and 1; std::invalid_argument otherwise */
LabelledCloud adaptiveSample (const Shape& shape, const FeatureSize& feature_size, double eps,
                              std::uint64_t seed);

/** \brief The spacing at which blueNoise gives about \a count points (within a few per cent;
 * of a solid up to 15 % fewer while its skin holds many of them).
 * \param[in] count at least 1 */
double spacingFor (const Shape& shape, std::size_t count);

/** \brief About how many points blueNoise gives at a spacing. */
double expectedCount (const Shape& shape, double spacing);

} // namespace generate
