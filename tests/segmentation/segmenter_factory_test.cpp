#include "wardslam/segmentation/segmenter_factory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/options.h"

namespace wardslam::segmentation {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using Type = SegmentationOptions::Type;

SegmentationOptions parse(const std::string& text) {
  SegmentationOptions options;
  core::readOptions(core::ConfigNode::fromText(text), options);
  return options;
}

TEST(SegmenterFactory, MakesTheNetworkThatComesWithTheProgramByDefault) {
  const auto segmenter = makeSegmenter({});
  ASSERT_NE(dynamic_cast<DepthSegmenter*>(segmenter.get()), nullptr);
  EXPECT_EQ(segmenter->labelSpace().find("person"), core::ClassId{1});
  EXPECT_EQ(segmenter->labelSpace().name(102), "trolley");
}

TEST(SegmenterFactory, MakesNothingWhereNothingIsWanted) {
  SegmentationOptions options;
  options.type = Type::None;
  EXPECT_EQ(makeSegmenter(options), nullptr);
}

TEST(SegmenterFactory, MakesRecordedMasks) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(cv::imwrite((folder.path() / "1.000000.png").string(), cv::Mat(4, 4, CV_8UC1, cv::Scalar(0))));
  SegmentationOptions options;
  options.type = Type::RecordedMasks;
  options.recorded_masks.folder = folder.path().string();
  options.classes = folder.write("names.txt", "102 trolley\n").string();
  const auto segmenter = makeSegmenter(options);
  ASSERT_NE(dynamic_cast<RecordedMasks*>(segmenter.get()), nullptr);
  EXPECT_EQ(segmenter->labelSpace().name(102), "trolley");
}

TEST(SegmenterFactory, PassesSetUpErrorsOn) {
  SegmentationOptions options;
  options.type = Type::Yolo;
  options.yolo.model = "/no/such/model.onnx";
  EXPECT_THAT([&] { (void)makeSegmenter(options); }, ThrowsMessage<core::InputError>(HasSubstr("/no/such/model.onnx")));
  options.type = Type::RecordedMasks;
  options.recorded_masks.folder = "/no/such/folder";
  EXPECT_THAT([&] { (void)makeSegmenter(options); }, ThrowsMessage<core::InputError>(HasSubstr("/no/such/folder")));
}

TEST(SegmenterFactory, PassesOnWhatConcernsNetworks) {
  const test::TemporaryFolder folder;
  SegmentationOptions options;
  for (const auto type : {Type::Depth, Type::Yolo, Type::MaskRcnn, Type::Semantic}) {
    options.type = type;
    options.backend = Backend::OnnxRuntime;
    options.mask_rcnn.model = "/no/such/graph.pb";
    options.depth.model = options.yolo.model = options.semantic.model = "/no/such/net.onnx";
    EXPECT_THROW((void)makeSegmenter(options), core::InputError);
    options.backend = Backend::OpenCv;
    EXPECT_THAT([&] { (void)makeSegmenter(options); }, ThrowsMessage<core::InputError>(HasSubstr("/no/such/")));
  }
}

TEST(SegmentationOptions, AreReadFromYaml) {
  const auto options = parse(
      "type: yolo\n"
      "classes: names.txt\n"
      "recorded_masks: {folder: masks, tolerance: 2, min_region: 50}\n"
      "yolo: {model: net.onnx, confidence: 0.4, nms_iou: 0.6, mask_threshold: 0.3, max_instances: 7}\n"
      "backend: onnxruntime\n"
      "mask_rcnn: {model: a.pb, graph: a.pbtxt, input_width: 800, input_height: 600, confidence: 0.6}\n"
      "semantic: {model: b.onnx, output: out, normalisation: minus_one_to_one, min_region: 9}\n");
  EXPECT_EQ(options.backend, Backend::OnnxRuntime);
  EXPECT_EQ(options.mask_rcnn.graph, "a.pbtxt");
  EXPECT_EQ(options.mask_rcnn.input_width_px, 800);
  EXPECT_EQ(options.mask_rcnn.decoder.confidence, 0.6);
  EXPECT_EQ(options.semantic.output, "out");
  EXPECT_EQ(options.semantic.normalisation, SemanticOptions::Normalisation::MinusOneToOne);
  EXPECT_EQ(options.semantic.min_region_px, 9);
  EXPECT_EQ(options.type, Type::Yolo);
  EXPECT_EQ(options.classes, "names.txt");
  EXPECT_EQ(options.recorded_masks.folder, "masks");
  EXPECT_EQ(options.recorded_masks.tolerance_ms, 2.0);
  EXPECT_EQ(options.recorded_masks.min_region_px, 50);
  EXPECT_EQ(options.yolo.model, "net.onnx");
  EXPECT_EQ(options.yolo.decoder.confidence, 0.4);
  EXPECT_EQ(options.yolo.decoder.nms_iou, 0.6);
  EXPECT_EQ(options.yolo.decoder.mask_threshold, 0.3);
  EXPECT_EQ(options.yolo.decoder.max_instances, 7);
}

TEST(SegmentationOptions, SurviveWritingAndReading) {
  SegmentationOptions options;
  options.type = Type::RecordedMasks;
  options.recorded_masks.folder = "some folder/masks";
  options.yolo.decoder.confidence = 0.31;
  const auto again = parse(core::writeOptions(options));
  EXPECT_EQ(again.type, options.type);
  EXPECT_EQ(again.recorded_masks.folder, options.recorded_masks.folder);
  EXPECT_EQ(again.yolo.decoder.confidence, options.yolo.decoder.confidence);
}

TEST(SegmentationOptions, RefuseMisspeltAndWildValues) {
  EXPECT_THAT([] { parse("type: yolov8\n"); }, ThrowsMessage<core::InputError>(HasSubstr("yolo")));
  EXPECT_THAT([] { parse("yolo: {confidense: 0.5}\n"); }, ThrowsMessage<core::InputError>(HasSubstr("confidence")));
  EXPECT_THAT([] { parse("yolo: {confidence: 1.5}\n"); }, ThrowsMessage<core::InputError>(HasSubstr("confidence")));
}

}  // namespace
}  // namespace wardslam::segmentation
