#include "redundancy.h"

#include <gtest/gtest.h>

#include <numeric>

#include "graph/hand_made_keyframe.h"
#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

using test::makePose;

/// A camera that comes back to where it saw 20 points, 2 m ahead.
class RedundancyTest : public ::testing::Test {
 protected:
  static constexpr KeyframeId kNewest = 60;
  static constexpr std::size_t kPoints = 20;

  RedundancyTest() {
    options_.witnesses = 2;
    options_.min_share = 0.8;
    options_.min_shared_points = 15;
    options_.min_keyframe_gap = 20;
  }

  void see(KeyframeId id, std::size_t points = kPoints, const Eigen::Isometry3d& T_map_cam = makePose({0, 0, 0})) {
    std::vector<PointId> ids(points);
    std::iota(ids.begin(), ids.end(), 1U);
    graph_.insert(test::handMadeKeyframe(id, ids));
    graph_.setPose(id, T_map_cam);
  }

  [[nodiscard]] bool newestIsRedundant() const { return isRedundant(graph_, kNewest, options_); }

  RedundancyOptions options_;
  KeyframeGraph graph_;
};

TEST_F(RedundancyTest, AsManyWitnessesAreNeededAsAsked) {
  see(1);
  see(kNewest);
  EXPECT_FALSE(newestIsRedundant());
  see(2);
  EXPECT_TRUE(newestIsRedundant());
}

TEST_F(RedundancyTest, WitnessesAreOfAnEarlierVisit) {
  see(1);
  see(kNewest - 19);
  see(kNewest);
  see(kNewest + 30);
  EXPECT_FALSE(newestIsRedundant());
  see(kNewest - 20);
  EXPECT_TRUE(newestIsRedundant());
}

TEST_F(RedundancyTest, WitnessesHaveRecognisedSomeOfThePoints) {
  see(1);
  see(2, 14);
  see(kNewest);
  EXPECT_FALSE(newestIsRedundant());
  see(3, 15);
  EXPECT_TRUE(newestIsRedundant()) << "they need not have recognised all that they have in sight";
}

struct Elsewhere {
  const char* where;
  Eigen::Isometry3d T_map_cam;
  bool seesTheSame;
};

class SecondWitness : public RedundancyTest, public ::testing::WithParamInterface<Elsewhere> {};

TEST_P(SecondWitness, CountsWhereItSeesThePointsAlike) {
  see(1);
  see(2, kPoints, GetParam().T_map_cam);
  see(kNewest);
  EXPECT_EQ(newestIsRedundant(), GetParam().seesTheSame);
}

INSTANTIATE_TEST_SUITE_P(Redundancy, SecondWitness,
                         ::testing::Values(Elsewhere{"a little beside", makePose({0.1, 0, 0}), true},
                                           Elsewhere{"a little behind", makePose({0, 0, -0.3}), true},
                                           Elsewhere{"too far behind", makePose({0, 0, -0.8}), false},
                                           Elsewhere{"so near that the outer points are out of sight",
                                                     makePose({0, 0, 0.9}), false},
                                           Elsewhere{"turned away", makePose({0, 0, 0}, {0, 0.5, 0}), false},
                                           Elsewhere{"behind the points", makePose({0, 0, 4}), false},
                                           Elsewhere{"on the other side", makePose({0, 1.6, 1.2}, {0.9, 0, 0}), false}),
                         [](const auto& place) {
                           std::string name = place.param.where;
                           for (char& c : name) c = c == ' ' ? '_' : c;
                           return name;
                         });

TEST_F(RedundancyTest, TheHeirSharesMost) {
  see(1, 16);
  see(2, kPoints, makePose({1, 0, 0}));
  see(kNewest, kPoints, makePose({1, 2, 0}));
  const auto removed = heirOf(graph_, kNewest);
  EXPECT_EQ(removed.id, kNewest);
  EXPECT_EQ(removed.heir, 2U);
  EXPECT_TRUE(removed.T_heir_cam.isApprox(makePose({0, 2, 0})));
}

TEST_F(RedundancyTest, TheHeirOfWhatStaysInItsPlaceStaysToo) {
  std::vector<PointId> ids(kPoints);
  std::iota(ids.begin(), ids.end(), 1U);
  graph_.restore(test::handMadeKeyframe(1, {1, 2, 3}), {});
  graph_.restore(test::handMadeKeyframe(2, ids), {});
  see(3);
  EXPECT_EQ(heirOf(graph_, 2).heir, 1U) << "3 shares more with it, and may move";
  graph_.unsettle(1);
  EXPECT_EQ(heirOf(graph_, 2).heir, 3U);
}

}  // namespace
}  // namespace wardslam::graph
