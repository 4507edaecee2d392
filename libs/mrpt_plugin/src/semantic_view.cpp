#include "semantic_view.h"

#include <mrpt/math/wrap2pi.h>
#include <mrpt/opengl/CFrustum.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CText.h>

#include <cmath>

#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/nearest_pixel.h"

namespace wardslam::mrpt_plugin {
namespace {

/// The middle of those key points that lie on a thing.
struct Place {
  Eigen::Vector3d sum_m = Eigen::Vector3d::Zero();
  int points = 0;
};

mrpt::img::TColor colorOf(KeypointState state) {
  switch (state) {
    case KeypointState::Dynamic:
      return {230, 20, 20};
    case KeypointState::Movable:
      return {255, 150, 0};
    default:
      return {0, 150, 60};
  }
}

std::uint16_t instanceAt(const cv::Mat& instanceIds, const cv::Point2f& raw_px) {
  if (instanceIds.empty()) return 0;
  return instanceIds.at<std::uint16_t>(core::nearestPixel(raw_px, instanceIds.size()));
}

mrpt::opengl::CText::Ptr nameAt(const std::string& name, const Eigen::Vector3d& p_base_m) {
  auto text = mrpt::opengl::CText::Create(name);
  text->setFont("sans", 12);
  text->setColor_u8(255, 255, 255);
  text->setLocation(p_base_m.x(), p_base_m.y(), p_base_m.z());
  return text;
}

mrpt::opengl::CFrustum::Ptr frustumOf(const CObservationSemanticRGBD& o) {
  constexpr float kLength_m = 0.4F;
  auto frustum = mrpt::opengl::CFrustum::Create();
  frustum->setNearFarPlanes(0.01F, kLength_m);
  frustum->setHorzFOV(static_cast<float>(mrpt::RAD2DEG(2 * std::atan(o.camera.width_px / (2 * o.camera.fx_px)))));
  frustum->setVertFOV(static_cast<float>(mrpt::RAD2DEG(2 * std::atan(o.camera.height_px / (2 * o.camera.fy_px)))));
  frustum->setPose(o.cameraPose);
  return frustum;
}

}  // namespace

void addTo(mrpt::opengl::CSetOfObjects& view, const CObservationSemanticRGBD& o) {
  constexpr int kPointsForName = 10;  // names of things that are hardly seen would hide the others
  const Eigen::Isometry3d T_base_cam = core::fromMrpt(o.cameraPose) * core::T_sensor_cam();
  auto points = mrpt::opengl::CPointCloudColoured::Create();
  points->setPointSize(4.0F);
  std::map<std::uint16_t, Place> places;
  for (std::size_t i = 0; i < o.features.size(); ++i) {
    const auto p_cam_m = o.pointInCamera(i);
    if (!p_cam_m) continue;
    const Eigen::Vector3d p_m = T_base_cam * *p_cam_m;
    const Eigen::Vector3f p = p_m.cast<float>();
    const auto color = colorOf(o.states.at(i));
    points->insertPoint({p.x(), p.y(), p.z(), color.R, color.G, color.B, 255});
    Place& place = places[instanceAt(o.segmentation.instanceIds, o.features.keypoints[i].raw_px)];
    place.sum_m += p_m;
    ++place.points;
  }
  view.insert(points);
  for (const core::Instance& instance : o.segmentation.instances) {
    const Place& place = places[instance.id];
    const auto name = o.classes.find(instance.classId);
    if (name == o.classes.end() || place.points < kPointsForName) continue;
    view.insert(nameAt(name->second, place.sum_m / place.points));
  }
  view.insert(frustumOf(o));
}

}  // namespace wardslam::mrpt_plugin
