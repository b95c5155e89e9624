#include <generate/lidar_sweeps.h>
#include <generate/spinning_lidar.h>

namespace generate {

const std::vector<LidarSweep>&
lidarSweeps ()
{
  static const std::vector<LidarSweep> list = [] {
    std::vector<LidarSweep> result = {{"lidar-aerial", &lidarAerial, 200000},
                                      {"lidar-terrestrial", &lidarTerrestrial, 200000}};
    for (const int rings : {16, 32, 64})
      result.push_back ({"frame-" + std::to_string (rings),
                         [rings] (const LidarSettings& settings, const Tick& tick) {
                           return lidarFrame (rings, settings, tick);
                         },
                         0});
    result.push_back (
      {"map-64",
       [] (const LidarSettings& settings, const Tick& tick) { return lidarMap (64, settings, tick); }, 0});
    return result;
  }();
  return list;
}

} // namespace generate
