#include "floors.h"

#include <gmock/gmock.h>

#include "graph/floor_walk.h"
#include "graph/hand_made_keyframe.h"
#include "graph/mapper_walk.h"
#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

using test::FloorWalk;
using test::SyntheticWalk;
using ::testing::Each;

constexpr double kDegree = M_PI / 180.0;
constexpr std::size_t kShared = 3;

class FloorsTest : public ::testing::Test {
 protected:
  void insert(const std::shared_ptr<odometry::Keyframe>& keyframe) {
    graph_.insert(keyframe);
    findFloor(graph_, keyframe->id, kShared);
  }

  void drive(const FloorWalk& walk, KeyframeId first, KeyframeId last,
             const Eigen::Isometry3d& slip = Eigen::Isometry3d::Identity()) {
    for (KeyframeId id = first; id <= last; ++id) insert(walk.keyframe(id, slip));
  }

  [[nodiscard]] KeyframeId floorOf(KeyframeId id) const { return graph_.keyframes().at(id).floor; }
  [[nodiscard]] std::vector<KeyframeId> floorsOf(KeyframeId first, KeyframeId last) const {
    std::vector<KeyframeId> floors;
    for (KeyframeId id = first; id <= last; ++id) floors.push_back(floorOf(id));
    return floors;
  }

  /// It sees points, too.
  [[nodiscard]] static std::shared_ptr<odometry::Keyframe> seeing(std::shared_ptr<odometry::Keyframe> keyframe,
                                                                  const std::vector<PointId>& points) {
    const auto other = test::handMadeKeyframe(keyframe->id, points);
    keyframe->features = other->features;
    keyframe->sightings = other->sightings;
    return keyframe;
  }

  KeyframeGraph graph_;
};

TEST_F(FloorsTest, LevelGroundIsOneFloor) {
  drive(FloorWalk(test::levelGround), 1, 30);
  EXPECT_THAT(floorsOf(1, 30), Each(1U));
  EXPECT_EQ(graph::floorsOf(graph_).at(1).size(), 30U);
}

TEST_F(FloorsTest, ARampIsAnotherAndWhatComesAfterIt) {
  drive(FloorWalk(test::ramp), 1, 40);
  EXPECT_THAT(floorsOf(1, 5), Each(1U)) << "from 1.5 m on it sees the ramp";
  EXPECT_THAT(floorsOf(11, 15), Each(floorOf(11))) << "stands on the ramp and sees it";
  EXPECT_NE(floorOf(11), 1U);
  EXPECT_THAT(floorsOf(24, 40), Each(floorOf(24)));
  EXPECT_NE(floorOf(24), 1U) << "16 cm higher";
  EXPECT_NE(floorOf(24), floorOf(11));
}

TEST_F(FloorsTest, AStepIsTheEndOfAFloor) {
  drive(FloorWalk([](double x_m) { return x_m < 4.0 ? 0.0 : 0.15; }), 1, 40);
  EXPECT_THAT(floorsOf(1, 5), Each(1U));
  EXPECT_THAT(floorsOf(25, 40), Each(floorOf(40)));
  EXPECT_NE(floorOf(40), 1U);
}

TEST_F(FloorsTest, AThresholdIsNot) {
  drive(FloorWalk([](double x_m) { return x_m < 4.0 ? 0.0 : 0.015; }), 1, 40);
  EXPECT_EQ(floorOf(40), 1U);
}

TEST_F(FloorsTest, AnotherStoreyIsAnother) {
  drive(FloorWalk(test::levelGround), 1, 10);
  const FloorWalk lift([](double x_m) { return x_m < 2.9 ? 0.0 : 3.2; });
  drive(lift, 11, 20);
  EXPECT_NEAR(graph_.keyframes().at(11).T_map_cam.translation().z(), 4.3, 1e-9);
  EXPECT_THAT(floorsOf(1, 10), Each(1U));
  EXPECT_THAT(floorsOf(11, 20), Each(11U));
}

TEST_F(FloorsTest, AFloorThatBendsIsNotOnePlane) {
  drive(FloorWalk(test::levelGround), 1, 40, test::makePose(Eigen::Vector3d::Zero(), {0.1 * kDegree, 0.0, 0.0}));
  EXPECT_THAT(floorsOf(1, 10), Each(1U));
  EXPECT_NE(floorOf(40), 1U) << "each step agrees with the one before, 4 degrees do not";
}

TEST_F(FloorsTest, WithoutGroundThereIsNone) {
  const FloorWalk walk(test::levelGround);
  for (KeyframeId id = 1; id <= 5; ++id) {
    auto keyframe = walk.keyframe(id);
    keyframe->ground.reset();
    insert(keyframe);
  }
  EXPECT_THAT(floorsOf(1, 5), Each(0U));
  EXPECT_TRUE(graph::floorsOf(graph_).empty());
}

TEST_F(FloorsTest, IsFoundAgainWhereTheSameIsSeen) {
  const FloorWalk walk(test::levelGround);
  insert(seeing(walk.keyframe(1), {1, 2, 3}));
  for (KeyframeId id = 2; id <= 30; ++id) {  // 8.7 m without ground in sight
    auto keyframe = walk.keyframe(id);
    keyframe->ground.reset();
    insert(keyframe);
  }
  insert(walk.keyframe(31));
  EXPECT_EQ(floorOf(31), 31U) << "too far to know";
  graph_.setPose(31, walk.T_map_cam(2));
  auto back = seeing(walk.keyframe(2), {1, 2, 3});
  back->id = 32;
  back->T_previous_cam = Eigen::Isometry3d::Identity();
  insert(back);
  EXPECT_EQ(floorOf(32), 31U) << "as the one before";
  EXPECT_EQ(floorOf(1), 31U) << "and both are one floor";
}

TEST_F(FloorsTest, OfAnotherPieceIsNone) {
  const FloorWalk walk(test::levelGround);
  insert(walk.keyframe(1));
  auto other = walk.keyframe(2);
  other->submap = 2;
  insert(other);
  EXPECT_EQ(floorOf(2), 2U);
}

TEST_F(FloorsTest, AStepOrARampIsAnotherHoweverUnsureAViewIs) {
  const FloorWalk walk(test::levelGround);
  const auto standsWithTheOneBefore = [&](double step_m, double tilt_rad) {
    graph_ = KeyframeGraph();
    insert(walk.keyframe(1));
    auto unsure = walk.keyframe(2);
    unsure->ground->height_m += step_m;
    unsure->ground->normal_cam = Eigen::AngleAxisd(tilt_rad, Eigen::Vector3d::UnitX()) * unsure->ground->normal_cam;
    unsure->ground->covariance = Eigen::Vector3d(0.1, 0.1, 0.3).cwiseAbs2().asDiagonal();
    insert(unsure);
    return floorOf(2) == 1U;
  };
  EXPECT_TRUE(standsWithTheOneBefore(0.04, 0.02));
  EXPECT_FALSE(standsWithTheOneBefore(0.07, 0.0));
  EXPECT_FALSE(standsWithTheOneBefore(0.0, 0.035)) << "2 degrees";
}

TEST_F(FloorsTest, FewerThanThreeTellNothing) {
  drive(FloorWalk(test::levelGround), 1, 2);
  EXPECT_TRUE(graph::floorsOf(graph_).empty());
}

TEST_F(FloorsTest, APlaneIsFittedToWhatIsSeenFromAll) {
  const Eigen::Isometry3d leaning = test::makePose({0.0, 0.0, 0.5}, {0.02, -0.03, 0.0});
  drive(FloorWalk(test::levelGround), 1, 20);
  std::set<KeyframeId> all;
  for (KeyframeId id = 1; id <= 20; ++id) {
    graph_.setPose(id, leaning * graph_.keyframes().at(id).T_map_cam);
    all.insert(id);
  }
  const Floor floor = fitFloor(graph_, all);
  EXPECT_LT((floor.normal_map - leaning.linear() * Eigen::Vector3d::UnitZ()).norm(), 1e-6);
  EXPECT_NEAR(floor.under(graph_.keyframes().at(1).T_map_cam).height_m, FloorWalk::kEye_m, 1e-6);
  EXPECT_NEAR(floor.under(graph_.keyframes().at(20).T_map_cam).height_m, FloorWalk::kEye_m, 1e-6);
}

TEST_F(FloorsTest, AStrayViewWeighsLittle) {
  const FloorWalk walk(test::levelGround);
  std::set<KeyframeId> all;
  for (KeyframeId id = 1; id <= 20; ++id) {
    auto keyframe = walk.keyframe(id);
    if (id == 10) keyframe->ground->height_m += 0.5;
    graph_.insert(keyframe);
    all.insert(id);
  }
  const double height_m = fitFloor(graph_, all).under(walk.T_map_cam(10)).height_m;
  EXPECT_NEAR(height_m, FloorWalk::kEye_m, 0.003) << "a mean would be off by 25 mm";
}

/// Keyframes of a level walk, with the floor in sight or without.
std::vector<std::shared_ptr<const odometry::Keyframe>> levelWalk(bool seesFloor) {
  SyntheticWalk walk({0.5, 0.5, 10}, 1500);
  std::vector<std::shared_ptr<const odometry::Keyframe>> keyframes;
  for (int i = 0; i < 10; ++i) {
    const auto keyframe = walk.step();
    if (seesFloor) {
      keyframe->ground = core::GroundPlane{-Eigen::Vector3d::UnitY(), 1.2, Eigen::Matrix3d::Identity() * 1e-6};
    }
    keyframes.push_back(keyframe);
  }
  return keyframes;
}

KeyframeGraph graphOf(const std::vector<std::shared_ptr<const odometry::Keyframe>>& keyframes, bool floor) {
  GraphOptions options = fewAndFast();
  options.floor = floor;
  Mapper mapper(options, {});
  for (const auto& keyframe : keyframes) static_cast<void>(mapper.insert(keyframe));
  return mapper.graph();
}

TEST(MapperFloor, KeyframesStandOnTheFloorTheySee) {
  const auto keyframes = levelWalk(true);
  const KeyframeGraph with = graphOf(keyframes, true);
  const KeyframeGraph without = graphOf(keyframes, false);
  for (const auto& [id, node] : with.keyframes()) EXPECT_EQ(node.floor, 1U);
  for (const auto& [id, node] : without.keyframes()) EXPECT_EQ(node.floor, 0U);
}

TEST(MapperFloor, IsKnownOfAnEarlierRun) {
  const SavedGraph saved = save(graphOf(levelWalk(true), true));
  Mapper mapper(fewAndFast(), {});
  mapper.restore(saved);
  for (const auto& [id, node] : mapper.graph().keyframes()) EXPECT_EQ(node.floor, 1U);
}

TEST(MapperFloor, WithoutOneInSightNothingChanges) {
  const auto keyframes = levelWalk(false);
  const KeyframeGraph with = graphOf(keyframes, true);
  const KeyframeGraph without = graphOf(keyframes, false);
  for (const auto& [id, node] : with.keyframes())
    EXPECT_EQ(node.T_map_cam.matrix(), without.keyframes().at(id).T_map_cam.matrix());
}

/// Two runs over level ground, each with a floor of its own; the second's map is off by so much.
class TwoRunsOnOneFloor : public FloorsTest {
 protected:
  bool uniteWith(const Eigen::Isometry3d& off) {
    drive(FloorWalk(test::levelGround), 1, 10);
    for (KeyframeId id = 11; id <= 20; ++id) {
      const auto keyframe = FloorWalk(test::levelGround).keyframe(id);
      keyframe->submap = 2;
      keyframe->T_previous_cam.reset();
      keyframe->T_map_cam = off * keyframe->T_map_cam;
      insert(keyframe);
    }
    EXPECT_NE(floorOf(15), 1U) << "nothing is known of the other run";
    return uniteFloors(graph_, 10, 11);
  }
};

TEST_F(TwoRunsOnOneFloor, IsOneFloorOnceTheyAreKnownToBeInOnePlace) {
  EXPECT_TRUE(uniteWith(test::makePose({0, 0, 0.12}, {0.0, 2.0 * kDegree, 0.0})));
  EXPECT_THAT(floorsOf(1, 20), Each(1U));
}

TEST_F(TwoRunsOnOneFloor, AnotherStoreyIsNot) {
  EXPECT_FALSE(uniteWith(test::makePose({0, 0, 3.6})));
  EXPECT_NE(floorOf(15), 1U);
}

}  // namespace
}  // namespace wardslam::graph
