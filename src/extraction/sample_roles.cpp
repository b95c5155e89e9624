#include "extraction/sample_roles.h"

#include "common/parallel.h"

namespace pcl {
namespace manifold {

std::vector<Role>
sampleRoles (const SampleDimensions& dimensions)
{
  std::vector<Role> roles (dimensions.dimension.size ());
  parallelFor (roles.size (), [&] (std::size_t i) {
    const int label = dimensions.dimension[i];
    const int manifold = dimensions.manifold_dimension[i];
    if (manifold == 1)
      roles[i] = Role::CURVE;
    else if (label == 1)
      roles[i] = Role::RIM;
    else
      roles[i] = manifold == 3 && label == 3 ? Role::SOLID : Role::SURFACE;
  });
  return roles;
}

} // namespace manifold
} // namespace pcl
