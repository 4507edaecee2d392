#include "wardslam/features/semantic_descriptor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace wardslam::features {
namespace {

constexpr float kPi = 3.14159265F;

core::Keypoint keypointAt(float x, float y, float angle_rad = 0.0F) {
  core::Keypoint keypoint;
  keypoint.raw_px = {x, y};
  keypoint.angle_rad = angle_rad;
  return keypoint;
}

cv::Mat randomClasses(int rows, int cols) {
  cv::Mat classes(rows, cols, CV_8UC1);
  cv::RNG(7).fill(classes, cv::RNG::UNIFORM, 0, 5);
  return classes;
}

/// Regions with smooth borders, as masks have; the class depends on the direction seen from the centre.
cv::Mat sectors(int size, float turnedBy_rad) {
  cv::Mat classes(size, size, CV_8UC1);
  const auto centre = static_cast<float>(size / 2);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const float dx = static_cast<float>(x) - centre;
      const float dy = static_cast<float>(y) - centre;
      const float angle = std::remainder(std::atan2(dy, dx) - turnedBy_rad, 2 * kPi);
      const int ring = std::hypot(dx, dy) > 7.0F ? 4 : 0;
      classes.at<uchar>(y, x) = static_cast<uchar>(1 + ring + (angle > 0.5F) + (angle > 2.0F) + (angle > -1.0F));
    }
  }
  return classes;
}

bool equal(const cv::Mat& a, const cv::Mat& b) { return a.size() == b.size() && cv::countNonZero(a != b) == 0; }

int cellsThatDiffer(const cv::Mat& a, const cv::Mat& b) { return cv::countNonZero(a != b); }

TEST(SemanticDescriptor, IsTheUprightPatchAroundAnUnturnedKeyPoint) {
  // In the spirit of Fig. 3: a key point on a bed (60) with a nurse (1) beside it and background (0).
  const cv::Mat classes = (cv::Mat_<uchar>(7, 7) <<  //
                               0,
                           0, 0, 0, 0, 0, 0,          //
                           0, 0, 0, 1, 1, 1, 0,       //
                           0, 0, 60, 60, 1, 1, 0,     //
                           0, 60, 60, 60, 1, 1, 0,    //
                           0, 60, 60, 60, 60, 1, 0,   //
                           0, 60, 60, 60, 60, 60, 0,  //
                           0, 0, 0, 0, 0, 0, 0);
  const cv::Mat expected = (cv::Mat_<uchar>(5, 5) <<  //
                                0,
                            0, 1, 1, 1,         //
                            0, 60, 60, 1, 1,    //
                            60, 60, 60, 1, 1,   //
                            60, 60, 60, 60, 1,  //
                            60, 60, 60, 60, 60);
  EXPECT_TRUE(equal(describeSemantics(classes, keypointAt(3, 3), 5), expected));
}

TEST(SemanticDescriptor, TurnsThePatchByTheKeyPointsAngle) {
  // Angles grow from x to y (down): at 90° the first row of the descriptor runs down the image, on the right.
  const cv::Mat classes = (cv::Mat_<uchar>(3, 3) << 1, 2, 3, 4, 5, 6, 7, 8, 9);
  const cv::Mat quarter = (cv::Mat_<uchar>(3, 3) << 3, 6, 9, 2, 5, 8, 1, 4, 7);
  const cv::Mat half = (cv::Mat_<uchar>(3, 3) << 9, 8, 7, 6, 5, 4, 3, 2, 1);
  EXPECT_TRUE(equal(describeSemantics(classes, keypointAt(1, 1, kPi / 2), 3), quarter));
  EXPECT_TRUE(equal(describeSemantics(classes, keypointAt(1, 1, kPi), 3), half));
  EXPECT_TRUE(equal(describeSemantics(classes, keypointAt(1, 1, -kPi), 3), half));
}

TEST(SemanticDescriptor, DoesNotChangeWhenTheImageTurnsByAQuarter) {
  const cv::Mat classes = randomClasses(60, 80);
  cv::Mat turned;
  cv::rotate(classes, turned, cv::ROTATE_90_CLOCKWISE);  // (x, y) goes to (rows - 1 - y, x)
  for (const auto& [x, y] : {std::pair{40, 30}, {17, 44}, {63, 12}, {0, 0}, {79, 59}}) {
    const auto before = describeSemantics(classes, keypointAt(static_cast<float>(x), static_cast<float>(y)), 21);
    const auto after =
        describeSemantics(turned, keypointAt(static_cast<float>(59 - y), static_cast<float>(x), kPi / 2), 21);
    EXPECT_EQ(cellsThatDiffer(before, after), 0) << x << ", " << y;
  }
}

TEST(SemanticDescriptor, HardlyChangesWhenTheImageTurnsByAnyAngle) {
  constexpr int n = 21;
  constexpr int kFew = n * n / 10;  // along the borders between classes
  const cv::Mat upright = describeSemantics(sectors(101, 0.0F), keypointAt(50, 50), n);
  for (float angle = -3.1F; angle < 3.1F; angle += 0.2F) {
    const cv::Mat image = sectors(101, angle);
    EXPECT_LE(cellsThatDiffer(upright, describeSemantics(image, keypointAt(50, 50, angle), n)), kFew) << angle;
    if (std::abs(angle) > 0.3F) {
      EXPECT_GT(cellsThatDiffer(upright, describeSemantics(image, keypointAt(50, 50), n)), kFew)
          << "unless turned with it, at " << angle;
    }
  }
}

TEST(SemanticDescriptor, CellsOutsideTheImageAreUnclassified) {
  const cv::Mat classes(4, 4, CV_8UC1, cv::Scalar(9));
  const cv::Mat corner = (cv::Mat_<uchar>(3, 3) << 0, 0, 0, 0, 9, 9, 0, 9, 9);
  EXPECT_TRUE(equal(describeSemantics(classes, keypointAt(0, 0), 3), corner));
  EXPECT_EQ(cv::countNonZero(describeSemantics(classes, keypointAt(3, 3), 5)), 9);
  EXPECT_NEAR(cv::countNonZero(describeSemantics(classes, keypointAt(1, 1, 0.6F), 21)), 16, 2) << "all sixteen pixels";
  EXPECT_EQ(cv::countNonZero(describeSemantics(classes, keypointAt(100, 100), 3)), 0);
}

TEST(SemanticDescriptor, TakesTheNearestPixel) {
  const cv::Mat classes = (cv::Mat_<uchar>(1, 4) << 1, 2, 3, 4);
  EXPECT_EQ(describeSemantics(classes, keypointAt(1.4F, 0.3F), 1).at<uchar>(0), 2);
  EXPECT_EQ(describeSemantics(classes, keypointAt(1.6F, -0.3F), 1).at<uchar>(0), 3);
}

TEST(SemanticDescriptor, AgreesWithTheFormulaInFloatingPoint) {
  const cv::Mat classes = randomClasses(60, 80);
  constexpr int n = 55;
  for (float angle = -3.0F; angle < 3.0F; angle += 0.37F) {
    const cv::Mat descriptor = describeSemantics(classes, keypointAt(41.3F, 28.7F, angle), n);
    int wrong = 0;
    for (int row = 0; row < n; ++row) {
      for (int col = 0; col < n; ++col) {
        const double dx = col - n / 2;
        const double dy = row - n / 2;
        const auto u = std::lround(41.3 + std::cos(angle) * dx - std::sin(angle) * dy);
        const auto v = std::lround(28.7 + std::sin(angle) * dx + std::cos(angle) * dy);
        const bool isInside = u >= 0 && v >= 0 && u < 80 && v < 60;
        const int expected = isInside ? classes.at<uchar>(static_cast<int>(v), static_cast<int>(u)) : 0;
        wrong += descriptor.at<uchar>(row, col) != expected;
      }
    }
    EXPECT_LE(wrong, 3) << "of 3025: samples halfway between two pixels, at " << angle;
  }
}

TEST(SemanticDescriptor, ManyAtOnceAreTheSameAsOneByOne) {
  const cv::Mat classes = randomClasses(60, 80);
  const std::vector<core::Keypoint> keypoints = {keypointAt(3, 50, 1.0F), keypointAt(40, 30, -2.0F), keypointAt(79, 0)};
  const cv::Mat all = describeSemantics(classes, keypoints, 21);
  ASSERT_EQ(all.size(), cv::Size(441, 3));
  for (int i = 0; i < 3; ++i) {
    const cv::Mat one = describeSemantics(classes, keypoints[static_cast<std::size_t>(i)], 21);
    EXPECT_TRUE(equal(all.row(i), one.reshape(1, 1))) << i;
  }
  EXPECT_EQ(describeSemantics(classes, std::vector<core::Keypoint>(), 21).rows, 0);
}

TEST(SemanticDescriptor, ReadsAnImageThatIsPartOfALargerOne) {
  const cv::Mat larger = randomClasses(90, 120);
  const cv::Mat part = larger(cv::Rect(13, 17, 80, 60));
  const auto keypoint = keypointAt(40.4F, 30.2F, 0.8F);
  EXPECT_TRUE(equal(describeSemantics(part, keypoint, 21), describeSemantics(part.clone(), keypoint, 21)));
}

TEST(SemanticDescriptor, NearTheBorderItIsThatOfAWiderImageCut) {
  // The wider image is the same with zeros around, so that the patch lies inside of it.
  const cv::Mat classes = randomClasses(60, 80);
  cv::Mat wider;
  cv::copyMakeBorder(classes, wider, 50, 50, 50, 50, cv::BORDER_CONSTANT, cv::Scalar(0));
  for (float x = 0.0F; x < 80.0F; x += 3.125F) {
    for (float y = 0.0F; y < 60.0F; y += 3.125F) {
      const float angle = x - y;
      const auto cut = describeSemantics(classes, keypointAt(x, y, angle), 21);
      EXPECT_TRUE(equal(cut, describeSemantics(wider, keypointAt(x + 50.0F, y + 50.0F, angle), 21))) << x << ", " << y;
    }
  }
}

TEST(SemanticDescriptor, RefusesWhatIsNoPatch) {
  const cv::Mat classes(4, 4, CV_8UC1, cv::Scalar(0));
  EXPECT_THROW(static_cast<void>(describeSemantics(classes, keypointAt(1, 1), 4)), cv::Exception);
  EXPECT_THROW(static_cast<void>(describeSemantics(classes, keypointAt(1, 1), -1)), cv::Exception);
  EXPECT_THROW(static_cast<void>(describeSemantics(cv::Mat(4, 4, CV_16UC1), keypointAt(1, 1), 3)), cv::Exception);
}

TEST(SemanticDescriptors, AreTheDescriptors) {
  const cv::Mat classes = randomClasses(60, 80);
  const SemanticDescriptors semanticDescriptors(classes, 21);
  for (const auto& keypoint : {keypointAt(40, 30), keypointAt(2, 57, 1.0F), keypointAt(79, 0, -2.5F)}) {
    const core::SemanticDescriptor cells = semanticDescriptors.of(keypoint);
    ASSERT_EQ(cells.size(), 441U);
    const cv::Mat expected = describeSemantics(classes, keypoint, 21);
    EXPECT_TRUE(std::equal(cells.begin(), cells.end(), expected.ptr<uchar>()));
  }
}

TEST(SemanticDescriptors, OfThePapersExampleDifferInTwoCells) {
  // Fig. 4, by the functions that matching calls. The two tables differ in one cell of the first row; the second
  // difference is the centre, P and P'.
  const cv::Mat p = (cv::Mat_<uchar>(5, 5) <<  //
                         1,
                     1, 1, 3, 3,     //
                     2, 1, 1, 3, 3,  //
                     2, 2, 2, 3, 4,  //
                     2, 9, 9, 4, 4,  //
                     9, 9, 4, 4, 4);
  cv::Mat q = p.clone();
  q.at<uchar>(0, 2) = 3;
  q.at<uchar>(2, 2) = 9;
  const auto ofP = SemanticDescriptors(p, 5).of(keypointAt(2, 2));
  const auto ofQ = SemanticDescriptors(q, 5).of(keypointAt(2, 2));
  EXPECT_EQ(core::differenceOf(ofP, ofQ), 2.0 / 25.0);
  EXPECT_EQ(core::differenceOf(ofQ, ofP), 2.0 / 25.0);
  EXPECT_EQ(core::differenceOf(ofP, ofP), 0.0);
}

}  // namespace
}  // namespace wardslam::features
