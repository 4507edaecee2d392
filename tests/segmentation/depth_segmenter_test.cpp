#include "wardslam/segmentation/depth_segmenter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "segmentation/fake_network.h"
#include "segmentation/onnx_writer.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;
using core::InputError;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr core::ClassId kPerson = 1;
constexpr core::ClassId kChair = 57;

/// A network that sees a person in the left half and a chair in the right one, whatever is there.
class DepthSegmenterTest : public ::testing::Test {
 protected:
  DepthSegmenterTest() {
    classes_ = folder_.write("net.yaml", "classes: [~, person, chair]\n");
    source_.model = folder_.path() / "net.onnx";
    cv::Mat scores = test::tensor({1, 3, 24, 32});
    cv::Mat(24, 32, CV_32F, scores.ptr<float>(0, 1)).colRange(0, 16).setTo(std::log(8.0));  // 8 of 10
    cv::Mat(24, 32, CV_32F, scores.ptr<float>(0, 2)).colRange(16, 32).setTo(std::log(8.0));
    state_.outputs = {scores};
  }
  [[nodiscard]] DepthSegmenter open(const fs::path& classes = {}) {
    return {{}, {std::make_unique<test::FakeNetwork>(state_), {64, 48}}, source_, classes};
  }
  [[nodiscard]] SegmenterInput input(double depth_m = 2.0) const {
    core::CameraModel camera;
    camera.width_px = 128;
    camera.height_px = 96;
    return {cv::Mat(96, 128, CV_8UC3, cv::Scalar::all(0)), 0.0, cv::Mat(96, 128, CV_32FC1, cv::Scalar(depth_m)),
            camera};
  }

  test::TemporaryFolder folder_;
  fs::path classes_;
  NetworkSource source_;
  test::FakeNetworkState state_;
};

TEST_F(DepthSegmenterTest, GivesMasksOfTheSizeOfTheImage) {
  DepthSegmenter segmenter = open();
  EXPECT_EQ(segmenter.labelSpace().name(kChair), "chair");
  const auto [segmentation, events] = segmenter.segment(input());
  EXPECT_TRUE(events.empty());
  ASSERT_EQ(segmentation.classIds.size(), cv::Size(128, 96));
  EXPECT_EQ(segmentation.classIds.at<core::ClassId>(48, 20), kPerson);
  EXPECT_EQ(segmentation.classIds.at<core::ClassId>(48, 100), kChair);
  ASSERT_EQ(segmentation.instances.size(), 2U);
  EXPECT_EQ(segmentation.instances[0].classId, kPerson);
  EXPECT_EQ(segmentation.instances[0].box_px.tl(), cv::Point(0, 0));
  EXPECT_NEAR(segmentation.instances[0].confidence, 0.8, 0.02);
  EXPECT_NEAR(segmentation.instances[1].confidence, 0.8, 0.02);
}

TEST_F(DepthSegmenterTest, ShowsTheNetworkDepthAlone) {
  DepthSegmenter segmenter = open();
  (void)segmenter.segment(input());
  ASSERT_EQ(shapeOf(state_.lastBlob), (std::vector<int>{1, 6, 48, 64}));
  EXPECT_EQ(test::blobAt(state_.lastBlob, 0, 24, 32), 0.5F) << "1/2 m";
}

TEST_F(DepthSegmenterTest, SaysSoWhereThereIsNoDepth) {
  DepthSegmenter segmenter = open();
  SegmenterInput none = input();
  none.depth_m = cv::Mat();
  SegmenterInput other = input();
  other.depth_m = cv::Mat(48, 64, CV_32FC1, cv::Scalar(2.0));
  SegmenterInput little = input(0.0);
  little.depth_m(cv::Rect(0, 0, 20, 20)).setTo(2.0F);
  for (const SegmenterInput& dark : {none, other, little, input(0.0), SegmenterInput{}}) {
    const auto result = segmenter.segment(dark);
    EXPECT_TRUE(result.segmentation.empty());
    EXPECT_EQ(result.events, (core::EventCounts{{"segmentation.no_depth", 1}}));
  }
}

TEST_F(DepthSegmenterTest, GoesOnWhereTheNetworkFails) {
  DepthSegmenter segmenter = open();
  state_.fails = true;
  EXPECT_EQ(segmenter.segment(input()).events, (core::EventCounts{{"segmentation.network_failed", 1}}));
  state_.fails = false;
  state_.outputs = {test::tensor({1, 3, 1, 1})};
  EXPECT_EQ(segmenter.segment(input()).events, (core::EventCounts{{"segmentation.network_failed", 1}}));
}

TEST_F(DepthSegmenterTest, RefusesWhatIsNoDepthNetwork) {
  fs::remove(classes_);
  EXPECT_THAT([&] { (void)open(); }, ThrowsMessage<InputError>(AllOf(HasSubstr("net.yaml"), HasSubstr("label file"))));
  const auto two = folder_.write("two.yaml", "classes: [~, person]\n");
  EXPECT_THAT([&] { (void)open(two); }, ThrowsMessage<InputError>(HasSubstr("knows 3 classes")));
  state_.outputs = {test::tensor({1, 3})};
  EXPECT_THAT([&] { (void)open(two); }, ThrowsMessage<InputError>(HasSubstr("not those of a depth network")));

  test::OnnxWriter onnx;
  onnx.addInput("image", {1, 3, 48, 64});
  onnx.addNode("Relu", "relu", {"image"}, "scores");
  onnx.addOutput("scores");
  DepthOptions color;
  color.model = folder_.write("color.onnx", onnx.model()).string();
  EXPECT_THAT([&] { DepthSegmenter segmenter(color); }, ThrowsMessage<InputError>(HasSubstr("no image of 6 channels")));
  color.model = "/no/such/model.onnx";
  EXPECT_THAT([&] { DepthSegmenter segmenter(color); }, ThrowsMessage<InputError>(HasSubstr("/no/such/model.onnx")));
}

/// Of people's pixels in real images, this network finds so many, and of what it calls people so many are.
TEST(TheDepthNetwork, FindsPeople) {
  const fs::path sequence = fs::path(WARDSLAM_SHARED_DIR) / "data" / "ward_walking";
  if (!fs::exists(sequence)) GTEST_SKIP() << "not here: " << sequence;
  std::vector<fs::path> masks;
  for (const auto& file : fs::directory_iterator(sequence / "masks")) masks.push_back(file.path());
  std::sort(masks.begin(), masks.end());
  DepthSegmenter segmenter(DepthOptions{});
  double hits = 0.0;
  double people = 0.0;
  double found = 0.0;
  for (std::size_t i = 0; i < masks.size(); i += masks.size() / 8) {
    const cv::Mat truth = cv::imread(masks[i].string(), cv::IMREAD_UNCHANGED) == kPerson;
    const auto depthFile = sequence / "depth" / masks[i].filename();
    const cv::Mat raw = cv::imread(depthFile.string(), cv::IMREAD_UNCHANGED);
    ASSERT_FALSE(raw.empty()) << depthFile;
    SegmenterInput input{cv::Mat(raw.size(), CV_8UC3, cv::Scalar::all(0)), 0.0};
    raw.convertTo(input.depth_m, CV_32F, 1.0 / 5000.0);
    const cv::Mat seen = segmenter.segment(input).segmentation.classIds == kPerson;
    hits += cv::countNonZero(seen & truth);
    people += cv::countNonZero(truth);
    found += cv::countNonZero(seen);
  }
  ASSERT_GT(people, 0.0);
  std::printf("people: recall %.3f, precision %.3f\n", hits / people, hits / found);
  EXPECT_GT(hits / people, 0.85);
  EXPECT_GT(hits / found, 0.85);
}

}  // namespace
}  // namespace wardslam::segmentation
