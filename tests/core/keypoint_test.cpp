#include "wardslam/core/keypoint.h"

#include <gtest/gtest.h>

namespace wardslam::core {
namespace {

/// Key point i lies at x = i and has a descriptor full of i.
Features makeFeatures(const std::vector<Motion>& motions) {
  Features features;
  features.descriptors.create(static_cast<int>(motions.size()), 32, CV_8UC1);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    Keypoint keypoint;
    keypoint.raw_px.x = static_cast<float>(i);
    keypoint.motion = motions[i];
    features.keypoints.push_back(keypoint);
    features.descriptors.row(static_cast<int>(i)).setTo(static_cast<double>(i));
  }
  return features;
}

TEST(DepthSigma, IsThatOfTheSensorAndOfTheDepthsAround) {
  Keypoint keypoint;
  keypoint.depth_m = 1.4F;
  const DepthNoise noise{0.002, 0.001, 0.4};  // 2 mm + 1 mm at 1.4 m
  EXPECT_NEAR(depthSigma_m(keypoint, noise), 0.003, 1e-8);
  keypoint.depthSpread_m = 0.004F;
  EXPECT_NEAR(depthSigma_m(keypoint, noise), 0.005, 1e-8);
}

TEST(SelectStatic, KeepsDescriptorsWithTheirKeypoints) {
  const Features kept =
      selectStatic(makeFeatures({Motion::Dynamic, Motion::Static, Motion::Dynamic, Motion::Static, Motion::Static}));
  ASSERT_EQ(kept.size(), 3U);
  ASSERT_EQ(kept.descriptors.rows, 3);
  ASSERT_EQ(kept.descriptors.cols, 32);
  const float expected[] = {1, 3, 4};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(kept.keypoints[static_cast<std::size_t>(i)].raw_px.x, expected[i]);
    EXPECT_EQ(static_cast<float>(kept.descriptors.at<std::uint8_t>(i, 31)), expected[i]);
  }
}

TEST(SelectStatic, DoesNotShareMemoryWithItsInput) {
  Features features = makeFeatures({Motion::Static});
  const Features kept = selectStatic(features);
  features.descriptors.setTo(99);
  EXPECT_EQ(kept.descriptors.at<std::uint8_t>(0, 0), 0);
}

TEST(SelectStatic, NothingStaticIsEmpty) {
  EXPECT_EQ(selectStatic(makeFeatures({Motion::Dynamic, Motion::Dynamic})).size(), 0U);
  EXPECT_EQ(selectStatic(makeFeatures({Motion::Dynamic})).descriptors.rows, 0);
  EXPECT_EQ(selectStatic(Features{}).size(), 0U);
}

TEST(Keypoint, DepthZeroMeansNone) {
  Keypoint keypoint;
  EXPECT_FALSE(keypoint.hasDepth());
  keypoint.depth_m = 0.4F;
  EXPECT_TRUE(keypoint.hasDepth());
}

TEST(SemanticDescriptors, DifferByTheShareOfTheirCells) {
  EXPECT_EQ(differenceOf({1, 2, 3, 4}, {1, 2, 3, 4}), 0.0);
  EXPECT_EQ(differenceOf({1, 2, 3, 4}, {1, 9, 3, 200}), 0.5) << "how far apart the cells are does not count";
  EXPECT_EQ(differenceOf({1}, {2}), 1.0);
}

TEST(SemanticDescriptors, ThatCannotBeComparedTellNothing) {
  EXPECT_EQ(differenceOf({}, {}), std::nullopt);
  EXPECT_EQ(differenceOf({1}, {}), std::nullopt);
  EXPECT_EQ(differenceOf({1}, {1, 2}), std::nullopt);
}

TEST(SemanticDescriptors, StayWithTheStaticFeatures) {
  class Nothing : public SemanticDescriptorSource {
    [[nodiscard]] SemanticDescriptor of(const Keypoint&) const override { return {}; }
  };
  Features features = makeFeatures({Motion::Static});
  features.semanticDescriptors = std::make_shared<Nothing>();
  EXPECT_EQ(selectStatic(features).semanticDescriptors, features.semanticDescriptors);
}

}  // namespace
}  // namespace wardslam::core
