#include "wardslam/odometry/matcher.h"

#include <gmock/gmock.h>

#include <set>

namespace wardslam::odometry {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Pairs = std::vector<std::pair<PointId, std::size_t>>;

/// The bits [first, first + count) are set: two of them differ in as many bits as they do not share.
OrbDescriptor bits(int first, int count) {
  OrbDescriptor descriptor{};
  for (int bit = first; bit < first + count; ++bit) {
    auto& byte = descriptor[static_cast<std::size_t>(bit / 8)];
    byte = static_cast<std::uint8_t>(byte | (1U << (bit % 8)));
  }
  return descriptor;
}

/// Hand-made descriptors in an image; default options: at most 80 bits apart, at most 0.9 of the second best.
class MatcherTest : public ::testing::Test {
 protected:
  std::size_t addKeypoint(float x_px, float y_px, OrbDescriptor descriptor, float scale = 1.0F) {
    core::Keypoint keypoint;
    keypoint.undistorted_px = {x_px, y_px};
    keypoint.scale = scale;
    features_.keypoints.push_back(keypoint);
    features_.descriptors.push_back(cv::Mat(1, 32, CV_8UC1, descriptor.data()));
    return features_.size() - 1;
  }

  [[nodiscard]] Pairs searchNear(const std::vector<ProjectedPoint>& points, double radius_px = 10) const {
    return pairs(matcher_.searchNear(points, features_, KeypointGrid(features_.keypoints, {}), radius_px));
  }
  [[nodiscard]] Pairs searchEverywhere(const std::vector<DescribedPoint>& points) const {
    return pairs(matcher_.searchEverywhere(points, features_));
  }

  const OrbDescriptor zero_ = bits(0, 0);
  core::Features features_;

 private:
  [[nodiscard]] static Pairs pairs(const std::vector<Match>& matches) {
    Pairs result;
    for (const Match& match : matches) result.emplace_back(match.point, match.keypoint);
    return result;
  }

  static MatcherOptions options() {
    MatcherOptions options;
    options.max_descriptor_distance = 80;
    options.max_ratio = 0.9;
    return options;
  }

  Matcher matcher_{options()};
};

TEST_F(MatcherTest, TakesTheMostSimilarWithinTheRadius) {
  addKeypoint(100, 100, bits(0, 60));
  addKeypoint(104, 103, bits(0, 20));  // 5 px away
  addKeypoint(120, 100, bits(0, 0));   // equal, but too far away
  const ProjectedPoint point{7, &zero_, {100, 100}, 1.0};
  EXPECT_THAT(searchNear({point}), ElementsAre(std::pair(7, 1)));
  EXPECT_THAT(searchNear({point}, 4.9), ElementsAre(std::pair(7, 0)));
  EXPECT_THAT(searchNear({point}, 25), ElementsAre(std::pair(7, 2)));
}

TEST_F(MatcherTest, TheRadiusGrowsWithTheScale) {
  addKeypoint(112, 100, bits(0, 10), 1.44F);
  EXPECT_THAT(searchNear({{7, &zero_, {100, 100}, 1.44}}), ElementsAre(std::pair(7, 0)));
  EXPECT_THAT(searchNear({{7, &zero_, {100, 100}, 1.1}}), IsEmpty());
}

TEST_F(MatcherTest, LeavesOutKeypointsOfAnotherScale) {
  addKeypoint(100, 100, bits(0, 10), 1.0F);
  EXPECT_THAT(searchNear({{7, &zero_, {100, 100}, 1.44}}), ElementsAre(std::pair(7, 0)));
  EXPECT_THAT(searchNear({{7, &zero_, {100, 100}, 1.6}}), IsEmpty());
  EXPECT_THAT(searchNear({{7, &zero_, {100, 100}, 0.6}}), IsEmpty());
}

TEST_F(MatcherTest, RefusesWhatIsNotSimilar) {
  addKeypoint(100, 100, bits(0, 81));
  EXPECT_THAT(searchNear({{7, &zero_, {100, 100}, 1.0}}), IsEmpty());
  addKeypoint(300, 100, bits(0, 80));
  EXPECT_THAT(searchNear({{7, &zero_, {300, 100}, 1.0}}), ElementsAre(std::pair(7, 1)));
}

TEST_F(MatcherTest, RefusesWhatIsNotClearlyTheBest) {
  addKeypoint(100, 100, bits(0, 45));
  addKeypoint(102, 100, bits(100, 49));  // 45 of 49 is more than 0.9
  addKeypoint(300, 100, bits(0, 45));
  addKeypoint(302, 100, bits(100, 50));  // 45 of 50 is not
  EXPECT_THAT(searchNear({{7, &zero_, {100, 100}, 1.0}}), IsEmpty());
  EXPECT_THAT(searchNear({{7, &zero_, {300, 100}, 1.0}}), ElementsAre(std::pair(7, 2)));
}

TEST_F(MatcherTest, AKeypointGoesToThePointThatResemblesItMost) {
  addKeypoint(100, 100, zero_);
  const OrbDescriptor near = bits(0, 10);
  const OrbDescriptor far = bits(0, 30);
  const ProjectedPoint poor{7, &far, {100, 100}, 1.0};
  const ProjectedPoint good{8, &near, {101, 100}, 1.0};
  EXPECT_THAT(searchNear({poor, good}), ElementsAre(std::pair(8, 0)));
  EXPECT_THAT(searchNear({good, poor}), ElementsAre(std::pair(8, 0)));
}

TEST_F(MatcherTest, FindsPointsAnywhereByLooksAlone) {
  addKeypoint(10, 10, bits(0, 60));
  addKeypoint(600, 400, bits(100, 60));
  const OrbDescriptor first = bits(0, 50);
  const OrbDescriptor second = bits(100, 70);
  EXPECT_THAT(searchEverywhere({{7, &second}, {8, &first}}), ElementsAre(std::pair(7, 1), std::pair(8, 0)));
}

TEST_F(MatcherTest, AnywhereTheBestMustBeMutualClearAndSimilar) {
  addKeypoint(10, 10, bits(0, 60));
  addKeypoint(600, 400, bits(60, 60));
  const OrbDescriptor good = bits(0, 55);
  const OrbDescriptor poor = bits(0, 40);
  EXPECT_THAT(searchEverywhere({{7, &poor}, {8, &good}}), ElementsAre(std::pair(8, 0))) << "one key point, one point";

  const OrbDescriptor between = bits(30, 60);  // 60 bits from the first, 60 from the second
  EXPECT_THAT(searchEverywhere({{7, &between}}), IsEmpty());
  addKeypoint(300, 300, bits(200, 30));
  addKeypoint(400, 300, bits(200, 29));
  const OrbDescriptor oneOfTwo = bits(200, 19);  // 11 bits from one, 10 from the next
  EXPECT_THAT(searchEverywhere({{7, &oneOfTwo}}), IsEmpty());
  const OrbDescriptor stranger = bits(170, 80);
  EXPECT_THAT(searchEverywhere({{7, &stranger}}), IsEmpty());
}

TEST_F(MatcherTest, NothingToSearchFindsNothing) {
  EXPECT_THAT(searchNear({{7, &zero_, {100, 100}, 1.0}}), IsEmpty());
  EXPECT_THAT(searchEverywhere({{7, &zero_}}), IsEmpty());
  addKeypoint(100, 100, zero_);
  addKeypoint(200, 100, bits(0, 60));
  EXPECT_THAT(searchNear({}), IsEmpty());
  EXPECT_THAT(searchEverywhere({}), IsEmpty());
}

}  // namespace
}  // namespace wardslam::odometry
