#include "onnx_file.h"

#include <gtest/gtest.h>

#include "segmentation/onnx_writer.h"
#include "support/temporary_folder.h"

namespace wardslam::segmentation {
namespace {

using Shape = std::vector<std::int64_t>;

TEST(OnnxFile, FindsTheShapeOfTheImageInput) {
  test::OnnxWriter onnx;
  onnx.addInput("images", {1, 3, 256, 320});
  EXPECT_EQ(onnxImageInput(onnx.model()), (Shape{1, 3, 256, 320}));
}

TEST(OnnxFile, PassesOverWeightsAndScalarsAmongTheInputs) {
  test::OnnxWriter onnx;
  onnx.addInput("weights", {16, 3, 3, 3});
  onnx.addInput("threshold", {1});
  onnx.addConstant("constant", {2}, {1.0F, 2.0F});
  onnx.addInput("images", {1, 3, 480, 640});
  EXPECT_EQ(onnxImageInput(onnx.model()), (Shape{1, 3, 480, 640}));
}

TEST(OnnxFile, GivesOpenDimensionsAsZero) {
  test::OnnxWriter onnx;
  onnx.addInput("images", {0, 3, 0, 0});
  EXPECT_EQ(onnxImageInput(onnx.model()), (Shape{0, 3, 0, 0}));
}

TEST(OnnxFile, FindsNothingInWhatIsNotOnnx) {
  EXPECT_EQ(onnxImageInput(""), std::nullopt);
  EXPECT_EQ(onnxImageInput("this is text and not a network"), std::nullopt);
  EXPECT_EQ(onnxImageInput(std::string(64, '\xff')), std::nullopt);
}

TEST(OnnxFile, SurvivesEveryCut) {
  test::OnnxWriter onnx;
  onnx.addConstant("constant", {2}, {1.0F, 2.0F});
  onnx.addInput("images", {1, 3, 256, 320});
  const std::string model = onnx.model();
  const std::string operatorSet = model.substr(model.size() - 4);  // after the graph, not needed here
  for (std::size_t length = 0; length < model.size() - operatorSet.size(); ++length) {
    EXPECT_EQ(onnxImageInput(model.substr(0, length)), std::nullopt) << length;
  }
}

TEST(OnnxFile, ListsTheOutputsInTheirOrder) {
  test::OnnxWriter onnx;
  onnx.addInput("images", {1, 3, 256, 320});
  onnx.addOutput("zoo");
  onnx.addOutput("ant");
  EXPECT_EQ(onnxOutputs(onnx.model()), (std::vector<std::string>{"zoo", "ant"}));
  EXPECT_TRUE(onnxOutputs("no network").empty());
}

TEST(OnnxFile, TellsWhatItsWriterNoted) {
  test::OnnxWriter onnx;
  onnx.addInput("images", {1, 3, 256, 320});
  onnx.addMetadata("names", "{0: 'person'}");
  onnx.addMetadata("task", "segment");
  EXPECT_EQ(onnxMetadata(onnx.model()).at("names"), "{0: 'person'}");
  EXPECT_EQ(onnxMetadata(onnx.model()).size(), 2U);
  EXPECT_TRUE(onnxMetadata("no network").empty());
}

TEST(OnnxFile, TellsHalfFloatsFromOthers) {
  test::OnnxWriter half;
  half.addInput("images", {1, 3, 256, 320}, test::OnnxWriter::ElementType::Float16);
  EXPECT_TRUE(takesHalfFloats(half.model()));
  test::OnnxWriter whole;
  whole.addInput("images", {1, 3, 256, 320});
  EXPECT_FALSE(takesHalfFloats(whole.model()));
  EXPECT_FALSE(takesHalfFloats("no network"));
}

TEST(OnnxFile, ReadsRealNetworks) {
  const std::filesystem::path models = std::filesystem::path(WARDSLAM_SHARED_DIR) / "models";
  if (!std::filesystem::exists(models)) GTEST_SKIP() << models << " is absent";
  EXPECT_EQ(onnxImageInput(test::readText(models / "yolov8n-seg_320x256.onnx")), (Shape{1, 3, 256, 320}));
  EXPECT_EQ(onnxImageInput(test::readText(models / "yolov8n-seg_640x480.onnx")), (Shape{1, 3, 480, 640}));
  const std::string v5 = test::readText(models / "yolov5n-seg_320x256.onnx");
  EXPECT_EQ(onnxImageInput(v5), (Shape{1, 3, 256, 320}));
  EXPECT_EQ(onnxOutputs(v5), (std::vector<std::string>{"output0", "output1"}));
}

}  // namespace
}  // namespace wardslam::segmentation
