#include "wardslam/segmentation/semantic_decoder.h"

#include <gtest/gtest.h>

#include "segmentation/fake_network.h"

namespace wardslam::segmentation {
namespace {

using Kind = SemanticLayout::Kind;

constexpr int kPerson = 15;  // Pascal VOC
constexpr int kChair = 9;
constexpr int kClasses = 21;

// Input of 64x64, output of 16x16.
class DecodeSemantic : public ::testing::Test {
 protected:
  static constexpr int kInput_px = 64;
  static constexpr int kOutput_px = 16;

  [[nodiscard]] cv::Mat scores(int classIndex) {
    return {kOutput_px, kOutput_px, CV_32F, output_.ptr<float>(0, classIndex)};
  }

  /// The same scores, class by class for each pixel.
  [[nodiscard]] cv::Mat classesLast() {
    cv::Mat last = test::tensor({1, kOutput_px, kOutput_px, kClasses});
    for (int c = 0; c < kClasses; ++c) {
      for (int y = 0; y < kOutput_px; ++y) {
        for (int x = 0; x < kOutput_px; ++x) last.at<float>(cv::Vec4i(0, y, x, c)) = scores(c).at<float>(y, x);
      }
    }
    return last;
  }

  [[nodiscard]] core::Segmentation decode(const cv::Mat& output, const cv::Size& image_px = {64, 64}) const {
    const cv::Size input_px(kInput_px, kInput_px);
    const std::vector<int> shape(output.size.p, output.size.p + output.dims);
    const auto layout = SemanticLayout::fromShape(shape, input_px);
    EXPECT_TRUE(layout);
    return decodeSemantic(output, *layout, Letterbox(image_px, input_px), labels_, minRegion_px_);
  }

  static void expectClass(const core::Segmentation& segmentation, core::ClassId classId, const cv::Rect& area_px) {
    cv::Mat expected(segmentation.classIds.size(), CV_8UC1, cv::Scalar(0));
    expected(area_px).setTo(255);
    EXPECT_EQ(cv::norm(expected, segmentation.classIds == classId, cv::NORM_INF), 0.0) << int{classId};
  }

  int minRegion_px_ = 20;
  LabelMap labels_ = LabelMap::fromFile("labels/voc21.yaml");
  cv::Mat output_ = test::tensor({1, kClasses, kOutput_px, kOutput_px});
};

TEST_F(DecodeSemantic, BackgroundIsUnclassified) {
  scores(0).setTo(1.0F);
  const auto segmentation = decode(output_);
  EXPECT_EQ(segmentation.classIds.size(), cv::Size(64, 64));
  EXPECT_EQ(cv::countNonZero(segmentation.classIds), 0);
  EXPECT_EQ(segmentation.instanceIds.type(), CV_16UC1);
  EXPECT_TRUE(segmentation.instances.empty());
}

TEST_F(DecodeSemantic, CutsWhereTheScoresAreEqual) {
  // Columns 7.5 and 10 of the output are (7.5 + 0.5) * 4 = 32 and 42 pixels from the left.
  for (int x = 0; x < kOutput_px; ++x) {
    scores(kPerson).col(x).setTo(static_cast<float>(x) - 7.5F);
    scores(kChair).col(x).setTo(3.0F * (static_cast<float>(x) - 10.0F) + 2.5F);  // equal to the person's at 10
  }
  for (const auto& output : {output_, classesLast()}) {
    const auto segmentation = decode(output);
    expectClass(segmentation, 1, {32, 0, 10, 64});
    expectClass(segmentation, 57, {42, 0, 22, 64});
    ASSERT_EQ(segmentation.instances.size(), 2U);
    EXPECT_EQ(segmentation.instances[0].classId, 1);
    EXPECT_EQ(segmentation.instances[0].box_px, cv::Rect(32, 0, 10, 64));
    EXPECT_EQ(segmentation.instances[1].box_px, cv::Rect(42, 0, 22, 64));
    EXPECT_EQ(segmentation.instances[0].confidence, 1.0F);
  }
}

TEST_F(DecodeSemantic, EachRegionIsAnInstance) {
  scores(0).setTo(1.0F);
  scores(kPerson)(cv::Rect(1, 1, 4, 10)).setTo(9.0F);
  scores(kPerson)(cv::Rect(9, 1, 4, 10)).setTo(9.0F);
  scores(kChair)(cv::Rect(14, 14, 1, 1)).setTo(9.0F);
  minRegion_px_ = 100;
  const auto segmentation = decode(output_);
  ASSERT_EQ(segmentation.instances.size(), 2U);
  EXPECT_NE(segmentation.instances[0].id, segmentation.instances[1].id);
  for (const auto& instance : segmentation.instances) EXPECT_EQ(instance.classId, 1);
  EXPECT_EQ(segmentation.classIds.at<core::ClassId>(57, 57), 57);  // what it shows stays known
  EXPECT_EQ(segmentation.instanceIds.at<std::uint16_t>(57, 57), 0);
}

TEST_F(DecodeSemantic, UndoesTheLetterbox) {
  // 128x64 becomes 64x32 between rows 16 and 48 of the input, 4 and 12 of the output.
  scores(kPerson).rowRange(0, 4).setTo(9.0F);
  scores(kPerson).rowRange(12, 16).setTo(9.0F);
  scores(0).rowRange(4, 12).setTo(9.0F);
  scores(kChair)(cv::Rect(8, 4, 8, 8)).setTo(30.0F);
  const auto segmentation = decode(output_, {128, 64});
  EXPECT_EQ(segmentation.classIds.size(), cv::Size(128, 64));
  EXPECT_EQ(cv::countNonZero(segmentation.classIds(cv::Rect(72, 8, 56, 48)) != 57), 0);
  EXPECT_EQ(cv::countNonZero(segmentation.classIds(cv::Rect(0, 8, 56, 48))), 0);
}

TEST_F(DecodeSemantic, TakesClassNumbers) {
  for (const auto& shape : {std::vector<int>{1, 16, 16}, {1, 1, 16, 16}, {1, 16, 16, 1}}) {
    cv::Mat output = test::tensor(shape);
    cv::Mat numbers(16, 16, CV_32F, output.ptr<float>());
    numbers(cv::Rect(2, 3, 4, 5)).setTo(kPerson);
    numbers(cv::Rect(10, 3, 2, 2)).setTo(200);  // no class of this network
    const auto segmentation = decode(output);
    expectClass(segmentation, 1, {8, 12, 16, 20});
    EXPECT_EQ(cv::countNonZero(segmentation.classIds), 16 * 20);
    ASSERT_EQ(segmentation.instances.size(), 1U);
    EXPECT_EQ(segmentation.instances[0].box_px, cv::Rect(8, 12, 16, 20));
  }
}

TEST(SemanticLayout, IsToldByTheShape) {
  const cv::Size input_px(320, 256);
  const auto expectLayout = [&](const std::vector<int>& shape, Kind kind, int classes, const cv::Size& size) {
    const auto layout = SemanticLayout::fromShape(shape, input_px);
    ASSERT_TRUE(layout);
    EXPECT_EQ(layout->kind, kind);
    EXPECT_EQ(layout->classes, kind == Kind::ClassMap ? 0 : classes);
    EXPECT_EQ(layout->size, size);
  };
  expectLayout({1, 21, 256, 320}, Kind::ScoresFirst, 21, {320, 256});
  expectLayout({1, 256, 320, 21}, Kind::ScoresLast, 21, {320, 256});
  expectLayout({1, 21, 32, 40}, Kind::ScoresFirst, 21, {40, 32});
  expectLayout({1, 33, 41, 150}, Kind::ScoresLast, 150, {41, 33});  // as DeepLab rounds
  expectLayout({1, 2, 256, 320}, Kind::ScoresFirst, 2, {320, 256});
  expectLayout({1, 256, 320}, Kind::ClassMap, 0, {320, 256});
  expectLayout({1, 1, 256, 320}, Kind::ClassMap, 0, {320, 256});
  expectLayout({1, 256, 320, 1}, Kind::ClassMap, 0, {320, 256});
}

TEST(SemanticLayout, RefusesOtherShapes) {
  EXPECT_FALSE(SemanticLayout::fromShape({2, 21, 256, 320}, {320, 256}));
  EXPECT_FALSE(SemanticLayout::fromShape({1, 1000}, {320, 256}));
  EXPECT_FALSE(SemanticLayout::fromShape({1, 21, 0, 320}, {320, 256}));
  EXPECT_FALSE(SemanticLayout::fromShape({1, 3, 21, 256, 320}, {320, 256}));
  EXPECT_FALSE(SemanticLayout::fromShape({}, {320, 256}));
}

}  // namespace
}  // namespace wardslam::segmentation
