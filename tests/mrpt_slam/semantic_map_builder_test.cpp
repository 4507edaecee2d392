#include "wardslam/mrpt_slam/semantic_map_builder.h"

#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussian.h>

#include <Eigen/Eigenvalues>
#include <filesystem>
#include <future>
#include <thread>

#include "support/temporary_folder.h"
#include "support/textured_room_scan.h"
#include "wardslam/core/errors.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"
#include "wardslam/pipeline/slam_system.h"
#include "wardslam/storage/map_file_writer.h"

namespace wardslam::mrpt_slam {
namespace {

using mrpt::obs::CActionCollection;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CSensoryFrame;
using mrpt::poses::CPose3DPDFGaussian;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The robot is the camera's housing: x is where it looks.
Eigen::Isometry3d T_map_base(int image) {
  const Eigen::Isometry3d T_base_cam = core::T_sensor_cam();
  return T_base_cam * test::TexturedRoom::T_room_cam(0).inverse() * test::TexturedRoom::T_room_cam(image) *
         T_base_cam.inverse();
}

/// By its wheels, the robot has moved by this; as sure as `sigma` says (m, rad).
CActionCollection actionBy(const mrpt::poses::CPose2D& motion, double sigma) {
  mrpt::obs::CActionRobotMovement2D movement;
  auto pdf = std::make_shared<mrpt::poses::CPosePDFGaussian>(motion);
  pdf->cov.setDiagonal(3, sigma * sigma);
  movement.poseChange = mrpt::poses::CPosePDF::Ptr(pdf);
  CActionCollection actions;
  actions.insert(movement);
  return actions;
}

class SemanticMapBuilderTest : public ::testing::Test {
 protected:
  SemanticMapBuilderTest() { builder_.configuration.slam = options(); }

  static pipeline::SlamOptions options() {
    pipeline::SlamOptions options;
    options.deterministic = true;
    options.filters = pipeline::SlamOptions::noFilters();
    options.map_frame.level_with_floor = false;
    return options;
  }

  [[nodiscard]] CObservation3DRangeScan::Ptr scan(int image) const {
    auto scan = test::observe(room_, image);
    scan->sensorLabel = "RGBD";
    return scan;
  }
  /// Nothing to hold on to, nor any depth.
  [[nodiscard]] CObservation3DRangeScan::Ptr coveredScan(int image) const {
    auto covered = scan(image);
    covered->intensityImage = mrpt::img::CImage(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(20)), mrpt::img::DEEP_COPY);
    covered->rangeImage.setZero();
    return covered;
  }
  void processUntil(int images) {
    for (int image = 0; image < images; ++image) builder_.processObservation(scan(image));
  }
  void process(CActionCollection actions, const CObservation3DRangeScan::Ptr& scan) {
    CSensoryFrame observations;
    observations.insert(scan);
    builder_.processActionObservation(actions, observations);
  }
  [[nodiscard]] CPose3DPDFGaussian pose() const {
    return dynamic_cast<const CPose3DPDFGaussian&>(*builder_.getCurrentPoseEstimation());
  }
  void expectAt(const Eigen::Isometry3d& T_map_base, double tolerance_m) const {
    const Eigen::Isometry3d T = core::fromMrpt(pose().mean);
    EXPECT_LT((T.translation() - T_map_base.translation()).norm(), tolerance_m);
    EXPECT_TRUE(T.linear().isApprox(T_map_base.linear(), 0.01));
  }

  const test::TexturedRoom room_;
  CMetricMapBuilderSemantic builder_;
};

TEST_F(SemanticMapBuilderTest, IsDrivenAsMrptsOwnAre) {
  mrpt::slam::CMetricMapBuilder& builder = builder_;
  builder.initialize();
  for (int image = 0; image < 10; ++image) {
    CActionCollection nothingKnown;
    CSensoryFrame observations;
    observations.insert(scan(image));
    builder.processActionObservation(nothingKnown, observations);
    expectAt(T_map_base(image), 0.006);
  }
  const CPose3DPDFGaussian last = pose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(last.cov.asEigen());
  EXPECT_GT(eigen.eigenvalues().minCoeff(), 0.0);
  EXPECT_LT(eigen.eigenvalues().maxCoeff(), 0.01 * 0.01) << "a wall full of points, two metres away";
  mrpt::maps::CSimpleMap simple;
  builder.getCurrentlyBuiltMap(simple);
  EXPECT_GE(simple.size(), 1U);
  EXPECT_EQ(builder.getCurrentlyBuiltMapSize(), simple.size());
  const auto& maps = core::metricMapOf(builder.getCurrentlyBuiltMetricMap());
  ASSERT_TRUE(maps.mapByClass<mrpt_plugin::CSemanticMap>());
  EXPECT_EQ(maps.mapByClass<mrpt_plugin::CSemanticMap>()->map().keyframes.size(), simple.size());
}

TEST_F(SemanticMapBuilderTest, DoesWhatASlamSystemDoes) {
  pipeline::SlamSystem slam(options(), {}, pipeline::WhenBehind::Waits);
  builder_.initialize();
  for (int image = 0; image < 15; ++image) {
    const Eigen::Isometry3d T_map_cam = slam.process(scan(image)).T_map_cam;
    builder_.processObservation(scan(image));
    EXPECT_TRUE((core::fromMrpt(pose().mean) * core::T_sensor_cam()).isApprox(T_map_cam, 1e-9)) << image;
  }
  slam.finish();
  builder_.finish();
  const auto expected = slam.trajectory();
  const auto trajectory = builder_.trajectory();
  ASSERT_EQ(trajectory.size(), 15U);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    EXPECT_EQ(trajectory[i].stamp_s, expected[i].stamp_s);
    EXPECT_EQ(trajectory[i].T_map_cam.matrix(), expected[i].T_map_cam.matrix()) << i;
  }
  EXPECT_TRUE((core::fromMrpt(pose().mean) * core::T_sensor_cam()).isApprox(expected.back().T_map_cam, 1e-9));
}

TEST_F(SemanticMapBuilderTest, WhereNothingIsSeenTheActionLeads) {
  builder_.initialize();
  processUntil(5);
  const CPose3DPDFGaussian before = pose();
  process(actionBy({0.1, 0.02, 0.05}, 0.03), coveredScan(5));
  const CPose3DPDFGaussian led = pose();
  const auto way = led.mean - before.mean;
  EXPECT_NEAR(way.x(), 0.1, 1e-6);
  EXPECT_NEAR(way.y(), 0.02, 1e-6);
  EXPECT_NEAR(way.yaw(), 0.05, 1e-6);
  EXPECT_NEAR(std::sqrt(led.cov(3, 3)), 0.03, 0.003) << "as sure as the action, the camera is where the base is";
  process(actionBy({0.1, 0.0, 0.0}, 0.03), coveredScan(6));
  EXPECT_NEAR((pose().mean - led.mean).x(), 0.1, 1e-6);
  EXPECT_GT(pose().cov(3, 3), 1.9 * 0.03 * 0.03) << "two errors add up";
}

TEST_F(SemanticMapBuilderTest, WithoutActionsALostRobotGoesOnForAMomentAndIsThenThereButUnsure) {
  builder_.initialize();
  processUntil(5);
  const CPose3DPDFGaussian before = pose();
  builder_.processObservation(coveredScan(5));
  const CPose3DPDFGaussian led = pose();
  const double way_m = (led.mean - before.mean).norm();
  EXPECT_GT(way_m, 0.001);
  EXPECT_LT(way_m, 0.05);
  EXPECT_GT(pose().cov(0, 0), before.cov(0, 0));
  EXPECT_LT(std::sqrt(pose().cov(0, 0)), 0.1);
  builder_.processObservation(coveredScan(4 + 64));
  EXPECT_LT((pose().mean - led.mean).norm(), 1e-9);
  EXPECT_NEAR(std::sqrt(pose().cov(0, 0)), 0.5 + 2.0 * 2.0, 1e-6) << "half a metre, and 2 m/s for 2 s";
}

/// Half the room at once: farther than any search from where constant velocity leads.
TEST_F(SemanticMapBuilderTest, AnActionOfEachObservationWithoutAnImageAddsUp) {
  builder_.initialize();
  processUntil(3);
  const auto laser = mrpt::obs::CObservation2DRangeScan::Create();
  for (int step = 0; step < 2; ++step) {
    auto actions = actionBy({0.05, 0.0, 0.0}, 0.02);
    CSensoryFrame noImage;
    noImage.insert(laser);
    builder_.processActionObservation(actions, noImage);
  }
  const CPose3DPDFGaussian before = pose();
  process(actionBy({0.05, 0.0, 0.0}, 0.02), coveredScan(3));
  EXPECT_NEAR((pose().mean - before.mean).x(), 0.15, 1e-6);
}

TEST_F(SemanticMapBuilderTest, AnImageThatCannotBeUsedIsLeftOutAndItsMotionIsNot) {
  builder_.initialize();
  processUntil(3);
  auto broken = scan(3);
  broken->hasIntensityImage = false;
  const CPose3DPDFGaussian before = pose();
  EXPECT_THROW(process(actionBy({0.05, 0.0, 0.0}, 0.02), broken), core::FrameError);
  process(actionBy({0.05, 0.0, 0.0}, 0.02), coveredScan(4));
  EXPECT_NEAR((pose().mean - before.mean).x(), 0.1, 1e-6);
}

TEST_F(SemanticMapBuilderTest, AnImageOutOfOrderOrAbsentIsLeftOut) {
  builder_.initialize();
  processUntil(3);
  EXPECT_THROW(builder_.processObservation(scan(1)), core::FrameError);
  auto absent = scan(3);
  absent->intensityImage.setExternalStorage("/absent/image.png");
  EXPECT_THROW(builder_.processObservation(absent), core::FrameError);
  builder_.processObservation(nullptr);
  builder_.processObservation(scan(3));
  expectAt(T_map_base(3), 0.006);
}

TEST_F(SemanticMapBuilderTest, RefusesAnActionThatIsNoMotion) {
  builder_.initialize();
  EXPECT_THROW(process(actionBy({std::nan(""), 0.0, 0.0}, 0.02), scan(0)), core::InputError);
  process(actionBy({0.0, 0.0, 0.0}, 0.02), scan(0));
}

TEST_F(SemanticMapBuilderTest, TheSimpleMapHasPosesPointsAndWhatElseWasSeen) {
  builder_.initialize();
  for (int image = 0; image < 12; ++image) {
    CActionCollection nothingKnown;
    CSensoryFrame observations;
    observations.insert(scan(image));
    auto laser = mrpt::obs::CObservation2DRangeScan::Create();
    laser->sensorLabel = "LASER";
    observations.insert(laser);
    builder_.processActionObservation(nothingKnown, observations);
  }
  builder_.finish();
  const auto semantic = builder_.semanticMap();
  mrpt::maps::CSimpleMap simple;
  builder_.getCurrentlyBuiltMap(simple);
  ASSERT_EQ(simple.size(), semantic.keyframes.size());
  auto keyframe = semantic.keyframes.begin();
  for (const auto& entry : simple) {
    const Eigen::Isometry3d T_map_cam = (keyframe++)->second.T_map_cam;
    const auto& pdf = dynamic_cast<const CPose3DPDFGaussian&>(*entry.pose);
    EXPECT_TRUE((core::fromMrpt(pdf.mean) * core::T_sensor_cam()).isApprox(T_map_cam, 1e-9));
    EXPECT_NEAR(pdf.cov(0, 0), 0.02 * 0.02, 1e-12);
    const auto points = entry.sf->getObservationByClass<CObservation3DRangeScan>();
    ASSERT_TRUE(points);
    EXPECT_FALSE(points->hasIntensityImage);
    EXPECT_FALSE(points->hasRangeImage);
    ASSERT_EQ(points->points3D_x.size(), 54U * 40U) << "of 320 x 240 pixels every sixth";
    EXPECT_GT(points->points3D_x[1000], 1.0F) << "ahead";
    EXPECT_TRUE(entry.sf->getObservationByClass<mrpt::obs::CObservation2DRangeScan>());
    EXPECT_EQ(entry.sf->size(), 2U) << "what came with images before is not in it";
  }
}

TEST_F(SemanticMapBuilderTest, TheSimpleMapsImagesLieOutsideIfAskedFor) {
  const test::TemporaryFolder folder;
  builder_.configuration.builder.images = (folder.path() / "images").string();
  builder_.initialize();
  processUntil(2);
  mrpt::maps::CSimpleMap simple;
  builder_.getCurrentlyBuiltMap(simple);
  ASSERT_GE(simple.size(), 1U);
  const auto scan = simple.begin()->sf->getObservationByClass<CObservation3DRangeScan>();
  ASSERT_TRUE(scan->hasIntensityImage);
  EXPECT_TRUE(scan->intensityImage.isExternallyStored());
  EXPECT_TRUE(std::filesystem::exists(scan->intensityImage.getExternalStorageFileAbsolutePath()));
  ASSERT_TRUE(scan->hasRangeImage);
  ASSERT_TRUE(scan->rangeImage_isExternallyStored());
  EXPECT_TRUE(std::filesystem::exists(scan->rangeImage_getExternalStorageFileAbsolutePath("")));

  builder_.configuration.builder.images = folder.write("file", "").string() + "/below";
  EXPECT_THAT([&] { builder_.initialize(); }, ThrowsMessage<core::InputError>(HasSubstr("cannot be made")));
}

TEST_F(SemanticMapBuilderTest, BeginsWhereItIsTold) {
  const mrpt::poses::CPosePDFGaussian x0(mrpt::poses::CPose2D(3.0, -2.0, 1.0));
  builder_.initialize({}, &x0);
  EXPECT_NEAR(pose().mean.x(), 3.0, 1e-12);
  processUntil(4);
  expectAt(core::fromMrpt(mrpt::poses::CPose3D(3.0, -2.0, 0.0, 1.0, 0.0, 0.0)) * T_map_base(3), 0.006);
  builder_.clear();
  EXPECT_EQ(builder_.getCurrentlyBuiltMapSize(), 0U);
  processUntil(2);
  expectAt(T_map_base(1), 0.006);
}

/// As from one program to the next: over files.
TEST_F(SemanticMapBuilderTest, GoesOnInASimpleMapOfItsOwn) {
  const test::TemporaryFolder folder;
  builder_.configuration.builder.images = (folder.path() / "images").string();
  const mrpt::poses::CPosePDFGaussian x0(mrpt::poses::CPose2D(3.0, -2.0, 1.0));
  builder_.initialize({}, &x0);
  processUntil(20);
  builder_.finish();
  mrpt::maps::CSimpleMap simple;
  builder_.getCurrentlyBuiltMap(simple);
  ASSERT_TRUE(simple.saveToFile((folder.path() / "room.simplemap").string()));
  mrpt::maps::CSimpleMap read;
  ASSERT_TRUE(read.loadFromFile((folder.path() / "room.simplemap").string()));
  const Eigen::Isometry3d T_map_start = core::fromMrpt(mrpt::poses::CPose3D(3.0, -2.0, 0.0, 1.0, 0.0, 0.0));
  builder_.configuration.builder.images.clear();
  for (const bool updates : {true, false}) {
    builder_.enableMapUpdating(updates);
    builder_.initialize(read);
    EXPECT_GE(builder_.getCurrentlyBuiltMapSize(), 1U);
    for (int image = 4; image < 20; ++image) builder_.processObservation(scan(image));
    builder_.finish();
    EXPECT_EQ(builder_.trajectory().size(), 16U) << "recognised; map updating: " << updates;
    expectAt(T_map_start * T_map_base(19), 0.01);
  }
}

TEST_F(SemanticMapBuilderTest, CannotGoOnInASimpleMapWithoutImagesAndSaysInWhat) {
  mrpt::maps::CSimpleMap simple;
  simple.insert(mrpt::poses::CPose3DPDF::Ptr(CPose3DPDFGaussian::Create()), CSensoryFrame::Create());
  EXPECT_THAT([&] { builder_.initialize(simple); }, ThrowsMessage<core::InputError>(HasSubstr(".wardmap")));
}

TEST_F(SemanticMapBuilderTest, GoesOnInAWardmap) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "room.wardmap";
  std::size_t keyframes = 0;
  {
    storage::MapFileWriter writer(file, {});
    pipeline::SlamSystem slam(options());
    slam.writeTo(writer);
    for (int image = 0; image < 20; ++image) slam.process(scan(image));
    slam.finish();
    writer.finish(*slam.mapBuilder(), slam.mapper());
    keyframes = slam.semanticMap().keyframes.size();
  }
  for (const bool updates : {true, false}) {
    builder_.enableMapUpdating(updates);
    builder_.initialize(file);
    EXPECT_EQ(builder_.getCurrentlyBuiltMapSize(), keyframes);
    for (int image = 4; image < 20; ++image) builder_.processObservation(scan(image));
    builder_.finish();
    EXPECT_EQ(builder_.trajectory().size(), 16U) << "recognised; map updating: " << updates;
    expectAt(T_map_base(19), 0.006);
    mrpt::maps::CSimpleMap simple;
    builder_.getCurrentlyBuiltMap(simple);
    EXPECT_GE(simple.size(), updates ? keyframes : 1U);
  }
  EXPECT_THROW(builder_.initialize(folder.path() / "absent.wardmap"), core::InputError);
}

TEST_F(SemanticMapBuilderTest, WhatIsFinishedTakesNothingMoreUntilItBeginsAnew) {
  builder_.initialize();
  processUntil(3);
  builder_.finish();
  builder_.finish();
  EXPECT_THAT([&] { processUntil(1); }, ThrowsMessage<core::InputError>(HasSubstr("call initialize()")));
  builder_.initialize();
  processUntil(2);
  EXPECT_EQ(builder_.trajectory().size(), 2U);
}

TEST_F(SemanticMapBuilderTest, WithoutAMapThereIsNothingToSee) {
  EXPECT_EQ(builder_.getCurrentlyBuiltMapSize(), 0U);
  mrpt::maps::CSimpleMap simple;
  builder_.getCurrentlyBuiltMap(simple);
  EXPECT_TRUE(simple.empty());
  EXPECT_THROW(static_cast<void>(builder_.getCurrentlyBuiltMetricMap()), core::InputError);
  EXPECT_THROW(builder_.saveCurrentEstimationToImage("absent.png"), core::InputError);
}

TEST_F(SemanticMapBuilderTest, OfSeveralCamerasOneIsTracked) {
  builder_.initialize();
  for (int image = 0; image < 3; ++image) {
    auto other = coveredScan(image);
    other->sensorLabel = "OTHER";
    builder_.processObservation(scan(image));
    builder_.processObservation(other);
  }
  builder_.finish();
  EXPECT_EQ(builder_.trajectory().size(), 3U);
  builder_.configuration.builder.sensor_label = "ABSENT";
  builder_.initialize();
  processUntil(2);
  EXPECT_EQ(builder_.getCurrentlyBuiltMapSize(), 0U);
}

TEST_F(SemanticMapBuilderTest, DrawsWhereItIs) {
  const test::TemporaryFolder folder;
  builder_.initialize();
  processUntil(3);
  builder_.saveCurrentEstimationToImage((folder.path() / "now").string());
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "now.png"));
}

TEST_F(SemanticMapBuilderTest, MayBeAskedByAnotherThreadMeanwhile) {
  builder_.configuration.slam.deterministic = false;
  builder_.initialize();
  auto asking = std::async(std::launch::async, [this] {
    std::size_t most = 0;
    for (int i = 0; i < 10; ++i) {
      static_cast<void>(pose());
      mrpt::maps::CSimpleMap simple;
      builder_.getCurrentlyBuiltMap(simple);
      most = std::max(most, simple.size());
      std::this_thread::yield();
    }
    return most;
  });
  processUntil(12);
  EXPECT_LE(asking.get(), builder_.getCurrentlyBuiltMapSize());
  builder_.finish();
  EXPECT_EQ(builder_.trajectory().size(), 12U);
}

TEST_F(SemanticMapBuilderTest, IsConfiguredByAnIniFile) {
  mrpt::config::CConfigFileMemory ini;
  ini.setContent(
      "[MappingApplication]\nrawlog_file = ward.rawlog\npoints_px = 8\n[WardSLAM]\nfeatures.key_points = 700\n");
  builder_.loadFromConfigFile(ini, "MappingApplication", {"rawlog_file"});
  EXPECT_EQ(builder_.configuration.builder.points_px, 8);
  EXPECT_EQ(builder_.configuration.slam.features.key_points, 700);
}

}  // namespace
}  // namespace wardslam::mrpt_slam
