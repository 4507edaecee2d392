#include "wardslam/mrpt_slam/simple_map_file.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include "support/complaint.h"
#include "support/temporary_folder.h"
#include "support/textured_room_scan.h"
#include "wardslam/pipeline/earlier_map.h"

namespace wardslam::mrpt_slam {
namespace {

using mrpt::obs::CObservation3DRangeScan;
using testing::AllOf;
using testing::HasSubstr;

/// A simple map of every fifth image of a walk, at places 3 m beside the origin.
class SimpleMapFileTest : public ::testing::Test {
 protected:
  SimpleMapFileTest() {
    options_.deterministic = true;
    options_.filters = pipeline::SlamOptions::noFilters();
  }

  /// Where the walk begins the camera's housing stands at (3, 0, 1.2), looking along x.
  static Eigen::Isometry3d T_map_base(int image) {
    const Eigen::Isometry3d T_base_cam = core::T_sensor_cam();
    return Eigen::Translation3d(3.0, 0.0, 1.2) * T_base_cam * test::TexturedRoom::T_room_cam(0).inverse() *
           test::TexturedRoom::T_room_cam(image) * T_base_cam.inverse();
  }
  [[nodiscard]] CObservation3DRangeScan::Ptr scan(int image) const {
    auto scan = test::observe(room_, image);
    scan->sensorLabel = "RGBD";
    return scan;
  }
  static void insert(const CObservation3DRangeScan::Ptr& scan, int image, mrpt::maps::CSimpleMap& simple) {
    auto observed = mrpt::obs::CSensoryFrame::Create();
    observed->insert(scan);
    const auto pose = mrpt::poses::CPose3DPDFGaussian::Create(core::toMrpt(T_map_base(image)));
    simple.insert(mrpt::poses::CPose3DPDF::Ptr(pose), observed);
  }
  [[nodiscard]] mrpt::maps::CSimpleMap simpleMap() const {
    mrpt::maps::CSimpleMap simple;
    for (int image = 0; image <= 20; image += 5) insert(scan(image), image, simple);
    return simple;
  }
  [[nodiscard]] std::string complaint(const mrpt::maps::CSimpleMap& simple, const std::string& label = "") const {
    return test::complaintOf([&] { return makeMapFile(simple, options_, label, file()); });
  }
  [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "room.wardmap"; }

  const test::TexturedRoom room_;
  const test::TemporaryFolder folder_;
  pipeline::SlamOptions options_;
};

TEST_F(SimpleMapFileTest, IsAMapWhereTheSimpleMapHasIt) {
  EXPECT_EQ(makeMapFile(simpleMap(), options_, "", file()), 5U);
  const auto earlier = pipeline::readEarlierMap(file());
  ASSERT_FALSE(earlier.graph.keyframes.empty());
  for (const auto& keyframe : earlier.graph.keyframes) {
    const int image = static_cast<int>(std::lround((keyframe->stamp_s - 1000.0) * 32.0));
    const Eigen::Isometry3d T_map_cam = T_map_base(image) * core::T_sensor_cam();
    EXPECT_LT((keyframe->T_map_cam.translation() - T_map_cam.translation()).norm(), 0.006) << image;
    EXPECT_TRUE(keyframe->T_map_cam.linear().isApprox(T_map_cam.linear(), 0.01)) << image;
  }
  EXPECT_FALSE(earlier.semantic.cloud.empty());
}

TEST_F(SimpleMapFileTest, WhatCannotBeUsedIsNamed) {
  auto simple = simpleMap();
  auto pointsAlone = scan(25);
  pointsAlone->hasIntensityImage = false;
  insert(pointsAlone, 25, simple);
  EXPECT_THAT(complaint(simple), AllOf(HasSubstr("keyframe 5"), HasSubstr("without colour"), HasSubstr(".wardmap")));
  EXPECT_THAT(complaint(simpleMap(), "OTHER"), AllOf(HasSubstr("keyframe 0"), HasSubstr("'OTHER'")));
  auto absent = simpleMap();
  auto outside = scan(25);
  outside->intensityImage.setExternalStorage("/absent/image.png");
  insert(outside, 25, absent);
  EXPECT_THAT(complaint(absent), AllOf(HasSubstr("keyframe 5"), HasSubstr("image.png")));
  auto backwards = simpleMap();
  insert(scan(3), 3, backwards);
  EXPECT_THAT(complaint(backwards), AllOf(HasSubstr("keyframe 5"), HasSubstr("not taken after")));
  EXPECT_THAT(complaint({}), HasSubstr("empty"));
}

TEST_F(SimpleMapFileTest, WhereNothingCanBeRecognisedThereIsNoMap) {
  mrpt::maps::CSimpleMap dark;
  auto blank = scan(0);
  blank->intensityImage = mrpt::img::CImage(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(20)), mrpt::img::DEEP_COPY);
  insert(blank, 0, dark);
  EXPECT_THAT(complaint(dark), HasSubstr("none of the 1 keyframes"));
}

}  // namespace
}  // namespace wardslam::mrpt_slam
