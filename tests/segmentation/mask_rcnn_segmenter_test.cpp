#include "wardslam/segmentation/mask_rcnn_segmenter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "segmentation/fake_network.h"
#include "segmentation/tensorflow_writer.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

using core::InputError;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

/// One person who fills the left half of the image.
class MaskRcnnSegmenterTest : public ::testing::Test {
 protected:
  MaskRcnnSegmenterTest() {
    cv::Mat detections = test::tensor({1, 1, 2, 7});
    const float person[] = {0.0F, 0.0F, 0.9F, 0.0F, 0.0F, 0.5F, 1.0F};
    std::copy(person, person + 7, detections.ptr<float>());
    cv::Mat masks = test::tensor({2, 90, 15, 15});
    cv::Mat(15, 15, CV_32F, masks.ptr<float>(0, 0)).setTo(1.0F);
    state_.outputs = {detections, masks};
  }

  [[nodiscard]] MaskRcnnSegmenter open(const MaskRcnnOptions& options = {}, const std::string& classes = {}) {
    NetworkSource source;
    source.model = "net.pb";
    return {options, OpenedNetwork{std::make_unique<test::FakeNetwork>(state_), {}}, source, classes};
  }

  test::FakeNetworkState state_;
  test::TemporaryFolder folder_;
  cv::Mat image_{48, 64, CV_8UC3, cv::Scalar(10, 20, 30)};
};

TEST_F(MaskRcnnSegmenterTest, TurnsTensorsIntoASegmentation) {
  auto segmenter = open();
  const auto [segmentation, events] = segmenter.segment({image_, 0.0});
  EXPECT_TRUE(events.empty());
  EXPECT_EQ(segmentation.classIds.size(), image_.size());
  EXPECT_EQ(cv::countNonZero(segmentation.classIds(cv::Rect(0, 0, 32, 48)) == 1), 32 * 48);
  EXPECT_EQ(cv::countNonZero(segmentation.classIds(cv::Rect(32, 0, 32, 48))), 0);
  EXPECT_EQ(segmenter.labelSpace().name(1), "person");
}

TEST_F(MaskRcnnSegmenterTest, FeedsTheImageInRgbFrom0To255) {
  (void)open().segment({image_, 0.0});
  EXPECT_EQ(shapeOf(state_.lastBlob), (std::vector<int>{1, 3, 48, 64}));
  EXPECT_EQ(test::blobAt(state_.lastBlob, 0, 5, 5), 30.0F);
  EXPECT_EQ(test::blobAt(state_.lastBlob, 2, 5, 5), 10.0F);
}

TEST_F(MaskRcnnSegmenterTest, ScalesTheImageWhereAskedTo) {
  MaskRcnnOptions options;
  options.input_width_px = 40;
  options.input_height_px = 20;
  const auto result = open(options).segment({image_, 0.0});
  EXPECT_EQ(shapeOf(state_.lastBlob), (std::vector<int>{1, 3, 20, 40}));
  EXPECT_EQ(result.segmentation.classIds.size(), image_.size());
}

TEST_F(MaskRcnnSegmenterTest, CountsImagesItCannotDo) {
  auto segmenter = open();
  const auto expectFailed = [&](const cv::Mat& image) {
    const auto result = segmenter.segment({image, 0.0});
    EXPECT_TRUE(result.segmentation.empty());
    EXPECT_EQ(result.events.count("segmentation.network_failed"), 1U);
  };
  expectFailed({});
  state_.fails = true;
  expectFailed(image_);
  state_.fails = false;
  state_.outputs.pop_back();
  expectFailed(image_);
}

TEST_F(MaskRcnnSegmenterTest, RefusesANetworkOfAnotherKind) {
  state_.outputs = {test::tensor({1, 116, 50}), test::tensor({1, 32, 8, 8})};
  EXPECT_THAT([&] { (void)open(); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("net.pb"), HasSubstr("[1,116,50], [1,32,8,8]"))));
  state_.fails = true;
  EXPECT_THAT([&] { (void)open(); }, ThrowsMessage<InputError>(HasSubstr("net.pb: is out of order")));
}

TEST_F(MaskRcnnSegmenterTest, TakesOtherClassesFromALabelFile) {
  state_.outputs[1] = state_.outputs[1].clone().reshape(1, {6, 30, 15, 15});
  EXPECT_THAT([&] { (void)open(); }, ThrowsMessage<InputError>(HasSubstr("knows 30 classes")));
  const auto labels = folder_.write("net.yaml", "names: {100: trolley}\nclasses: {0: trolley}\n");
  auto segmenter = open({}, labels.string());
  EXPECT_EQ(segmenter.segment({image_, 0.0}).segmentation.classIds.at<core::ClassId>(1, 1), 100);
  EXPECT_EQ(segmenter.labelSpace().name(100), "trolley");
}

// The same way a real frozen graph takes: two outputs by name, through cv::dnn.
TEST_F(MaskRcnnSegmenterTest, LoadsFrozenGraphs) {
  test::TensorFlowWriter graph;
  graph.addNode("Placeholder", "image_tensor", {});
  graph.addNode("Relu", "detection_out_final", {"image_tensor"});
  graph.addNode("Relu", "detection_masks", {"detection_out_final"});
  MaskRcnnOptions options;
  options.model = folder_.write("relu.pb", graph.graph()).string();
  EXPECT_THAT([&] { MaskRcnnSegmenter segmenter(options); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("relu.pb: its outputs [1,3,240,320], [1,3,240,320]"),
                                              HasSubstr("mask_rcnn.graph"), Not(HasSubstr("\n")))));
}

TEST_F(MaskRcnnSegmenterTest, RefusesBadFiles) {
  const auto refuses = [](const std::string& model, const std::string& graph, const std::string& part) {
    MaskRcnnOptions options;
    options.model = model;
    options.graph = graph;
    EXPECT_THAT([&] { MaskRcnnSegmenter segmenter(options); },
                ThrowsMessage<InputError>(AllOf(HasSubstr(part), Not(HasSubstr("\n")))));
  };
  refuses("", "", "mask_rcnn.model");
  refuses("/no/such.pb", "", "/no/such.pb: cannot be opened");
  const auto text = folder_.write("text.pb", "this is no graph").string();
  refuses(text, "", "not a complete TensorFlow graph");
  refuses(text, "/no/such.pbtxt", "/no/such.pbtxt: cannot be opened");
  test::TensorFlowWriter graph;
  graph.addNode("Placeholder", "image_tensor", {});
  graph.addNode("Relu", "detection_out_final", {"image_tensor"});
  refuses(folder_.write("half.pb", graph.graph()).string(), "", "no output 'detection_masks'");
}

}  // namespace
}  // namespace wardslam::segmentation
