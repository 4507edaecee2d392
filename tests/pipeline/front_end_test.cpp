#include "wardslam/pipeline/front_end.h"

#include <gtest/gtest.h>

#include <memory>
#include <opencv2/imgproc.hpp>
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

}  // namespace
}  // namespace wardslam::pipeline
