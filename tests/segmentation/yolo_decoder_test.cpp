#include "wardslam/segmentation/yolo_decoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/temporary_folder.h"

namespace wardslam::segmentation {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using Version = YoloLayout::Version;

constexpr int kAnchors = 20;
constexpr int kClasses = 3;
constexpr int kPrototypes = 2;
constexpr float kEverywhere = 10.0F;  // a logit far above zero

struct Anchor {
  cv::Rect2f box_px;  // in the input
  int classIndex = 0;
  float confidence = 0.0F;
  float constant = kEverywhere;  // coefficient of the prototype that is 1 everywhere
  float ramp = 0.0F;             // coefficient of the prototype that is 0 midway between its columns 7 and 8
};

// A network with an input of 64x64 and prototypes of 16x16.
class DecodeYolo : public ::testing::TestWithParam<Version> {
 protected:
  static constexpr int kInput_px = 64;
  static constexpr int kPrototype_px = 16;

  void set(int anchor, int value, float number) {
    (GetParam() == Version::V5 ? detections_.at<float>(0, anchor, value) : detections_.at<float>(0, value, anchor)) =
        number;
  }

  // In v5 the confidence is the product of objectness and score.
  void add(int anchor, const Anchor& content) {
    const cv::Rect2f& box = content.box_px;
    int value = 0;
    for (const float number : {box.x + box.width / 2, box.y + box.height / 2, box.width, box.height}) {
      set(anchor, value++, number);
    }
    if (GetParam() == Version::V5) set(anchor, value++, 0.95F);
    set(anchor, value + content.classIndex, content.confidence / (GetParam() == Version::V5 ? 0.95F : 1.0F));
    set(anchor, value + kClasses, content.constant);
    set(anchor, value + kClasses + 1, content.ramp);
  }

  [[nodiscard]] core::Segmentation decode(const cv::Size& image_px = {64, 64}) const {
    const std::vector<int> shape(detections_.size.p, detections_.size.p + 3);
    const auto layout = YoloLayout::fromShapes(shape, {1, kPrototypes, kPrototype_px, kPrototype_px});
    EXPECT_TRUE(layout && layout->version == GetParam() && layout->classes == kClasses);
    return decodeYolo(detections_, prototypes(), *layout, Letterbox(image_px, {kInput_px, kInput_px}), labels_,
                      options_);
  }

  // What the pixels should be when each of `instances` fills its box but for the part in `covered`.
  static void expectFilled(const core::Segmentation& segmentation, std::uint16_t id, core::ClassId classId,
                           const cv::Rect& area_px, const cv::Rect& covered_px = {}) {
    cv::Mat expected(segmentation.classIds.size(), CV_8UC1, cv::Scalar(0));
    expected(area_px).setTo(255);
    expected(covered_px).setTo(0);
    EXPECT_EQ(cv::norm(expected, segmentation.instanceIds == id, cv::NORM_INF), 0.0) << "instance " << id;
    EXPECT_EQ(cv::countNonZero((segmentation.classIds != classId) & expected), 0) << "instance " << id;
  }

  static cv::Mat prototypes() {
    cv::Mat tensor({1, kPrototypes, kPrototype_px, kPrototype_px}, CV_32F, cv::Scalar(1.0));
    for (int y = 0; y < kPrototype_px; ++y) {
      for (int x = 0; x < kPrototype_px; ++x) {
        tensor.at<float>(cv::Vec4i(0, 1, y, x)) = static_cast<float>(x) - 7.5F;
      }
    }
    return tensor;
  }

  YoloDecoderOptions options_;
  LabelMap labels_ = LabelMap::consecutive(core::LabelSpace::coco());
  cv::Mat detections_ = GetParam() == Version::V5
                            ? cv::Mat({1, kAnchors, 5 + kClasses + kPrototypes}, CV_32F, cv::Scalar(0))
                            : cv::Mat({1, 4 + kClasses + kPrototypes, kAnchors}, CV_32F, cv::Scalar(0));
};

TEST_P(DecodeYolo, FindsNothingInZeros) {
  const auto segmentation = decode();
  EXPECT_FALSE(segmentation.empty());
  EXPECT_TRUE(segmentation.instances.empty());
  EXPECT_EQ(cv::countNonZero(segmentation.classIds), 0);
  EXPECT_EQ(segmentation.instanceIds.type(), CV_16UC1);
}

TEST_P(DecodeYolo, FillsABoxWhoseLogitsArePositive) {
  add(13, {{10, 20, 30, 24}, 2, 0.8F});
  const auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 1U);
  EXPECT_EQ(segmentation.instances[0].id, 1);
  EXPECT_EQ(segmentation.instances[0].classId, 3);
  EXPECT_NEAR(segmentation.instances[0].confidence, 0.8F, 1e-6F);
  EXPECT_EQ(segmentation.instances[0].box_px, cv::Rect(10, 20, 30, 24));
  expectFilled(segmentation, 1, 3, {10, 20, 30, 24});
}

TEST_P(DecodeYolo, CutsTheMaskWhereTheLogitCrossesZero) {
  // Prototype column 7.5 is the pixel column (7.5 + 0.5) * 4 - 0.5 = 31.5: 32 is the first inside.
  add(0, {{8, 8, 48, 40}, 0, 0.9F, 0.0F, 1.0F});
  expectFilled(decode(), 1, 1, {32, 8, 24, 40});
  // ramp + 1 crosses zero at column 6.5, pixel 27.5.
  add(0, {{8, 8, 48, 40}, 0, 0.9F, 1.0F, 1.0F});
  expectFilled(decode(), 1, 1, {28, 8, 28, 40});
  // 3 - 2 ramp is positive left of column 9, pixel 37.5.
  add(0, {{8, 8, 48, 40}, 0, 0.9F, 3.0F, -2.0F});
  expectFilled(decode(), 1, 1, {8, 8, 30, 40});
}

TEST_P(DecodeYolo, AppliesTheMaskThresholdAsAProbability) {
  add(0, {{8, 8, 16, 16}, 0, 0.9F, 2.0F});  // sigmoid(2) = 0.881
  options_.mask_threshold = 0.87;
  EXPECT_EQ(decode().instances.size(), 1U);
  options_.mask_threshold = 0.89;
  EXPECT_TRUE(decode().instances.empty());
}

TEST_P(DecodeYolo, GivesClassesTheirMeaningAndDropsThoseWithout) {
  const test::TemporaryFolder folder;
  labels_ = LabelMap::fromFile(folder.write("net.yaml", "names: {100: trolley}\nclasses: [person, ~, trolley]\n"));
  add(0, {{0, 0, 16, 16}, 0, 0.7F});
  add(1, {{16, 0, 16, 16}, 1, 0.9F});  // covers nothing, though more confident
  add(2, {{16, 8, 16, 16}, 2, 0.8F});
  const auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 2U);
  expectFilled(segmentation, 1, 100, {16, 8, 16, 16});
  expectFilled(segmentation, 2, 1, {0, 0, 16, 16});
}

TEST_P(DecodeYolo, PutsTheMoreConfidentOnTop) {
  add(3, {{0, 0, 32, 32}, 0, 0.6F});
  add(4, {{16, 16, 32, 32}, 1, 0.7F});
  const auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 2U);
  expectFilled(segmentation, 1, 2, {16, 16, 32, 32});
  expectFilled(segmentation, 2, 1, {0, 0, 32, 32}, {16, 16, 16, 16});
  EXPECT_GT(segmentation.instances[0].confidence, segmentation.instances[1].confidence);
}

TEST_P(DecodeYolo, DropsAnInstanceThatIsCoveredWhole) {
  add(3, {{20, 20, 8, 8}, 0, 0.6F});
  add(4, {{16, 16, 32, 32}, 1, 0.7F});
  add(5, {{0, 0, 8, 8}, 0, 0.5F});
  const auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 2U);
  expectFilled(segmentation, 1, 2, {16, 16, 32, 32});
  expectFilled(segmentation, 2, 1, {0, 0, 8, 8});
}

TEST_P(DecodeYolo, SuppressesWithinAClassOnly) {
  // Intersection 28 * 32, union 2 * 32 * 32 - 28 * 32: overlap 0.78.
  add(0, {{0, 0, 32, 32}, 0, 0.9F});
  add(1, {{4, 0, 32, 32}, 0, 0.8F});
  auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 1U);
  expectFilled(segmentation, 1, 1, {0, 0, 32, 32});

  options_.nms_iou = 0.79;
  EXPECT_EQ(decode().instances.size(), 2U);

  options_.nms_iou = 0.45;
  add(2, {{4, 0, 32, 32}, 1, 0.8F});
  segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 2U);
  expectFilled(segmentation, 2, 2, {32, 0, 4, 32});
}

TEST_P(DecodeYolo, DropsTheUnsureAndKeepsTheMostConfident) {
  options_.confidence = 0.5;
  options_.max_instances = 2;
  add(0, {{0, 0, 8, 8}, 0, 0.49F});
  add(1, {{16, 0, 8, 8}, 0, 0.51F});
  add(2, {{32, 0, 8, 8}, 0, 0.7F});
  add(3, {{48, 0, 8, 8}, 0, 0.6F});
  const auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 2U);
  expectFilled(segmentation, 1, 1, {32, 0, 8, 8});
  expectFilled(segmentation, 2, 1, {48, 0, 8, 8});
  options_.max_instances = 10;
  EXPECT_EQ(decode().instances.size(), 3U);
}

TEST_P(DecodeYolo, UndoesTheLetterbox) {
  // 128x64 becomes 64x32 between rows 16 and 48 of the input: image = 2 * (input - (0, 16)).
  add(0, {{8, 20, 40, 16}, 0, 0.9F});
  auto segmentation = decode({128, 64});
  EXPECT_EQ(segmentation.classIds.size(), cv::Size(128, 64));
  ASSERT_EQ(segmentation.instances.size(), 1U);
  EXPECT_EQ(segmentation.instances[0].box_px, cv::Rect(16, 8, 80, 32));
  expectFilled(segmentation, 1, 1, {16, 8, 80, 32});

  // The ramp is zero at the middle of the input, hence of the image.
  add(0, {{8, 20, 40, 16}, 0, 0.9F, 0.0F, 1.0F});
  expectFilled(decode({128, 64}), 1, 1, {64, 8, 32, 32});
}

TEST_P(DecodeYolo, ClipsBoxesAtTheBorder) {
  add(0, {{-10, -6, 20, 20}, 0, 0.9F});
  add(1, {{50, 54, 40, 40}, 1, 0.8F});
  add(2, {{-50, 20, 40, 10}, 2, 0.7F});  // outside
  add(3, {{20, 20, 0, 10}, 2, 0.7F});    // no area
  const auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 2U);
  EXPECT_EQ(segmentation.instances[0].box_px, cv::Rect(0, 0, 10, 14));
  expectFilled(segmentation, 1, 1, {0, 0, 10, 14});
  EXPECT_EQ(segmentation.instances[1].box_px, cv::Rect(50, 54, 14, 10));
  expectFilled(segmentation, 2, 2, {50, 54, 14, 10});
}

TEST_P(DecodeYolo, IgnoresNumbersThatAreNone) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  add(0, {{kNan, 0, 20, 20}, 0, 0.9F});
  add(1, {{0, 0, kInfinity, 20}, 0, 0.9F});
  add(2, {{0, 0, 20, 20}, 0, kNan});
  add(3, {{0, 0, 1e30F, 1e30F}, 0, 0.9F});  // finite, and fills the image
  const auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 1U);
  EXPECT_EQ(segmentation.instances[0].box_px.size(), cv::Size(64, 64));
}

TEST_P(DecodeYolo, RefusesAConfidenceAboveOne) {
  add(0, {{0, 0, 20, 20}, 0, 1.0F});
  EXPECT_EQ(decode().instances.size(), 1U);
  add(1, {{30, 0, 20, 20}, 1, 1.5F});
  EXPECT_THROW((void)decode(), YoloLayoutError);
}

INSTANTIATE_TEST_SUITE_P(Layouts, DecodeYolo, ::testing::Values(Version::V5, Version::V8),
                         [](const auto& parameter) { return parameter.param == Version::V5 ? "V5" : "V8"; });

TEST(YoloLayout, TellsTheVersionsApart) {
  const auto v8 = YoloLayout::fromShapes({1, 116, 1680}, {1, 32, 64, 80});
  ASSERT_TRUE(v8);
  EXPECT_EQ(v8->version, Version::V8);
  EXPECT_EQ(v8->anchors, 1680);
  EXPECT_EQ(v8->classes, 80);
  EXPECT_EQ(v8->prototypes, 32);

  const auto v5 = YoloLayout::fromShapes({1, 5040, 117}, {1, 32, 64, 80});
  ASSERT_TRUE(v5);
  EXPECT_EQ(v5->version, Version::V5);
  EXPECT_EQ(v5->anchors, 5040);
  EXPECT_EQ(v5->classes, 80);
}

constexpr int kRowValues = 6 + kPrototypes;

/// One row of a network that suppresses itself: corners, confidence, class, coefficients.
core::Segmentation decodeRow(const std::vector<float>& values,
                             const LabelMap& labels = LabelMap::consecutive(core::LabelSpace::coco())) {
  cv::Mat rows({1, 30, kRowValues}, CV_32F, cv::Scalar(0));
  std::copy(values.begin(), values.end(), rows.ptr<float>(0, 3));
  cv::Mat prototypes({1, kPrototypes, 16, 16}, CV_32F, cv::Scalar(1.0));
  const auto layout = YoloLayout::fromShapes({1, 30, kRowValues}, {1, kPrototypes, 16, 16}, {64, 64});
  EXPECT_TRUE(layout && layout->version == Version::EndToEnd);
  return decodeYolo(rows, prototypes, *layout, Letterbox({64, 64}, {64, 64}), labels, {});
}

TEST(YoloEndToEnd, RowsAreCornersConfidenceAndClass) {
  const auto segmentation = decodeRow({10, 20, 40, 44, 0.8F, 56, kEverywhere, 0});
  ASSERT_EQ(segmentation.instances.size(), 1U);
  EXPECT_EQ(segmentation.instances[0].classId, 57);
  EXPECT_NEAR(segmentation.instances[0].confidence, 0.8F, 1e-6F);
  EXPECT_EQ(segmentation.instances[0].box_px, cv::Rect(10, 20, 30, 24));
}

TEST(YoloEndToEnd, RefusesWhatIsNoConfidenceOrNoClass) {
  EXPECT_THROW((void)decodeRow({10, 20, 40, 44, 56.0F, 2.0F, kEverywhere, 0}), YoloLayoutError);
  EXPECT_THROW((void)decodeRow({10, 20, 40, 44, 0.8F, 0.5F, kEverywhere, 0}), YoloLayoutError);
}

TEST(YoloEndToEnd, RefusesAClassThatIsNotNamed) {
  const LabelMap one = LabelMap::fromNames({"person"}, "net");
  EXPECT_EQ(decodeRow({10, 20, 40, 44, 0.8F, 0, kEverywhere, 0}, one).instances.size(), 1U);
  EXPECT_THAT(
      [&] {
        (void)decodeRow({10, 20, 40, 44, 0.8F, 56, kEverywhere, 0}, one);
      },
      ThrowsMessage<YoloLayoutError>(AllOf(HasSubstr("class number 56"), HasSubstr("named; give the label file"))));
}

TEST(YoloLayout, TellsRowsOfSuppressedDetectionsFromAnchors) {
  const auto rows = YoloLayout::fromShapes({1, 300, 38}, {1, 32, 64, 80}, {320, 256});
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows->version, Version::EndToEnd);
  EXPECT_EQ(rows->prototypes, 32);
  const auto v5 = YoloLayout::fromShapes({1, 5040, 38}, {1, 32, 64, 80}, {320, 256});  // of one class
  ASSERT_TRUE(v5);
  EXPECT_EQ(v5->version, Version::V5);
  EXPECT_EQ(v5->classes, 1);
  // One anchor a cell: v8 turned round with two classes, or v5 without its three; no rows of suppressed detections.
  EXPECT_FALSE(YoloLayout::fromShapes({1, 1680, 38}, {1, 32, 64, 80}, {320, 256}));
}

TEST(YoloLayout, TellsVersion5WithOneAnchorACellByTheNamesOfItsClasses) {
  const auto v5 = YoloLayout::fromShapes({1, 1680, 38}, {1, 32, 64, 80}, {320, 256}, 1);
  ASSERT_TRUE(v5);
  EXPECT_EQ(v5->version, Version::V5);
  EXPECT_EQ(v5->classes, 1);
  EXPECT_EQ(v5->anchors, 1680);
  EXPECT_FALSE(YoloLayout::fromShapes({1, 1680, 38}, {1, 32, 64, 80}, {320, 256}, 2));  // v8 turned round
  EXPECT_EQ(YoloLayout::fromShapes({1, 5040, 38}, {1, 32, 64, 80}, {320, 256}, 1)->classes, 1);
}

TEST(YoloLayout, RefusesAnchorsThatNoStrideExplains) {
  EXPECT_TRUE(YoloLayout::fromShapes({1, 116, 1680}, {1, 32, 64, 80}, {320, 256}));
  EXPECT_TRUE(YoloLayout::fromShapes({1, 116, 1700}, {1, 32, 64, 80}, {320, 256}));  // with a stride of 64
  EXPECT_FALSE(YoloLayout::fromShapes({1, 116, 84}, {1, 32, 64, 80}, {320, 256}));
  EXPECT_FALSE(YoloLayout::fromShapes({1, 1680, 116}, {1, 32, 64, 80}, {320, 256}));  // turned round
  EXPECT_FALSE(YoloLayout::fromShapes({1, 116, 8400}, {1, 32, 64, 80}, {320, 256}));
}

TEST(YoloLayout, TakesAnyNumberOfClasses) {
  EXPECT_EQ(YoloLayout::fromShapes({1, 37, 1680}, {1, 32, 64, 80})->classes, 1);
  EXPECT_EQ(YoloLayout::fromShapes({1, 1240, 6300}, {1, 32, 120, 160})->classes, 1204);
}

TEST(YoloLayout, RefusesOtherShapes) {
  EXPECT_FALSE(YoloLayout::fromShapes({1, 84, 1680}, {}));                // a detector: no prototypes
  EXPECT_FALSE(YoloLayout::fromShapes({1, 36, 1680}, {1, 32, 64, 80}));   // no class is left
  EXPECT_FALSE(YoloLayout::fromShapes({2, 116, 1680}, {1, 32, 64, 80}));  // a batch
  EXPECT_FALSE(YoloLayout::fromShapes({1, 116, 1680}, {1, 32, 0, 80}));
  EXPECT_FALSE(YoloLayout::fromShapes({116, 1680}, {1, 32, 64, 80}));
  EXPECT_FALSE(YoloLayout::fromShapes({}, {}));
}

}  // namespace
}  // namespace wardslam::segmentation
