#include "wardslam/exchange/metric_maps.h"

#include <mrpt/maps/CColouredOctoMap.h>
#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/COctoMap.h>

#include "octree.h"
#include "wardslam/mapping/cloud_in_map.h"

namespace wardslam::exchange {
namespace {

/// `OctoMap`: MRPT's with colours or without.
template <class OctoMap>
std::shared_ptr<OctoMap> voxelsOf(const mapping::SemanticMap& map, double resolution_m) {
  octomap::OcTree tree(resolution_m);
  fillOctree(map, tree);
  tree.expand();  // a voxel at a time is what MRPT takes: it does not let its tree out
  auto octoMap = std::make_shared<OctoMap>(resolution_m);
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    octoMap->updateVoxel(leaf.getX(), leaf.getY(), leaf.getZ(), tree.isNodeOccupied(*leaf));
  }
  return octoMap;
}

}  // namespace

std::shared_ptr<mrpt::maps::CColouredPointsMap> toColouredPoints(const mapping::SemanticMap& map) {
  const auto share = [](std::uint8_t level) { return static_cast<float>(level) / 255.0F; };
  auto points = mrpt::maps::CColouredPointsMap::Create();
  mapping::forEachCloudPoint(map, [&](const Eigen::Vector3f& p_m, const mapping::SemanticPoint& point) {
    const auto [red, green, blue] = point.color_rgb;
    points->insertPointRGB(p_m.x(), p_m.y(), p_m.z(), share(red), share(green), share(blue));
  });
  return points;
}

std::shared_ptr<mrpt::maps::COctoMap> toOctoMap(const mapping::SemanticMap& map, double resolution_m) {
  return voxelsOf<mrpt::maps::COctoMap>(map, resolution_m);
}

std::shared_ptr<mrpt::maps::CColouredOctoMap> toColouredOctoMap(const mapping::SemanticMap& map, double resolution_m) {
  auto octoMap = voxelsOf<mrpt::maps::CColouredOctoMap>(map, resolution_m);
  octoMap->setVoxelColourMethod(mrpt::maps::CColouredOctoMap::AVERAGE);
  mapping::forEachCloudPoint(map, [&](const Eigen::Vector3f& p_m, const mapping::SemanticPoint& point) {
    const auto [red, green, blue] = point.color_rgb;
    octoMap->updateVoxelColour(p_m.x(), p_m.y(), p_m.z(), red, green, blue);
  });
  return octoMap;
}

}  // namespace wardslam::exchange
