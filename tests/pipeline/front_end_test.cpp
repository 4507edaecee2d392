#include "wardslam/pipeline/front_end.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "support/textured_room_scan.h"
#include "wardslam/core/errors.h"

namespace wardslam::test {

/// Marks what is nearer than 1.2 m, as if there were a mask of it.
class NearFilter : public filters::ObservationFilter {
  DEFINE_MRPT_OBJECT(NearFilter, wardslam::test)

 public:
  void initialize(const core::ConfigNode&, const filters::FilterContext&) override {}
  void apply(core::Frame& frame) override {
    core::addDynamic(frame, (frame.depth_m > 0) & (frame.depth_m < 1.2));
    for (auto& keypoint : frame.features.keypoints) {
      if (keypoint.hasDepth() && keypoint.depth_m < 1.2F) keypoint.motion = core::Motion::Dynamic;
    }
  }
  [[nodiscard]] std::string parameters(int) const override { return {}; }
};

IMPLEMENTS_MRPT_OBJECT(NearFilter, filters::ObservationFilter, wardslam::test)

/// What a network does that takes all that it sees for one person.
class EverybodyFilter : public filters::ObservationFilter {
  DEFINE_MRPT_OBJECT(EverybodyFilter, wardslam::test)

 public:
  void initialize(const core::ConfigNode&, const filters::FilterContext&) override {}
  void apply(core::Frame& frame) override {
    if (frame.index < kTroubleBegins || frame.index >= kTroubleEnds) return;
    core::addDynamic(frame, cv::Mat(frame.gray.size(), CV_8UC1, cv::Scalar(255)));
    for (auto& keypoint : frame.features.keypoints) keypoint.motion = core::Motion::Dynamic;
  }
  [[nodiscard]] std::string parameters(int) const override { return {}; }

  static constexpr std::uint64_t kTroubleBegins = 10;
  static constexpr std::uint64_t kTroubleEnds = 30;
};

IMPLEMENTS_MRPT_OBJECT(EverybodyFilter, filters::ObservationFilter, wardslam::test)

}  // namespace wardslam::test

namespace wardslam::pipeline {
namespace {

SlamOptions withoutFilters() {
  SlamOptions options;
  options.filters = SlamOptions::noFilters();
  return options;
}

TEST(FrontEnd, TracksWithoutAMap) {
  const test::TexturedRoom room;
  SlamOptions options = withoutFilters();
  options.map_frame.start_pose = "0 0 0 0 0 0 1";
  FrontEnd frontEnd(options);
  FrontEnd::Result result;
  for (int image = 0; image < 5; ++image) result = frontEnd.process(test::observe(room, image));
  EXPECT_EQ(result.frame.index, 4U);
  EXPECT_GT(result.frame.features.size(), 100U);
  ASSERT_TRUE(result.odometry.hasPose());
  const Eigen::Isometry3d T_first_last =
      test::TexturedRoom::T_room_cam(0).inverse() * test::TexturedRoom::T_room_cam(4);
  EXPECT_LT((result.odometry.T_map_cam.translation() - T_first_last.translation()).norm(), 0.01);
}

/// The room with a board 1 m ahead that goes to the right, its depth at full or at half the size of the image.
mrpt::obs::CObservation3DRangeScan::Ptr observeBoard(const test::TexturedRoom& room, int image, bool isHalf) {
  auto scan = test::observe(room, image);
  const cv::Rect board(100 + 5 * image, 60, 80, 120);
  cv::Mat texture(board.height / 4, board.width / 4, CV_8UC3);
  cv::RNG(7).fill(texture, cv::RNG::UNIFORM, 0, 256);
  cv::Mat color = scan->intensityImage.asCvMatRef();
  cv::resize(texture, color(board), board.size(), 0, 0, cv::INTER_CUBIC);
  cv::Mat depth(color.size(), CV_16UC1, scan->rangeImage.data());
  depth(board).setTo(5000);
  if (!isHalf) return scan;
  cv::Mat half;
  cv::resize(depth, half, {}, 0.5, 0.5, cv::INTER_NEAREST);
  scan->rangeImage_setSize(half.rows, half.cols);
  half.copyTo(cv::Mat(half.size(), CV_16UC1, scan->rangeImage.data()));
  scan->cameraParams.scaleToResolution(static_cast<unsigned>(half.cols), static_cast<unsigned>(half.rows));
  return scan;
}

/// Eight images of the board, filtered by its mask and by geometry behind it.
std::vector<FrontEnd::Result> watchBoard(bool annotate, bool isHalf) {
  mrpt::rtti::registerClass(CLASS_ID(test::NearFilter));
  SlamOptions options;
  options.annotate = annotate;
  options.filters = core::ConfigNode::fromText(
      "[{class_name: 'wardslam::test::NearFilter'}, {class_name: 'wardslam::filters::GeometricMotionFilter'}]");
  FrontEnd frontEnd(options);
  const test::TexturedRoom room;
  std::vector<FrontEnd::Result> results;
  for (int image = 0; image < 8; ++image) results.push_back(frontEnd.process(observeBoard(room, image, isHalf)));
  return results;
}

void expectSameMarksAndPoses(const std::vector<FrontEnd::Result>& a, const std::vector<FrontEnd::Result>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].frame.features.size(), b[i].frame.features.size());
    for (std::size_t k = 0; k < a[i].frame.features.size(); ++k) {
      ASSERT_EQ(a[i].frame.features.keypoints[k].motion, b[i].frame.features.keypoints[k].motion) << i;
    }
    EXPECT_EQ(a[i].odometry.T_map_cam.matrix(), b[i].odometry.T_map_cam.matrix()) << i;
    EXPECT_EQ(cv::countNonZero(a[i].frame.labelBits != b[i].frame.labelBits), 0) << i;
  }
}

TEST(FrontEnd, AnnotatesOnlyWhenAskedAndTracksTheSame) {
  const auto annotated = watchBoard(true, false);
  const auto plain = watchBoard(false, false);
  EXPECT_TRUE(annotated.back().frame.observation->hasPixelLabels());
  EXPECT_FALSE(plain.back().frame.observation->hasPixelLabels());
  expectSameMarksAndPoses(annotated, plain);
}

TEST(FrontEnd, TracksTheSameWhereTheRangeImageHasAnotherSize) {
  const auto annotated = watchBoard(true, true);
  const auto& last = annotated.back().frame;
  EXPECT_FALSE(last.observation->hasPixelLabels());
  EXPECT_EQ(last.events.at("filters.annotation_size"), 1U);
  EXPECT_GT(cv::countNonZero(core::dynamicPixels(last)), 0);
  expectSameMarksAndPoses(annotated, watchBoard(false, true));
}

TEST(FrontEnd, KnowsWhoMovesWithoutASegmenter) {
  const FrontEnd frontEnd(withoutFilters());
  EXPECT_TRUE(frontEnd.movers()[1]);    // person
  EXPECT_FALSE(frontEnd.movers()[57]);  // chair
  EXPECT_EQ(frontEnd.labelSpace().name(1), "person");
}

TEST(FrontEnd, RefusesAStartPoseThatIsNone) {
  SlamOptions options = withoutFilters();
  options.map_frame.start_pose = "somewhere";
  EXPECT_THROW(FrontEnd{options}, core::InputError);
}

// Trouble with the camera from the tenth image on, for twenty images: a bit more than half a second.

class CameraTrouble : public ::testing::Test {
 protected:
  using Scan = mrpt::obs::CObservation3DRangeScan;
  static constexpr int kBegins = static_cast<int>(test::EverybodyFilter::kTroubleBegins);
  static constexpr int kEnds = static_cast<int>(test::EverybodyFilter::kTroubleEnds);
  static constexpr int kImages = kEnds + 10;

  struct Outcome {
    core::EventCounts events;
    int lost = 0;               ///< Images whose pose nobody claims to know.
    int elsewhere = 0;          ///< Images whose pose is told to be in no relation to those before.
    int surelyWrong = 0;        ///< Images with a pose that is off by more than it says, and by more than 3 cm.
    bool isFoundAgain = false;  ///< The last image has its pose.
  };

  /// `spoil` changes what the camera delivers while there is trouble; images it makes nothing of do not come.
  template <class Spoil>
  Outcome track(const Spoil& spoil, const std::string& filters = "[]") const {
    SlamOptions options = withoutFilters();
    options.map_frame.start_pose = "0 0 0 0 0 0 1";
    options.filters = core::ConfigNode::fromText(filters);
    FrontEnd frontEnd(options);
    Outcome outcome;
    for (int image = 0; image < kImages; ++image) {
      auto scan = test::observe(room_, image);
      if (image >= kBegins && image < kEnds) scan = spoil(scan, image);
      if (!scan) continue;
      const auto [frame, odometry] = frontEnd.process(scan);
      for (const auto& [event, count] : frame.events) outcome.events[event] += count;
      outcome.isFoundAgain = isRight(odometry, image);
      outcome.lost += odometry.hasPose() ? 0 : 1;
      outcome.elsewhere += odometry.hasPose() && !odometry.isInMap ? 1 : 0;
      outcome.surelyWrong += odometry.hasPose() && odometry.isInMap && !isRight(odometry, image) ? 1 : 0;
    }
    return outcome;
  }

  static bool isRight(const odometry::OdometryResult& odometry, int image) {
    const double off_m =
        (odometry.T_map_cam.translation() - test::TexturedRoom::T_room_cam(image).translation()).norm();
    const double sigma_m = odometry.covariance ? std::sqrt(odometry.covariance->topLeftCorner<3, 3>().trace()) : 0.0;
    return odometry.hasPose() && off_m < std::max(0.03, 4 * sigma_m);
  }

  static auto colored(int gray) {
    return [gray](const Scan::Ptr& scan, int /*image*/) {
      scan->intensityImage = mrpt::img::CImage(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(gray)), mrpt::img::DEEP_COPY);
      return scan;
    };
  }
  static auto withDepth(int units) {
    return [units](const Scan::Ptr& scan, int /*image*/) {
      scan->rangeImage.fill(static_cast<std::uint16_t>(units));
      return scan;
    };
  }

  const test::TexturedRoom room_;
};

TEST_F(CameraTrouble, BlackAndWhiteImages) {
  for (const int gray : {0, 255}) {
    const auto outcome = track(colored(gray));
    EXPECT_EQ(outcome.surelyWrong, 0) << gray;
    EXPECT_TRUE(outcome.isFoundAgain) << gray;
    EXPECT_EQ(outcome.events.at("sources.image_repeated"), 19U);
  }
}

TEST_F(CameraTrouble, DepthOfZeroAndSaturated) {
  for (const int units : {0, 65535}) {
    const auto outcome = track(withDepth(units));
    EXPECT_EQ(outcome.surelyWrong, 0) << units;
    EXPECT_TRUE(outcome.isFoundAgain) << units;
  }
}

TEST_F(CameraTrouble, DepthThatStandsStillWhileColoursGoOn) {
  const auto still = test::observe(room_, kBegins);
  const auto outcome = track([&](const Scan::Ptr& scan, int /*image*/) {
    scan->rangeImage = still->rangeImage;
    return scan;
  });
  EXPECT_EQ(outcome.surelyWrong, 0);
  EXPECT_TRUE(outcome.isFoundAgain);
  EXPECT_EQ(outcome.events, (core::EventCounts{{"sources.depth_still", 18}})) << "but for the first two";
}

TEST_F(CameraTrouble, AFrozenImageIsCounted) {
  const auto frozen = test::observe(room_, kBegins);
  const auto outcome = track([&](const Scan::Ptr& scan, int /*image*/) {
    scan->intensityImage = frozen->intensityImage;
    scan->rangeImage = frozen->rangeImage;
    return scan;
  });
  EXPECT_TRUE(outcome.isFoundAgain);
  EXPECT_EQ(outcome.events, (core::EventCounts{{"sources.image_repeated", 19}})) << "nobody can tell it from rest";
}

TEST_F(CameraTrouble, AStall) {
  const auto outcome = track([](const Scan::Ptr& /*scan*/, int /*image*/) { return Scan::Ptr(); });
  EXPECT_EQ(outcome.surelyWrong, 0);
  EXPECT_TRUE(outcome.isFoundAgain);
}

TEST_F(CameraTrouble, AClockThatIsSetAnHourOnAndBackAgain) {
  const auto outcome = track([](const Scan::Ptr& scan, int /*image*/) {
    scan->timestamp += std::chrono::hours(1);
    return scan;
  });
  EXPECT_EQ(outcome.surelyWrong, 0);
  EXPECT_TRUE(outcome.isFoundAgain);
}

TEST_F(CameraTrouble, AClockThatStandsStill) {
  const auto first = test::observe(room_, kBegins);
  const auto outcome = track([&](const Scan::Ptr& scan, int /*image*/) {
    scan->timestamp = first->timestamp;
    return scan;
  });
  EXPECT_EQ(outcome.surelyWrong, 0);
  EXPECT_TRUE(outcome.isFoundAgain);
}

TEST_F(CameraTrouble, ANetworkThatTakesAllForOnePerson) {
  mrpt::rtti::registerClass(CLASS_ID(test::EverybodyFilter));
  const auto outcome = track([](const Scan::Ptr& scan, int /*image*/) { return scan; },
                             "[{class_name: 'wardslam::test::EverybodyFilter'}]");
  EXPECT_EQ(outcome.lost, kEnds - kBegins);
  EXPECT_EQ(outcome.surelyWrong, 0);
  EXPECT_TRUE(outcome.isFoundAgain || outcome.elsewhere == kImages - kEnds) << "begun anew, and said so";
}

}  // namespace
}  // namespace wardslam::pipeline
