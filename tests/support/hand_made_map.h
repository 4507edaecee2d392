#pragma once

#include <cmath>
#include <memory>
#include <string>

#include "wardslam/mapping/semantic_map.h"
#include "wardslam/odometry/keyframe.h"

/// A small ward put together by hand: two zones, one within the other, chairs, a bag on one of them, a wall across the
/// floor with a gap at one end.
namespace wardslam::test {

constexpr core::ClassId kChair = 57;
constexpr core::ClassId kBed = 60;
constexpr core::ClassId kBackpack = 25;
constexpr double kWardEnd_s = 1000.0;

inline mapping::MapObject makeObject(mapping::ObjectId id, core::ClassId classId, const Eigen::Vector3d& centre_m,
                                     const Eigen::Vector3d& size_m) {
  mapping::MapObject object;
  object.id = id;
  object.classId = classId;
  object.probability = 0.75;
  object.centroid_m = centre_m;
  object.box_m = Eigen::AlignedBox3d(centre_m - size_m / 2, centre_m + size_m / 2);
  object.orientedBox.T_map_box.translation() = centre_m;
  object.orientedBox.size_m = size_m;
  object.color_rgb = {10, 20, 30};
  object.firstSeen_s = kWardEnd_s - 100;
  object.lastSeen_s = kWardEnd_s - 1;
  object.views = 5;
  return object;
}

inline mapping::MapObject makeChair(mapping::ObjectId id, double x_m, double y_m) {
  return makeObject(id, kChair, {x_m, y_m, 0.45}, {0.5, 0.5, 0.9});
}

/// 8 m by 6 m, cells of 0.05 m, its corner at (-1, -1); free but for a wall along x = 3, open for y > 4.
inline mapping::FloorPlan makeFloorPlan() {
  mapping::FloorPlan plan;
  plan.origin_m = {-1.0, -1.0};
  plan.cells = cv::Mat(120, 160, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));
  plan.cells.colRange(80, 84).rowRange(0, 100).setTo(mapping::FloorPlan::kOccupied);
  plan.cells.rowRange(118, 120).setTo(mapping::FloorPlan::kUnknown);
  return plan;
}

inline mapping::SemanticMap makeWard() {
  mapping::SemanticMap map;
  map.zones = {{"ward", {{-1, -1}, {7, -1}, {7, 5}, {-1, 5}}}, {"clean zone", {{-1, -1}, {3, -1}, {3, 5}, {-1, 5}}}};
  map.objects[1] = makeChair(1, 0.0, 0.0);
  map.objects[2] = makeChair(2, 2.0, 2.0);
  map.objects[3] = makeObject(3, kBackpack, {2.0, 2.0, 0.6}, {0.3, 0.3, 0.4});  // on chair 2
  map.objects[4] = makeChair(4, 4.0, 0.0);                                      // behind the wall
  map.objects[5] = makeObject(5, kBed, {5.5, 3.0, 0.4}, {1.0, 2.0, 0.8});
  map.objects[6] = makeChair(6, 1.0, 0.0);
  map.objects[6].state = mapping::ObjectState::Gone;
  map.objects[7] = makeChair(7, 6.0, 0.0);
  map.objects[7].state = mapping::ObjectState::Moved;
  map.objects[7].lastSeen_s = kWardEnd_s - 60;
  for (auto& [id, object] : map.objects) object.zone = object.centroid_m.x() < 3 ? "clean zone" : "ward";
  for (std::uint64_t id = 1; id <= 3; ++id) {
    auto& keyframe = map.keyframes[id];
    keyframe.stamp_s = kWardEnd_s - 3.0 + static_cast<double>(id);
    keyframe.T_map_cam = Eigen::Translation3d(0.5 * static_cast<double>(id), 1.0, 1.2) *
                         Eigen::AngleAxisd(0.1 * static_cast<double>(id), Eigen::Vector3d(1, 2, 3).normalized());
    keyframe.zone = "clean zone";
    keyframe.freeFan_cam_m = {{-1.0F, 0.0F, 3.0F}, {1.0F, 0.5F, 2.0F + static_cast<float>(id)}};
    keyframe.ground = core::GroundPlane::atZero(keyframe.T_map_cam);
    keyframe.ground->covariance << 1e-4, 2e-5, 3e-5, 2e-5, 4e-4, 5e-5, 3e-5, 5e-5, 9e-4;
    if (id == 3) keyframe.ground.reset();  // not in sight
    auto& points = map.cloud[id].points;
    for (int i = 0; i < 50; ++i) {
      mapping::SemanticPoint point;
      point.p_cam_m = {0.01F * static_cast<float>(i), std::sin(static_cast<float>(i)), 2.0F + static_cast<float>(id)};
      point.color_rgb = {static_cast<std::uint8_t>(i), 100, 200};
      point.classId = i % 2 == 0 ? kChair : core::ClassId{0};
      point.object = i % 2 == 0 ? 1 : 0;
      point.sightings = static_cast<std::uint16_t>(i + 1);
      points.push_back(point);
    }
  }
  map.floorPlan = makeFloorPlan();
  return map;
}

/// What keyframe `id` saw: key points 2 m before the camera, point numbers id * 10 + 0…9; the last without depth.
inline std::shared_ptr<odometry::Keyframe> makeView(odometry::KeyframeId id, const mapping::SemanticMap& map) {
  auto view = std::make_shared<odometry::Keyframe>();
  view->id = id;
  view->stamp_s = map.keyframes.at(id).stamp_s;
  view->T_map_cam = map.keyframes.at(id).T_map_cam;
  view->camera.fx_px = 500.0;
  if (id > 1) view->T_previous_cam = map.keyframes.at(id - 1).T_map_cam.inverse() * view->T_map_cam;
  view->depth = std::make_shared<odometry::DepthView>(
      odometry::DepthView{320, 2, 1, {2000, 0}, {static_cast<std::uint16_t>(2000 + id), 0}});
  view->features.descriptors.create(10, 32, CV_8UC1);
  for (std::size_t i = 0; i < 10; ++i) {
    core::Keypoint keypoint;
    keypoint.raw_px = {100.0F + static_cast<float>(i), 200.5F};
    keypoint.undistorted_px = {101.0F + static_cast<float>(i), 201.5F};
    keypoint.depth_m = i < 9 ? 2.0F : 0.0F;
    keypoint.depthSpread_m = i < 9 ? 0.01F * static_cast<float>(i) : 0.0F;
    keypoint.angle_rad = 0.1F * static_cast<float>(i);
    keypoint.response = 7.0F;
    keypoint.scale = 1.2F;
    view->features.keypoints.push_back(keypoint);
    view->features.descriptors.row(static_cast<int>(i)).setTo(cv::Scalar(static_cast<double>(id * 10 + i)));
    view->sightings.push_back({id * 10 + i, i});
  }
  return view;
}

}  // namespace wardslam::test
