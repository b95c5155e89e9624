#include <generate/labelled_cloud.h>
#include <generate/random.h>

#include <stdexcept>

namespace generate {

void
LabelledCloud::add (const Eigen::Vector3d& point, std::uint32_t label, double point_depth, bool on_boundary,
                    std::uint32_t point_object)
{
  points.push_back (point);
  labels.push_back (label);
  depth.push_back (point_depth);
  boundary.push_back (on_boundary ? 1 : 0);
  object.push_back (point_object);
}

void
LabelledCloud::append (const LabelledCloud& other, std::uint32_t first_object)
{
  const std::size_t count = other.size ();
  for (std::size_t i = 0; i < count; ++i)
    add (other.points[i], other.labels[i], other.depth[i], other.boundary[i] != 0,
         first_object + other.object[i]);
}

void
addNoise (LabelledCloud& cloud, double sigma, std::uint64_t seed)
{
  if (!(sigma >= 0.0))
    throw std::invalid_argument ("noise must be 0 or more");
  if (sigma == 0.0)
    return;
  Random random (seed);
  for (Eigen::Vector3d& point : cloud.points)
    for (int axis = 0; axis < 3; ++axis)
      point[axis] += sigma * random.normal ();
}

} // namespace generate
