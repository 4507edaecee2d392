#include "estimation_picture.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::mrpt_slam {
namespace {

/// 4 m by 3 m, cells of 0.1 m from (0, 0) on; a wall along its upper edge.
mapping::FloorPlan plan() {
  mapping::FloorPlan plan;
  plan.resolution_m = 0.1;
  plan.cells = cv::Mat(30, 40, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));
  plan.cells.row(29).setTo(mapping::FloorPlan::kOccupied);
  plan.cells.at<unsigned char>(0, 39) = mapping::FloorPlan::kUnknown;
  return plan;
}

core::StampedPose at(double x_m, double y_m) {
  core::StampedPose pose;
  pose.T_map_cam.translation() = Eigen::Vector3d(x_m, y_m, 1.0);
  return pose;
}

TEST(EstimationPicture, ShowsTheFloorTheWayAndTheRobotWithYUp) {
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  T_map_base.translation() = Eigen::Vector3d(3.05, 1.05, 0.0);
  const cv::Mat picture = drawEstimation(plan(), {at(0.55, 1.05), at(2.05, 1.05)}, T_map_base);
  ASSERT_EQ(picture.size(), cv::Size(40, 30));
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 5), cv::Vec3b(0, 0, 0)) << "the wall is on top";
  EXPECT_EQ(picture.at<cv::Vec3b>(25, 5), cv::Vec3b(255, 255, 255));
  EXPECT_EQ(picture.at<cv::Vec3b>(29, 39), cv::Vec3b(160, 160, 160)) << "unknown";
  EXPECT_EQ(picture.at<cv::Vec3b>(19, 10), cv::Vec3b(0, 0, 220)) << "the way";
  EXPECT_EQ(picture.at<cv::Vec3b>(19, 30), cv::Vec3b(220, 60, 0)) << "the robot";
}

TEST(EstimationPicture, WithoutAPlanShowsTheWayAlone) {
  const cv::Mat picture = drawEstimation({}, {at(-2.0, 0.0), at(4.0, 1.0)}, Eigen::Isometry3d::Identity());
  EXPECT_GE(picture.cols, 160);  // 8 m of 5 cm
  EXPECT_GE(picture.rows, 60);
  EXPECT_FALSE(drawEstimation({}, {}, Eigen::Isometry3d::Identity()).empty());
}

TEST(EstimationPicture, IsWrittenAsItsNameSays) {
  const test::TemporaryFolder folder;
  const cv::Mat picture = drawEstimation(plan(), {}, Eigen::Isometry3d::Identity());
  for (const char* name : {"a.png", "a.BMP"}) {
    writePicture(picture, (folder.path() / name).string());
    EXPECT_EQ(cv::imread((folder.path() / name).string()).size(), picture.size()) << name;
  }
  writePicture(picture, (folder.path() / "b.emf").string());
  EXPECT_EQ(cv::imread((folder.path() / "b.emf.png").string()).size(), picture.size());
  EXPECT_THROW(writePicture(picture, (folder.path() / "absent" / "c.png").string()), core::InputError);
}

}  // namespace
}  // namespace wardslam::mrpt_slam
