#include "wardslam/viewer/perspective_picture.h"

#include <mrpt/opengl/CFBORender.h>
#include <mrpt/opengl/COpenGLScene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <exception>
#include <memory>

#include "wardslam/core/errors.h"
#include "wardslam/viewer/map_scene.h"

namespace wardslam::viewer {
namespace {

constexpr float kAzimuth_deg = -60.0F;
constexpr float kElevation_deg = 50.0F;
constexpr double kCeiling_m = 2.2;  // what hangs higher would hide the rooms below

Eigen::AlignedBox3d extentOf(const mapping::SemanticMap& map) {
  Eigen::AlignedBox3d extent;
  for (const auto& [id, object] : map.objects) extent.extend(object.box_m);
  for (const auto& [id, keyframe] : map.keyframes) extent.extend(keyframe.T_map_cam.translation());
  if (extent.isEmpty()) extent.extend(Eigen::Vector3d::Zero());
  return extent;
}

mapping::SemanticMap withoutCeiling(mapping::SemanticMap map) {
  for (auto& [id, tile] : map.cloud) {
    const auto keyframe = map.keyframes.find(id);
    if (keyframe == map.keyframes.end()) continue;
    const auto hangsHigh = [&](const mapping::SemanticPoint& point) {
      return (keyframe->second.T_map_cam * point.p_cam_m.cast<double>()).z() > kCeiling_m;
    };
    tile.points.erase(std::remove_if(tile.points.begin(), tile.points.end(), hangsHigh), tile.points.end());
  }
  return map;
}

std::unique_ptr<mrpt::opengl::CFBORender> makeTarget(const cv::Size& size_px) {
  try {
    return std::make_unique<mrpt::opengl::CFBORender>(static_cast<unsigned>(size_px.width),
                                                      static_cast<unsigned>(size_px.height));
  } catch (const std::exception&) {
    throw core::InputError("nothing can be rendered on this machine: install libegl1 and libgl1-mesa-dri");
  }
}

}  // namespace

cv::Mat drawPerspective(const mapping::SemanticMap& map, const cv::Size& size_px) {
  const auto target = makeTarget(size_px);  // owns the OpenGL context: outlives the scene's buffers
  const auto scene = viewer::makeScene(withoutCeiling(map));
  scene->getViewport()->setCustomBackgroundColor({1.0F, 1.0F, 1.0F});
  const auto extent = extentOf(map);
  auto& camera = target->getCamera(*scene);
  const Eigen::Vector3d centre = extent.center();
  camera.setPointingAt(static_cast<float>(centre.x()), static_cast<float>(centre.y()), 0.5F);
  camera.setAzimuthDegrees(kAzimuth_deg);
  camera.setElevationDegrees(kElevation_deg);
  camera.setZoomDistance(static_cast<float>(std::max(3.0, 1.5 * extent.diagonal().norm())));
  mrpt::img::CImage image(size_px.width, size_px.height, mrpt::img::CH_RGB);
  target->render_RGB(*scene, image);
  cv::Mat picture = image.asCvMat<cv::Mat>(mrpt::img::DEEP_COPY);
  return picture;
}

}  // namespace wardslam::viewer
