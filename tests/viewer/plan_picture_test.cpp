#include "wardslam/viewer/plan_picture.h"

#include <gtest/gtest.h>

namespace wardslam::viewer {
namespace {

using mapping::FloorPlan;
using mapping::MapObject;

/// A floor of 6 m x 4 m from (0, 0), free but for the column of cells at x = 5 m.
mapping::SemanticMap room() {
  mapping::SemanticMap map;
  map.floorPlan.resolution_m = 0.1;
  map.floorPlan.cells = cv::Mat(40, 60, CV_8UC1, cv::Scalar(FloorPlan::kFree));
  map.floorPlan.cells.col(50) = FloorPlan::kOccupied;
  return map;
}

/// The pixel of a place in the picture of room(), which has a margin of 0.3 m: y goes up.
cv::Vec3b colorAt(const cv::Mat& picture, double x_m, double y_m) {
  const double scale = picture.cols / 6.6;
  return picture.at<cv::Vec3b>(cvRound((4.3 - y_m) * scale), cvRound((x_m + 0.3) * scale));
}

void addObject(mapping::SemanticMap& map, mapping::ObjectState state) {
  MapObject bed;
  bed.id = 1;
  bed.classId = 60;
  bed.color_rgb = {200, 0, 0};
  bed.state = state;
  bed.orientedBox.T_map_box.translation() = Eigen::Vector3d(3, 2, 0.5);
  bed.orientedBox.size_m = Eigen::Vector3d(2, 1, 1);
  bed.box_m.extend(Eigen::Vector3d(2, 1.5, 0)).extend(Eigen::Vector3d(4, 2.5, 1));
  map.objects[1] = bed;
}

TEST(PlanPicture, ShowsTheFloorWithYUp) {
  auto map = room();
  map.floorPlan.cells.at<unsigned char>(35, 5) = FloorPlan::kUnknown;
  const cv::Mat picture = drawPlan(map);
  EXPECT_EQ(colorAt(picture, 2, 2), cv::Vec3b(255, 255, 255));
  EXPECT_LT(colorAt(picture, 5.05, 2)[0], 150);
  EXPECT_NE(colorAt(picture, 0.55, 3.55), cv::Vec3b(255, 255, 255)) << "unknown";
  EXPECT_EQ(colorAt(picture, 0.55, 0.55), cv::Vec3b(255, 255, 255));
}

TEST(PlanPicture, PaintsObjectsInTheColourOfTheirClass) {
  auto map = room();
  addObject(map, mapping::ObjectState::Static);
  const cv::Vec3b bed = colorAt(drawPlan(map), 2.3, 1.7);
  EXPECT_GT(bed[2], bed[0]) << "reddish";
  addObject(map, mapping::ObjectState::Gone);
  EXPECT_EQ(colorAt(drawPlan(map), 2.3, 1.7), cv::Vec3b(255, 255, 255)) << "only its outline stays";
}

TEST(PlanPicture, NamesThingsByClassNumberAndState) {
  MapObject thing;
  thing.id = 7;
  thing.classId = 60;
  EXPECT_EQ(tagOf(thing, core::LabelSpace::coco()), "bed #7");
  thing.state = mapping::ObjectState::Moved;
  EXPECT_EQ(tagOf(thing, core::LabelSpace::coco()), "bed #7 (moved)");
  thing.classId = 200;
  thing.state = mapping::ObjectState::Gone;
  EXPECT_EQ(tagOf(thing, core::LabelSpace::coco()), "class 200 #7 (gone)");
}

TEST(PlanPicture, OutlinesAreTurnedAsBoxesAre) {
  mapping::OrientedBox box;
  box.size_m = Eigen::Vector3d(2, 1, 5);
  box.T_map_box = Eigen::Translation3d(10, 20, 1) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
  const auto corners = footprint(box);
  ASSERT_EQ(corners.size(), 4U);
  EXPECT_TRUE(corners[0].isApprox(Eigen::Vector2d(10.5, 19)));  // (-1, -0.5) turned left is (0.5, -1)
  EXPECT_TRUE(corners[2].isApprox(Eigen::Vector2d(9.5, 21)));
}

TEST(PlanPicture, NamesNoZoneThatIsOutsideOfIt) {
  auto map = room();
  const cv::Mat without = drawPlan(map);
  map.zones.push_back({"elsewhere", {{100, 100}, {110, 100}, {110, 110}}});
  EXPECT_EQ(cv::norm(drawPlan(map), without), 0.0);
}

TEST(PlanPicture, TheGroundHasNeitherThingsNorZones) {
  auto map = room();
  const cv::Mat bare = drawGround(map);
  EXPECT_EQ(colorAt(bare, 2, 2), cv::Vec3b(255, 255, 255));
  EXPECT_LT(colorAt(bare, 5.05, 2)[0], 150);
  addObject(map, mapping::ObjectState::Static);
  map.zones.push_back({"ward", {{0, 0}, {4, 0}, {4, 4}}});
  EXPECT_EQ(cv::norm(drawGround(map), bare), 0.0);
}

TEST(PlanPicture, ShowsPointsFromAboveHighestFirst) {
  auto map = room();
  map.keyframes[1].T_map_cam.translation() = Eigen::Vector3d(1, 1, 1);
  const auto add = [&map](double z_m, std::uint8_t gray) {
    mapping::SemanticPoint point;
    point.p_cam_m = Eigen::Vector3f(1.5F, 2.0F, static_cast<float>(z_m) - 1.0F);
    point.color_rgb = {gray, gray, gray};
    map.cloud[1].points.push_back(point);
  };
  add(1.0, 70);
  add(0.5, 10);
  add(2.8, 30);  // a lamp
  add(0.0, 40);  // the floor
  EXPECT_EQ(colorAt(drawPlan(map), 2.51, 2.99), cv::Vec3b(70, 70, 70));
}

TEST(PlanPicture, ShowsZonesAndTheWay) {
  auto map = room();
  const cv::Vec3b without = colorAt(drawPlan(map), 3.5, 3.5);
  map.zones.push_back({"clean", {{3, 3}, {4, 3}, {4, 4}, {3, 4}}});
  map.keyframes[1].T_map_cam.translation() = Eigen::Vector3d(1, 1, 1);
  map.keyframes[2].T_map_cam.translation() = Eigen::Vector3d(2, 1, 1);
  const cv::Mat picture = drawPlan(map);
  EXPECT_NE(colorAt(picture, 3.7, 3.4), without);
  EXPECT_NE(colorAt(picture, 1.5, 1.0), cv::Vec3b(255, 255, 255));
}

TEST(PlanPicture, OfNothingIsSmallAndOfEqualMapsEqual) {
  EXPECT_LT(drawPlan({}).total(), 200U * 200U);
  auto map = room();
  addObject(map, mapping::ObjectState::Moved);
  EXPECT_EQ(cv::norm(drawPlan(map), drawPlan(map), cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace wardslam::viewer
