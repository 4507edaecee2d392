#include "wardslam/segmentation/semantic_segmenter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "segmentation/fake_network.h"
#include "segmentation/onnx_writer.h"
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
using Normalisation = SemanticOptions::Normalisation;

/// Networks whose classes are the colours: red is a person, green a chair, blue nothing.
class SemanticSegmenterTest : public ::testing::Test {
 protected:
  SemanticSegmenterTest() {
    classes_ = folder_.write("colours.yaml", "classes: [person, chair, ~]\n");
    image_.setTo(cv::Scalar(255, 0, 0));
    image_(cv::Rect(0, 0, 32, 24)).setTo(cv::Scalar(0, 0, 255));
    image_(cv::Rect(40, 8, 16, 32)).setTo(cv::Scalar(0, 255, 0));
    options_.normalisation = Normalisation::ZeroToOne;
  }

  /// 64x48, scores as they come.
  [[nodiscard]] SemanticOptions scoresNetwork(const std::vector<std::uint64_t>& shape = {1, 3, 48, 64}) const {
    test::OnnxWriter onnx;
    onnx.addInput("image", shape);
    onnx.addNode("Relu", "relu", {"image"}, "scores");
    onnx.addOutput("scores");
    SemanticOptions options = options_;
    options.model = folder_.write("scores.onnx", onnx.model()).string();
    return options;
  }

  void expectColours(const core::Segmentation& segmentation) const {
    EXPECT_EQ(cv::countNonZero(segmentation.classIds), 32 * 24 + 16 * 32);
    EXPECT_EQ(cv::countNonZero(segmentation.classIds(cv::Rect(0, 0, 32, 24)) == 1), 32 * 24);
    EXPECT_EQ(cv::countNonZero(segmentation.classIds(cv::Rect(40, 8, 16, 32)) == 57), 16 * 32);
    ASSERT_EQ(segmentation.instances.size(), 2U);
    EXPECT_EQ(segmentation.instances[0].box_px, cv::Rect(0, 0, 32, 24));
    EXPECT_EQ(segmentation.instances[1].box_px, cv::Rect(40, 8, 16, 32));
  }

  test::TemporaryFolder folder_;
  std::filesystem::path classes_;
  SemanticOptions options_;
  cv::Mat image_ = cv::Mat(48, 64, CV_8UC3);
};

TEST_F(SemanticSegmenterTest, RunsANetworkOfScores) {
  SemanticSegmenter segmenter(scoresNetwork(), classes_);
  EXPECT_EQ(segmenter.inputSize_px(), cv::Size(64, 48));
  const auto [segmentation, events] = segmenter.segment({image_, 0.0});
  EXPECT_TRUE(events.empty());
  expectColours(segmentation);
}

TEST_F(SemanticSegmenterTest, RunsANetworkOfClassNumbers) {
  test::OnnxWriter onnx;
  onnx.addInput("image", {1, 3, 48, 64});
  onnx.addNode("ArgMax", "best", {"image"}, "classes", {{"axis", 1}, {"keepdims", 1}});
  onnx.addOutput("classes", test::OnnxWriter::ElementType::Int64);
  options_.model = folder_.write("classes.onnx", onnx.model()).string();
  SemanticSegmenter segmenter(options_, classes_);
  expectColours(segmenter.segment({image_, 0.0}).segmentation);
  EXPECT_THAT([&] { SemanticSegmenter nameless(options_); },
              ThrowsMessage<InputError>(HasSubstr("classes.onnx: puts out class numbers")));
}

TEST_F(SemanticSegmenterTest, RunsAFrozenGraph) {
  test::TensorFlowWriter graph;
  graph.addNode("Placeholder", "image", {});
  graph.addNode("Relu", "scores", {"image"});
  options_.model = folder_.write("scores.pb", graph.graph()).string();
  EXPECT_THAT([&] { SemanticSegmenter segmenter(options_, classes_); },
              ThrowsMessage<InputError>(HasSubstr("set semantic.input_width")));
  options_.input_width_px = 64;
  options_.input_height_px = 48;
  SemanticSegmenter segmenter(options_, classes_);
  expectColours(segmenter.segment({image_, 0.0}).segmentation);
}

TEST_F(SemanticSegmenterTest, LetsTheUserChooseAnOpenInputSize) {
  auto options = scoresNetwork({1, 3, 0, 0});
  EXPECT_THAT([&] { SemanticSegmenter segmenter(options, classes_); },
              ThrowsMessage<InputError>(HasSubstr("semantic.input_width")));
  options.input_width_px = 128;
  options.input_height_px = 128;  // letterboxed: 128x96
  SemanticSegmenter segmenter(options, classes_);
  const auto segmentation = segmenter.segment({image_, 0.0}).segmentation;
  EXPECT_EQ(segmentation.classIds.size(), image_.size());
  EXPECT_EQ(segmentation.classIds.at<core::ClassId>(12, 16), 1);
  EXPECT_EQ(segmentation.classIds.at<core::ClassId>(24, 48), 57);
  EXPECT_EQ(segmentation.classIds.at<core::ClassId>(44, 4), 0);
}

TEST_F(SemanticSegmenterTest, UsesTheOutputAskedFor) {
  test::OnnxWriter onnx;
  onnx.addInput("image", {1, 3, 48, 64});
  onnx.addConstant("minus", {1}, {-1.0F});
  onnx.addNode("Mul", "negate", {"image", "minus"}, "aux");
  onnx.addNode("Relu", "relu", {"image"}, "out");
  onnx.addOutput("aux");
  onnx.addOutput("out");
  options_.model = folder_.write("two.onnx", onnx.model()).string();
  options_.output = "out";
  SemanticSegmenter segmenter(options_, classes_);
  expectColours(segmenter.segment({image_, 0.0}).segmentation);
  options_.output = "nothing";
  EXPECT_THAT([&] { SemanticSegmenter other(options_, classes_); },
              ThrowsMessage<InputError>(HasSubstr("has no output 'nothing'")));
}

TEST_F(SemanticSegmenterTest, RefusesWhatDoesNotFit) {
  EXPECT_THAT([&] { SemanticSegmenter segmenter(scoresNetwork()); },
              ThrowsMessage<InputError>(HasSubstr("knows 3 classes")));
  EXPECT_THAT([&] { SemanticSegmenter segmenter(scoresNetwork(), "labels/voc21.yaml"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("knows 3 classes"), HasSubstr("lists 21"))));
  EXPECT_THAT([] { SemanticSegmenter segmenter(SemanticOptions{}); },
              ThrowsMessage<InputError>(HasSubstr("semantic.model")));

  test::FakeNetworkState state;
  state.outputs = {test::tensor({1, 1000})};
  NetworkSource source;
  source.model = "classifier.onnx";
  EXPECT_THAT(
      [&] {
        SemanticSegmenter segmenter(options_, {std::make_unique<test::FakeNetwork>(state), {64, 48}}, source, classes_);
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("classifier.onnx: its outputs [1,1000]"), Not(HasSubstr("\n")))));
}

TEST_F(SemanticSegmenterTest, CountsImagesItCannotDo) {
  test::FakeNetworkState state;
  state.outputs = {test::tensor({1, 3, 48, 64})};
  SemanticSegmenter segmenter(options_, {std::make_unique<test::FakeNetwork>(state), {64, 48}}, {}, classes_);
  state.fails = true;
  for (const auto& image : {image_, cv::Mat()}) {
    const auto result = segmenter.segment({image, 0.0});
    EXPECT_TRUE(result.segmentation.empty());
    EXPECT_EQ(result.events.count("segmentation.network_failed"), 1U);
  }
}

TEST(Normalised, GivesTheNumbersNetworksAreTrainedWith) {
  const cv::Mat image(2, 2, CV_8UC3, cv::Scalar(51, 102, 204));  // blue 0.2, green 0.4, red 0.8
  const auto expectRgb = [&](Normalisation normalisation, double red, double green, double blue) {
    const cv::Mat blob = normalised(image, normalisation);
    EXPECT_EQ(shapeOf(blob), (std::vector<int>{1, 3, 2, 2}));
    EXPECT_NEAR(test::blobAt(blob, 0, 1, 1), red, 1e-5);
    EXPECT_NEAR(test::blobAt(blob, 1, 1, 1), green, 1e-5);
    EXPECT_NEAR(test::blobAt(blob, 2, 1, 1), blue, 1e-5);
  };
  expectRgb(Normalisation::None, 204, 102, 51);
  expectRgb(Normalisation::ZeroToOne, 0.8, 0.4, 0.2);
  expectRgb(Normalisation::MinusOneToOne, 0.6, -0.2, -0.6);
  expectRgb(Normalisation::ImageNet, (0.8 - 0.485) / 0.229, (0.4 - 0.456) / 0.224, (0.2 - 0.406) / 0.225);
}

}  // namespace
}  // namespace wardslam::segmentation
