#include "wardslam/segmentation/network.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "segmentation/onnx_writer.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

using core::InputError;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// x -> [x - 1, max(x, 0)], and the number of the largest channel.
std::string network() {
  test::OnnxWriter onnx;
  onnx.addInput("x", {1, 3, 2, 4});
  onnx.addConstant("one", {1, 3, 1, 1}, {1.0F, 1.0F, 1.0F});
  onnx.addNode("Sub", "sub", {"x", "one"}, "less");
  onnx.addNode("Relu", "relu", {"x"}, "positive");
  onnx.addNode("ArgMax", "best", {"x"}, "channel", {{"axis", 1}, {"keepdims", 1}});
  onnx.addOutput("less");
  onnx.addOutput("positive");
  onnx.addOutput("channel", test::OnnxWriter::ElementType::Int64);
  return onnx.model();
}

cv::Mat numbers() {
  cv::Mat blob({1, 3, 2, 4}, CV_32F);
  for (int i = 0; i < 24; ++i) blob.ptr<float>()[i] = static_cast<float>((i * 7) % 24) - 12.0F;
  return blob;
}

/// Every library that may run networks is to pass the same tests.
class NetworkTest : public ::testing::TestWithParam<Backend> {
 protected:
  void SetUp() override {
    source_.model = folder_.write("net.onnx", network());
    source_.backend = GetParam();
    try {
      ::testing::internal::CaptureStderr();
      opened_ = openNetwork(source_);
      errors_ = ::testing::internal::GetCapturedStderr();
    } catch (const InputError& error) {
      static_cast<void>(::testing::internal::GetCapturedStderr());
      if (GetParam() == Backend::OpenCv) throw;
      EXPECT_THAT(error.what(), HasSubstr("this build has no ONNX Runtime; set segmentation.backend to opencv"));
      GTEST_SKIP() << error.what();
    }
  }

  test::TemporaryFolder folder_;
  NetworkSource source_;
  OpenedNetwork opened_;
  std::string errors_;  ///< What opening it wrote to standard error.
};

TEST_P(NetworkTest, PutsOutAllTensorsInTheOrderOfTheFile) {
  const cv::Mat input = numbers();
  const auto outputs = opened_.network->infer(input);
  ASSERT_EQ(outputs.size(), 3U);
  EXPECT_EQ(shapesText(outputs), "[1,3,2,4], [1,3,2,4], [1,1,2,4]");
  for (const auto& output : outputs) EXPECT_EQ(output.type(), CV_32F);
  for (int i = 0; i < 24; ++i) {
    EXPECT_EQ(outputs[0].ptr<float>()[i], input.ptr<float>()[i] - 1.0F);
    EXPECT_EQ(outputs[1].ptr<float>()[i], std::max(input.ptr<float>()[i], 0.0F));
  }
  for (int i = 0; i < 8; ++i) {
    const float* x = input.ptr<float>() + i;
    const int best = x[0] > x[8] ? (x[0] > x[16] ? 0 : 2) : (x[8] > x[16] ? 1 : 2);
    EXPECT_EQ(outputs[2].ptr<float>()[i], static_cast<float>(best)) << i;
  }
}

TEST_P(NetworkTest, TellsTheSizeOfTheInput) { EXPECT_EQ(opened_.input_px, cv::Size(4, 2)); }

TEST_P(NetworkTest, ThrowsOnAnInputItCannotTake) {
  EXPECT_THROW((void)opened_.network->infer(cv::Mat({1, 5, 2, 4}, CV_32F, cv::Scalar(0))), NetworkError);
  EXPECT_EQ(opened_.network->infer(numbers()).size(), 3U);
}

TEST_P(NetworkTest, RefusesDamagedFiles) {
  source_.model = folder_.write("cut.onnx", network().substr(0, 150));
  EXPECT_THAT([&] { (void)openNetwork(source_); }, ThrowsMessage<InputError>(HasSubstr("cut.onnx: ")));
}

TEST_P(NetworkTest, OpensWithoutAWord) {
  EXPECT_EQ(errors_, "") << "ONNX complains of operators that are registered twice";
}

INSTANTIATE_TEST_SUITE_P(Backends, NetworkTest, ::testing::Values(Backend::OpenCv, Backend::OnnxRuntime),
                         [](const auto& parameter) {
                           return parameter.param == Backend::OpenCv ? "OpenCv" : "OnnxRuntime";
                         });

TEST(OpenNetwork, OnnxRuntimeTakesNoFrozenGraphs) {
  NetworkSource source;
  source.model = "graph.pb";
  source.backend = Backend::OnnxRuntime;
  EXPECT_THAT([&] { (void)openNetwork(source); },
              ThrowsMessage<InputError>(HasSubstr("set segmentation.backend to opencv")));
}

}  // namespace
}  // namespace wardslam::segmentation
