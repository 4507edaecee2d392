#include "wardslam/segmentation/mask_rcnn_decoder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "segmentation/fake_network.h"

namespace wardslam::segmentation {
namespace {

constexpr int kMask_px = 15;
constexpr int kClasses = 90;
constexpr int kPerson = 0;
constexpr int kChair = 61;  // COCO category 62

// 64x48 pixels.
class DecodeMaskRcnn : public ::testing::Test {
 protected:
  void add(int row, int classIndex, float score, const cv::Rect2f& box_px) {
    const auto width = static_cast<float>(image_px_.width);
    const auto height = static_cast<float>(image_px_.height);
    const cv::Point2f end = box_px.tl() + cv::Point2f(box_px.size());
    const float values[] = {
        0.0F,          static_cast<float>(classIndex), score, box_px.x / width, box_px.y / height, end.x / width,
        end.y / height};
    std::copy(values, values + 7, detections_.ptr<float>(0, 0) + 7 * row);
  }

  [[nodiscard]] cv::Mat mask(int row, int classIndex) {
    return {kMask_px, kMask_px, CV_32F, masks_.ptr<float>(row, classIndex)};
  }

  void addFilled(int row, int classIndex, float score, const cv::Rect2f& box_px) {
    add(row, classIndex, score, box_px);
    mask(row, classIndex).setTo(0.9F);
  }

  /// Probability = fraction of the way from left to right.
  void fillRamp(int row, int classIndex) {
    cv::Mat values = mask(row, classIndex);
    for (int x = 0; x < kMask_px; ++x) values.col(x).setTo((static_cast<float>(x) + 0.5F) / kMask_px);
  }

  [[nodiscard]] core::Segmentation decode() const {
    return decodeMaskRcnn(detections_, masks_, labels_, image_px_, options_);
  }

  static void expectPixels(const core::Segmentation& segmentation, std::uint16_t id, core::ClassId classId,
                           const cv::Rect& area_px, const cv::Rect& covered_px = {}) {
    cv::Mat expected(segmentation.classIds.size(), CV_8UC1, cv::Scalar(0));
    expected(area_px).setTo(255);
    expected(covered_px).setTo(0);
    EXPECT_EQ(cv::norm(expected, segmentation.instanceIds == id, cv::NORM_INF), 0.0) << "instance " << id;
    EXPECT_EQ(cv::countNonZero((segmentation.classIds != classId) & expected), 0) << "instance " << id;
  }

  cv::Size image_px_{64, 48};
  MaskRcnnDecoderOptions options_;
  LabelMap labels_ = LabelMap::fromFile("labels/coco90.yaml");
  cv::Mat detections_ = test::tensor({1, 1, 5, 7});
  cv::Mat masks_ = test::tensor({5, kClasses, kMask_px, kMask_px});
};

TEST_F(DecodeMaskRcnn, FindsNothingInZeros) {
  const auto segmentation = decode();
  EXPECT_EQ(segmentation.classIds.size(), image_px_);
  EXPECT_EQ(segmentation.instanceIds.type(), CV_16UC1);
  EXPECT_EQ(cv::countNonZero(segmentation.classIds), 0);
  EXPECT_TRUE(segmentation.instances.empty());
}

TEST_F(DecodeMaskRcnn, FillsTheBoxOfASolidMask) {
  addFilled(0, kPerson, 0.8F, {16, 12, 32, 24});
  const auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 1U);
  EXPECT_EQ(segmentation.instances[0].id, 1);
  EXPECT_EQ(segmentation.instances[0].classId, 1);
  EXPECT_FLOAT_EQ(segmentation.instances[0].confidence, 0.8F);
  EXPECT_EQ(segmentation.instances[0].box_px, cv::Rect(16, 12, 32, 24));
  expectPixels(segmentation, 1, 1, {16, 12, 32, 24});
}

TEST_F(DecodeMaskRcnn, TranslatesTheNinetyClasses) {
  addFilled(0, kPerson, 0.9F, {0, 0, 8, 8});
  addFilled(1, kChair, 0.8F, {16, 0, 8, 8});
  addFilled(2, 89, 0.7F, {32, 0, 8, 8});   // toothbrush, category 90
  addFilled(3, 11, 0.99F, {48, 0, 8, 8});  // category 12 was never used
  const auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 3U);
  expectPixels(segmentation, 1, 1, {0, 0, 8, 8});
  expectPixels(segmentation, 2, 57, {16, 0, 8, 8});
  expectPixels(segmentation, 3, 80, {32, 0, 8, 8});
}

TEST_F(DecodeMaskRcnn, TakesTheMaskOfItsRowAndClass) {
  add(0, kPerson, 0.9F, {0, 0, 32, 16});
  mask(0, kPerson + 1).setTo(1.0F);
  mask(1, kPerson).setTo(1.0F);
  EXPECT_TRUE(decode().instances.empty());
  mask(0, kPerson).setTo(1.0F);
  EXPECT_EQ(decode().instances.size(), 1U);
}

TEST_F(DecodeMaskRcnn, CutsTheMaskAtTheThreshold) {
  add(0, kPerson, 0.9F, {16, 12, 32, 24});
  fillRamp(0, kPerson);
  expectPixels(decode(), 1, 1, {32, 12, 16, 24});  // half of the way
  options_.mask_threshold = 0.3;                   // 16 + 0.3 * 32 = 25.6: the centre of pixel 26 is the first beyond
  expectPixels(decode(), 1, 1, {26, 12, 22, 24});
}

TEST_F(DecodeMaskRcnn, StretchesTheMaskOverTheWholeBoxThoughOnlyPartIsInTheImage) {
  add(0, kPerson, 0.9F, {-16, 12, 32, 24});  // half of it: the middle of the mask is the border of the image
  fillRamp(0, kPerson);
  auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 1U);
  EXPECT_EQ(segmentation.instances[0].box_px, cv::Rect(0, 12, 16, 24));
  expectPixels(segmentation, 1, 1, {0, 12, 16, 24});
  options_.mask_threshold = 0.75;
  expectPixels(decode(), 1, 1, {8, 12, 8, 24});
}

// Boxes anywhere between pixels and masks of noise, against the definition of linear interpolation.
TEST_F(DecodeMaskRcnn, InterpolatesAsDefined) {
  cv::RNG random(7);
  options_.max_instances = 1;
  for (int trial = 0; trial < 20; ++trial) {
    cv::Mat values = mask(0, kPerson);
    random.fill(values, cv::RNG::UNIFORM, 0.0, 1.0);
    const cv::Rect2f box(random.uniform(-10.0F, 30.0F), random.uniform(-10.0F, 20.0F), random.uniform(5.0F, 40.0F),
                         random.uniform(5.0F, 40.0F));
    add(0, kPerson, 0.9F, box);
    const auto segmentation = decode();
    const auto at = [&](int y, int x) {
      return double{values.at<float>(std::clamp(y, 0, kMask_px - 1), std::clamp(x, 0, kMask_px - 1))};
    };
    for (int y = 0; y < image_px_.height; ++y) {
      for (int x = 0; x < image_px_.width; ++x) {
        if (!segmentation.instances.empty() && !segmentation.instances[0].box_px.contains({x, y})) continue;
        const double u = (x + 0.5 - box.x) / box.width * kMask_px - 0.5;
        const double v = (y + 0.5 - box.y) / box.height * kMask_px - 0.5;
        const int left = static_cast<int>(std::floor(u));
        const int top = static_cast<int>(std::floor(v));
        const double a = u - left;
        const double b = v - top;
        const double probability = (1 - b) * ((1 - a) * at(top, left) + a * at(top, left + 1)) +
                                   b * ((1 - a) * at(top + 1, left) + a * at(top + 1, left + 1));
        if (std::abs(probability - 0.5) < 0.04) continue;  // OpenCV interpolates in steps of 1/32
        EXPECT_EQ(segmentation.classIds.at<core::ClassId>(y, x), probability > 0.5 ? 1 : 0) << trial << ": " << x << y;
      }
    }
  }
}

TEST_F(DecodeMaskRcnn, PutsTheMoreConfidentOnTopWhateverTheOrder) {
  addFilled(0, kPerson, 0.6F, {0, 0, 32, 32});
  addFilled(1, kChair, 0.7F, {16, 16, 32, 32});
  addFilled(2, kPerson, 0.5F, {20, 20, 8, 8});  // covered whole
  const auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 2U);
  expectPixels(segmentation, 1, 57, {16, 16, 32, 32});
  expectPixels(segmentation, 2, 1, {0, 0, 32, 32}, {16, 16, 16, 16});
}

TEST_F(DecodeMaskRcnn, DropsTheUnsureAndKeepsTheMostConfident) {
  addFilled(0, kPerson, 0.29F, {0, 0, 8, 8});
  addFilled(1, kPerson, 0.31F, {16, 0, 8, 8});
  addFilled(2, kPerson, 0.7F, {32, 0, 8, 8});
  addFilled(3, kPerson, 0.6F, {48, 0, 8, 8});
  EXPECT_EQ(decode().instances.size(), 3U);
  options_.max_instances = 2;
  const auto segmentation = decode();
  ASSERT_EQ(segmentation.instances.size(), 2U);
  expectPixels(segmentation, 1, 1, {32, 0, 8, 8});
  expectPixels(segmentation, 2, 1, {48, 0, 8, 8});
}

TEST_F(DecodeMaskRcnn, SurvivesNumbersThatMakeNoSense) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  addFilled(0, kPerson, kNan, {0, 0, 8, 8});
  addFilled(1, kPerson, 0.9F, {kNan, 0, 8, 8});
  addFilled(2, kPerson, 0.9F, {8, 8, -8, 8});     // right of left
  addFilled(3, kPerson, 0.9F, {100, 100, 8, 8});  // outside
  addFilled(4, kPerson, 0.9F, {0, 0, 8, 8});
  detections_.ptr<float>(0, 0)[7 * 4 + 1] = kClasses;  // there is no such class
  EXPECT_TRUE(decode().instances.empty());
  detections_.ptr<float>(0, 0)[7 * 4 + 1] = -1.0F;
  EXPECT_TRUE(decode().instances.empty());
}

TEST_F(DecodeMaskRcnn, TakesAnyNumberOfDetectionsAndMasks) {
  for (int row = 0; row < 5; ++row) addFilled(row, kPerson, 0.9F, {static_cast<float>(8 * row), 0, 8, 8});
  masks_ = test::tensor({3, kClasses, kMask_px, kMask_px});
  masks_.setTo(1.0F);
  EXPECT_EQ(decode().instances.size(), 3U);
  detections_ = test::tensor({1, 1, 0, 7});
  EXPECT_TRUE(decode().instances.empty());
}

TEST(MaskRcnnClasses, AreToldByTheShapes) {
  EXPECT_EQ(maskRcnnClasses({1, 1, 100, 7}, {100, 90, 15, 15}), 90);
  EXPECT_EQ(maskRcnnClasses({1, 1, 0, 7}, {0, 3, 28, 28}), 3);
  EXPECT_FALSE(maskRcnnClasses({1, 1, 100, 6}, {100, 90, 15, 15}));
  EXPECT_FALSE(maskRcnnClasses({1, 2, 100, 7}, {100, 90, 15, 15}));
  EXPECT_FALSE(maskRcnnClasses({1, 100, 7}, {100, 90, 15, 15}));
  EXPECT_FALSE(maskRcnnClasses({1, 1, 100, 7}, {100, 90, 15}));
  EXPECT_FALSE(maskRcnnClasses({1, 1, 100, 7}, {100, 0, 15, 15}));
  EXPECT_FALSE(maskRcnnClasses({}, {}));
}

}  // namespace
}  // namespace wardslam::segmentation
