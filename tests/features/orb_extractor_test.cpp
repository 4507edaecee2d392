#include "wardslam/features/orb_extractor.h"

#include <gmock/gmock.h>

#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <set>
#include <utility>

namespace wardslam::features {
namespace {

constexpr int kWidth_px = 640;
constexpr int kHeight_px = 480;
constexpr int kCell_px = 32;

/// Blobs of about 4 px whose grey values vary around 128.
cv::Mat blobs(double contrast, std::uint64_t seed) {
  cv::Mat coarse(kHeight_px / 4, kWidth_px / 4, CV_32FC1);
  cv::RNG(seed).fill(coarse, cv::RNG::UNIFORM, 128.0 - contrast, 128.0 + contrast);
  cv::Mat fine;
  cv::resize(coarse, fine, {kWidth_px, kHeight_px}, 0, 0, cv::INTER_CUBIC);
  fine.convertTo(fine, CV_8U);
  return fine;
}

/// A faint pattern all over, a glaring one in a corner of a quarter of width and height.
cv::Mat withABusyCorner() {
  cv::Mat image = blobs(30, 1);
  const cv::Rect corner(0, 0, kWidth_px / 4, kHeight_px / 4);
  blobs(120, 2)(corner).copyTo(image(corner));
  return image;
}

/// Every pixel has a depth of its own: 1000 y + x.
cv::Mat depthThatTellsThePixel() {
  cv::Mat depth_m(kHeight_px, kWidth_px, CV_32FC1);
  depth_m.forEach<float>(
      [](float& value, const int* at) { value = 1000.0F * static_cast<float>(at[0]) + static_cast<float>(at[1]); });
  return depth_m;
}

cv::Mat noDepth() { return cv::Mat::zeros(kHeight_px, kWidth_px, CV_32FC1); }

core::CameraModel distortedCamera() {
  core::CameraModel camera;
  camera.k1 = 0.2624;
  camera.k2 = -0.9531;
  camera.p1 = -0.0054;
  camera.p2 = 0.0026;
  camera.k3 = 1.1633;
  return camera;
}

std::size_t cellsCovered(const std::vector<cv::Point2f>& pixels) {
  std::set<std::pair<int, int>> cells;
  for (const auto& px : pixels) cells.emplace(static_cast<int>(px.x) / kCell_px, static_cast<int>(px.y) / kCell_px);
  return cells.size();
}

std::vector<cv::Point2f> rawPixels(const core::Features& features) {
  std::vector<cv::Point2f> pixels;
  for (const auto& keypoint : features.keypoints) pixels.push_back(keypoint.raw_px);
  return pixels;
}

TEST(OrbExtractor, FindsAsManyKeypointsAsAsked) {
  for (const int count : {200, 1000, 1500}) {
    OrbOptions options;
    options.key_points = count;
    const auto features = OrbExtractor(options).extract(blobs(100, 3), noDepth(), {});
    EXPECT_NEAR(static_cast<double>(features.size()), count, options.levels) << "each level rounds its share";
    EXPECT_EQ(features.descriptors.rows, static_cast<int>(features.size()));
    EXPECT_EQ(features.descriptors.cols, 32);
    EXPECT_EQ(features.descriptors.type(), CV_8UC1);
  }
}

TEST(OrbExtractor, SpreadsThemWherePlainOrbCrowdsThem) {
  const cv::Mat image = withABusyCorner();
  const auto features = OrbExtractor({}).extract(image, noDepth(), {});

  std::vector<cv::KeyPoint> crowd;
  cv::ORB::create(OrbOptions().key_points, 1.2F, 8, 16, 0, 2, cv::ORB::HARRIS_SCORE, 31, 10)->detect(image, crowd);
  std::vector<cv::Point2f> crowdPixels;
  cv::KeyPoint::convert(crowd, crowdPixels);

  constexpr std::size_t kCells = (kWidth_px / kCell_px - 1) * (kHeight_px / kCell_px - 1);  // less a border of 16 px
  EXPECT_LT(cellsCovered(crowdPixels), kCells / 2) << "the image is meant to be hard";
  EXPECT_GT(cellsCovered(rawPixels(features)), kCells * 90 / 100);
}

TEST(OrbExtractor, ComesFinestLevelFirst) {
  const auto features = OrbExtractor({}).extract(blobs(100, 3), noDepth(), {});
  ASSERT_FALSE(features.keypoints.empty());
  EXPECT_EQ(features.keypoints.front().scale, 1.0F);
  EXPECT_NEAR(features.keypoints.back().scale, std::pow(1.2, 7), 1e-4);
  for (std::size_t i = 1; i < features.size(); ++i) {
    EXPECT_GE(features.keypoints[i].scale, features.keypoints[i - 1].scale);
  }
}

/// Eq. 3–5: the direction from the key point to the centre of the grey values in a circle 31 px wide.
double centroidAngle_rad(const cv::Mat& gray, const cv::Point& centre) {
  double m10 = 0;
  double m01 = 0;
  for (int y = -15; y <= 15; ++y) {
    for (int x = -15; x <= 15; ++x) {
      if (x * x + y * y > 15.5 * 15.5) continue;
      const double value = gray.at<uchar>(centre.y + y, centre.x + x);
      m10 += x * value;
      m01 += y * value;
    }
  }
  return std::atan2(m01, m10);
}

TEST(OrbExtractor, TheAngleIsThatOfTheGrayCentroid) {
  const cv::Mat image = blobs(100, 4);
  const auto features = OrbExtractor({}).extract(image, noDepth(), {});
  int compared = 0;
  for (const auto& keypoint : features.keypoints) {
    if (keypoint.scale > 1.0F) continue;  // found in a smaller copy of the image
    const double expected_rad = centroidAngle_rad(image, keypoint.raw_px);
    const double error_rad = std::remainder(static_cast<double>(keypoint.angle_rad) - expected_rad, 2 * CV_PI);
    EXPECT_NEAR(error_rad * 180 / CV_PI, 0.0, 1.0) << keypoint.raw_px;
    ++compared;
  }
  EXPECT_GT(compared, 150);
}

TEST(OrbExtractor, ReadsTheDepthAtTheKeypoint) {
  const auto features = OrbExtractor({}).extract(blobs(100, 5), depthThatTellsThePixel(), distortedCamera());
  ASSERT_FALSE(features.keypoints.empty());
  for (const auto& keypoint : features.keypoints) {
    const int code = static_cast<int>(keypoint.depth_m);
    EXPECT_NEAR(static_cast<double>(keypoint.raw_px.x), code % 1000, 0.501);
    EXPECT_NEAR(static_cast<double>(keypoint.raw_px.y), code / 1000, 0.501);
  }
  for (const auto& keypoint : OrbExtractor({}).extract(blobs(100, 5), noDepth(), {}).keypoints) {
    EXPECT_FALSE(keypoint.hasDepth());
  }
}

/// Left of x = 320 all is at 2 m, right of it at 3 m, or nothing is measured: beside the edge three of nine pixels are
/// 1 m away (or missing), elsewhere none.
TEST(OrbExtractor, TellsHowFarTheDepthsAroundSpread) {
  const auto spreads = [](float right_m) {
    cv::Mat depth_m(480, 640, CV_32FC1, cv::Scalar(2.0));
    depth_m.colRange(320, 640).setTo(right_m);
    int atTheEdge = 0;
    for (const auto& keypoint : OrbExtractor({}).extract(blobs(100, 5), depth_m, {}).keypoints) {
      const bool isAtTheEdge = std::abs(std::round(keypoint.raw_px.x) - 319.5F) < 1.0F && right_m > 0.0F;
      EXPECT_NEAR(keypoint.depthSpread_m, isAtTheEdge ? std::sqrt(1.0F / 3.0F) : 0.0F, 1e-6F) << keypoint.raw_px;
      atTheEdge += isAtTheEdge ? 1 : 0;
    }
    return atTheEdge;
  };
  EXPECT_GT(spreads(3.0F), 0);
  EXPECT_EQ(spreads(0.0F), 0);
}

TEST(OrbExtractor, WithoutADepthImageNoKeypointHasDepth) {
  const auto features = OrbExtractor({}).extract(blobs(100, 5), {}, {});
  EXPECT_EQ(features.size(), OrbExtractor({}).extract(blobs(100, 5), noDepth(), {}).size());
  ASSERT_FALSE(features.keypoints.empty());
  for (const auto& keypoint : features.keypoints) EXPECT_EQ(keypoint.depth_m, 0.0F);
}

TEST(OrbExtractor, UndistortsAsTheCameraDoes) {
  const auto camera = distortedCamera();
  const auto features = OrbExtractor({}).extract(blobs(100, 6), noDepth(), camera);
  const auto expected_px = camera.undistort(rawPixels(features));
  ASSERT_FALSE(features.keypoints.empty());
  double farthest_px = 0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    EXPECT_EQ(features.keypoints[i].undistorted_px, expected_px[i]);
    farthest_px = std::max(farthest_px, cv::norm(expected_px[i] - features.keypoints[i].raw_px));
  }
  EXPECT_GT(farthest_px, 5.0) << "this lens does distort";
}

TEST(OrbExtractor, FillsTheFrame) {
  core::Frame frame;
  frame.gray = blobs(100, 7);
  frame.depth_m = depthThatTellsThePixel();
  const OrbExtractor extractor({});
  extractor.extract(frame);
  EXPECT_EQ(rawPixels(frame.features), rawPixels(extractor.extract(frame.gray, frame.depth_m, frame.camera)));
}

TEST(OrbExtractor, AnImageWithoutCornersHasNone) {
  const OrbExtractor extractor({});
  const cv::Mat flat(kHeight_px, kWidth_px, CV_8UC1, cv::Scalar(128));
  const cv::Mat tiny(16, 16, CV_8UC1, cv::Scalar(128));
  EXPECT_EQ(extractor.extract(flat, noDepth(), {}).size(), 0U);
  EXPECT_EQ(extractor.extract(tiny, cv::Mat::zeros(16, 16, CV_32FC1), {}).size(), 0U);
  EXPECT_EQ(extractor.extract({}, {}, {}).size(), 0U);
}

TEST(OrbExtractor, SameImageSameFeatures) {
  const OrbExtractor extractor({});
  const auto once = extractor.extract(withABusyCorner(), depthThatTellsThePixel(), {});
  const auto again = extractor.extract(withABusyCorner(), depthThatTellsThePixel(), {});
  EXPECT_EQ(rawPixels(once), rawPixels(again));
  EXPECT_EQ(cv::norm(once.descriptors, again.descriptors, cv::NORM_HAMMING), 0.0);
}

}  // namespace
}  // namespace wardslam::features
