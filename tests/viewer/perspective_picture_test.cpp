#include "wardslam/viewer/perspective_picture.h"

#include <gtest/gtest.h>

namespace wardslam::viewer {
namespace {

/// A red wall at this height.
mapping::SemanticMap wallAt(double z_m) {
  mapping::SemanticMap map;
  map.keyframes[1].T_map_cam.translation() = Eigen::Vector3d(0, 0, z_m);
  for (float x = 0.0F; x < 2.0F; x += 0.02F) {
    for (float z = 0.0F; z < 0.5F; z += 0.02F) {
      mapping::SemanticPoint point;
      point.p_cam_m = Eigen::Vector3f(x, 0.0F, z);
      point.color_rgb = {230, 10, 10};
      map.cloud[1].points.push_back(point);
    }
  }
  mapping::MapObject object;
  object.id = 1;
  object.classId = 60;
  object.color_rgb = {0, 0, 255};
  object.orientedBox.T_map_box.translation() = Eigen::Vector3d(1, 1, 0.5);
  object.orientedBox.size_m = Eigen::Vector3d(1, 1, 1);
  object.box_m.extend(Eigen::Vector3d(0.5, 0.5, 0)).extend(Eigen::Vector3d(1.5, 1.5, 1));
  map.objects[1] = object;
  return map;
}

int count(const cv::Mat& picture, const cv::Scalar& from_bgr, const cv::Scalar& to_bgr) {
  cv::Mat mask;
  cv::inRange(picture, from_bgr, to_bgr, mask);
  return cv::countNonZero(mask);
}

TEST(PerspectivePicture, ShowsCloudAndBoxes) {
  const cv::Mat picture = drawPerspective(wallAt(0.0), {600, 400});
  ASSERT_EQ(picture.size(), cv::Size(600, 400));
  EXPECT_GT(count(picture, {0, 0, 180}, {60, 60, 255}), 500) << "the red wall";
  EXPECT_GT(count(picture, {180, 0, 0}, {255, 60, 60}), 50) << "the edges of the blue box";
  EXPECT_GT(count(picture, {250, 250, 250}, {255, 255, 255}), 100'000) << "paper";
}

TEST(PerspectivePicture, LooksBelowTheCeiling) {
  EXPECT_EQ(count(drawPerspective(wallAt(2.5), {600, 400}), {0, 0, 180}, {60, 60, 255}), 0);
}

TEST(PerspectivePicture, OfNothingIsBlank) { EXPECT_EQ(drawPerspective({}, {300, 200}).size(), cv::Size(300, 200)); }

}  // namespace
}  // namespace wardslam::viewer
