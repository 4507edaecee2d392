#include "wardslam/exchange/ros_map.h"

#include <gtest/gtest.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/map_export.h"

namespace wardslam::exchange {
namespace {

using mapping::FloorPlan;

class RosMapTest : public testing::Test {
 protected:
  std::filesystem::path written(const std::string& yaml) {
    const auto file = folder_.path() / "map.yaml";
    std::ofstream(file) << yaml;
    return file;
  }

  test::TemporaryFolder folder_;
};

TEST_F(RosMapTest, WhatWasExportedComesBackTheSame) {
  auto ward = test::makeWard();
  ward.floorPlan.origin_m = {-1.234, 0.377};
  exportRosMap(ward, folder_.path() / "ward.yaml");
  const FloorPlan plan = readRosMap(folder_.path() / "ward.yaml");
  EXPECT_EQ(plan.resolution_m, 0.05);
  EXPECT_EQ(plan.origin_m, ward.floorPlan.origin_m);
  ASSERT_EQ(plan.cells.size(), ward.floorPlan.cells.size());
  EXPECT_EQ(cv::countNonZero(plan.cells != ward.floorPlan.cells), 0);
}

TEST_F(RosMapTest, ValuesBecomeCellsAsMapServerTakesThem) {
  // Upper row: white, black. Lower row: map_server's grey for unknown, and one darker than occupied_thresh.
  const cv::Mat image = (cv::Mat_<unsigned char>(2, 2) << 254, 0, 205, 70);
  cv::imwrite((folder_.path() / "map.png").string(), image);
  const std::string rest =
      "image: map.png\nresolution: 0.5\norigin: [1, 2, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.19\n";
  FloorPlan plan = readRosMap(written("negate: 0\n" + rest));
  EXPECT_EQ(plan.cells.at<unsigned char>(1, 0), FloorPlan::kFree) << "the upper row is the farther one along y";
  EXPECT_EQ(plan.cells.at<unsigned char>(1, 1), FloorPlan::kOccupied);
  EXPECT_EQ(plan.cells.at<unsigned char>(0, 0), FloorPlan::kUnknown);
  EXPECT_EQ(plan.cells.at<unsigned char>(0, 1), FloorPlan::kOccupied);
  plan = readRosMap(written("negate: 1\n" + rest));
  EXPECT_EQ(plan.cells.at<unsigned char>(1, 0), FloorPlan::kOccupied);
  EXPECT_EQ(plan.cells.at<unsigned char>(1, 1), FloorPlan::kFree);
}

TEST_F(RosMapTest, RefusesWhatItCannotPlace) {
  cv::imwrite((folder_.path() / "map.png").string(), cv::Mat(2, 2, CV_8UC1, cv::Scalar(0)));
  EXPECT_THROW((void)readRosMap(folder_.path() / "none.yaml"), core::InputError);
  EXPECT_THROW((void)readRosMap(written("image: map.png\nresolution: 0.5\n")), core::InputError);
  EXPECT_THROW((void)readRosMap(written("image: none.png\nresolution: 0.5\norigin: [0, 0, 0]\n")), core::InputError);
  EXPECT_THROW((void)readRosMap(written("image: map.png\nresolution: 0\norigin: [0, 0, 0]\n")), core::InputError);
  EXPECT_THROW((void)readRosMap(written("image: map.png\nresolution: 0.5\norigin: [0, 0, 0.1]\n")), core::InputError);
}

}  // namespace
}  // namespace wardslam::exchange
