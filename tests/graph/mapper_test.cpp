#include "wardslam/graph/mapper.h"

#include <gmock/gmock.h>

#include <numeric>
#include <opencv2/core.hpp>
#include <set>

#include "graph/hand_made_keyframe.h"
#include "graph/mapper_walk.h"
#include "graph/staged_mapper.h"
#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

using test::makePose;
using test::SyntheticWalk;

using MapperTest = MapperWalk;

const Eigen::Isometry3d kSlip = makePose({0.15, 0.05, 0.12}, {0.0, 0.05, 0.0});

TEST_F(MapperTest, ClosesARound) {
  Mapper mapper(fewAndFast(), {});
  walk(mapper, kSlip);
  ASSERT_GE(mapper.loops().size(), 1U);
  EXPECT_EQ(mapper.submapsJoined(), 0U);
  EXPECT_LT(error_m(mapper, kKeyframes), 0.02) << "the slip was 0.2 m";
  const auto& [older, newer] = std::pair(mapper.loops().front().older, mapper.loops().front().newer);
  EXPECT_GE(newer, older + 10);
  EXPECT_GT(mapper.graph().covisible(newer).size(), 3U);

  const auto& update = closings_.front();
  EXPECT_EQ(update.T_map_cam.size(), update.newestKeyframe) << "all keyframes so far";
  EXPECT_EQ(update.recalledKeyframes.count(older), 1U);
  EXPECT_GT(update.fusedPoints.size(), 25U);
  for (const auto& [from, into] : update.fusedPoints) EXPECT_EQ(walk_.worldPointOf(from), walk_.worldPointOf(into));
  for (const auto& [id, points] : update.recalledKeyframes) {
    for (const PointId point : points) EXPECT_EQ(update.recalledPoints.count(point), 1U);
  }
}

TEST_F(MapperTest, GoesOnWithAnEarlierMap) {
  Mapper earlier(fewAndFast(), {});
  walk(earlier, Eigen::Isometry3d::Identity());
  const SavedGraph saved = save(earlier.graph());

  Mapper mapper(fewAndFast(), {});
  mapper.restore(saved);
  EXPECT_EQ(mapper.graph().keyframes().size(), earlier.graph().keyframes().size());
  EXPECT_EQ(mapper.graph().points().size(), earlier.graph().points().size());
  for (const auto& [id, node] : earlier.graph().points()) {
    EXPECT_TRUE(mapper.graph().points().at(id).point.p_map_m.isApprox(node.point.p_map_m, 1e-9));
    EXPECT_EQ(mapper.graph().points().at(id).seenBy, node.seenBy);
  }

  walk_.loseTrack();  // the robot was switched off
  for (int i = 0; i < 4; ++i) insert(mapper, walk_.step());
  EXPECT_EQ(mapper.submapsJoined(), 1U);
  EXPECT_LT(error_m(mapper, kKeyframes + 4), 0.02) << "in the frame of the earlier map";
}

TEST_F(MapperTest, JoinsPiecesOfAnEarlierRunInALaterOne) {
  Mapper earlier(fewAndFast(), {});
  for (const auto& keyframe : walk_.walk(8)) insert(earlier, keyframe);
  walk_.loseTrack();
  for (int i = 0; i < 6; ++i) walk_.skip();  // carried on, to where nothing of it is seen
  for (const auto& keyframe : walk_.walk(12)) insert(earlier, keyframe);
  ASSERT_EQ(earlier.submapsJoined(), 0U);
  const SavedGraph saved = save(earlier.graph());
  ASSERT_EQ(saved.map, 2U) << "the larger";

  Mapper mapper(fewAndFast(), {});
  mapper.restore(saved);
  walk_.loseTrack();  // the robot was switched off, and begins where it stood
  for (int i = 0; i < kRound - 10; ++i) insert(mapper, walk_.step());
  EXPECT_EQ(mapper.submapsJoined(), 2U);
  const Eigen::Isometry3d T_map_first = walk_.T_first_cam(9).inverse();
  for (const auto& [id, node] : mapper.graph().keyframes()) {
    EXPECT_EQ(node.submap, 2U) << id;
    EXPECT_LT(test::distance_m(node.T_map_cam, T_map_first * walk_.T_first_cam(id)), 0.05)
        << id << " stands where it should in the frame of the map";
  }
}

TEST_F(MapperTest, OneLookMakesNoLoop) {
  GraphOptions options = fewAndFast();
  options.loop_confirmation.keyframes_to_join = 3;
  Mapper mapper(options, {});
  for (const auto& keyframe : walk_.walk(16)) insert(mapper, keyframe);
  walk_.loseTrack();
  for (int back = 0; back < 12; ++back) walk_.stepBack();
  insert(mapper, walk_.step());
  insert(mapper, walk_.step());
  EXPECT_TRUE(mapper.loops().empty()) << "two may look alike";
  EXPECT_EQ(mapper.pieces().sizes().size(), 2U);
  insert(mapper, walk_.step());
  EXPECT_EQ(mapper.loops().size(), 3U);
  EXPECT_EQ(mapper.pieces().sizes().size(), 1U);
}

TEST_F(MapperTest, ARunThatEndsSoonIsJoinedByWhatThereWas) {
  Mapper mapper(fewAndFast(), {});
  for (const auto& keyframe : walk_.walk(16)) insert(mapper, keyframe);
  walk_.loseTrack();
  for (int back = 0; back < 12; ++back) walk_.stepBack();
  insert(mapper, walk_.step());
  ASSERT_EQ(mapper.submapsJoined(), 0U) << "one look is not enough while more may come";
  const auto update = mapper.settle();
  ASSERT_TRUE(update);
  ASSERT_TRUE(update->joined);
  EXPECT_EQ(update->joined->into, 1U);
  EXPECT_TRUE(update->movesTheMap);
  EXPECT_EQ(update->newestKeyframe, 17U);
  EXPECT_EQ(update->seenAgain.value().newer, 17U) << "tracking is as sure now as it was there";
  EXPECT_EQ(mapper.submapsJoined(), 1U);
  EXPECT_LT(error_m(mapper, 17), 0.03);
  EXPECT_FALSE(mapper.settle()) << "there is no more";
}

TEST_F(MapperTest, NobodyIsJoinedToAPlaceHeCannotHaveReached) {
  GraphOptions options = fewAndFast();
  options.loop_verification.max_speed_mps = 0.01;  // the camera stood a metre and more away a second ago
  options.loop_verification.lost_margin_m = 0.1;
  Mapper mapper(options, {});
  for (const auto& keyframe : walk_.walk(16)) insert(mapper, keyframe);
  walk_.loseTrack();
  for (int back = 0; back < 12; ++back) walk_.stepBack();
  for (int i = 0; i < 5; ++i) insert(mapper, walk_.step());
  EXPECT_FALSE(mapper.settle());
  EXPECT_EQ(mapper.pieces().sizes().size(), 2U);
}

TEST_F(MapperTest, TakesALoopBackThatDoesNotFit) {
  GraphOptions options = fewAndFast();
  options.loop_verification.min_drift_m = 100.0;  // whatever looks alike is believed, by single looks
  options.loop_verification.min_drift_rad = 3.2;
  options.loop_confirmation.keyframes = 1;
  Mapper mapper(options, {});
  const auto room = walk_.walk(kRound - 12);
  for (const auto& keyframe : room) insert(mapper, keyframe);
  // On from there it looks as it did at the start, and all the way is seen without a gap.
  const auto before = mapper.graph().keyframes();
  auto lookalike = walk_.step();
  const auto first = room.front();
  const std::size_t own = lookalike->features.size();
  for (std::size_t i = 0; i < first->features.size(); ++i) {
    lookalike->features.keypoints.push_back(first->features.keypoints[i]);
    lookalike->features.descriptors.push_back(first->features.descriptors.row(static_cast<int>(i)));
    lookalike->sightings.push_back({2000000 + i, own + i});
  }
  const auto update = mapper.insert(lookalike);
  EXPECT_EQ(mapper.loopsTakenBack(), 1U);
  EXPECT_TRUE(mapper.loops().empty());
  EXPECT_TRUE(update.fusedPoints.empty());
  for (const auto& [id, node] : before) {
    const auto now = mapper.graph().keyframes().find(id);
    if (now == mapper.graph().keyframes().end()) continue;
    EXPECT_LT(test::distance_m(now->second.T_map_cam, node.T_map_cam), 0.02) << id;
  }
}

TEST_F(MapperTest, AHeldMapStaysAsItIsToTheLastBitAndWhatComesIsFittedToIt) {
  Mapper earlier(fewAndFast(), {});
  walk(earlier, kSlip);
  SavedGraph saved = save(earlier.graph());
  const auto& someKeyframe = *saved.keyframes.at(saved.keyframes.size() / 2);
  saved.p_map_m.at(someKeyframe.sightings.front().point).x() += 0.1;  // adjustment would mend this

  Mapper mapper(fewAndFast(), {});
  mapper.restore(saved, Saved::IsHeld);
  walk_.loseTrack();
  for (int i = 0; i < kRound + 20; ++i) {
    const auto update = mapper.insert(walk_.step());
    for (const auto& [id, pose] : update.T_map_cam) EXPECT_GT(id, KeyframeId{kKeyframes}) << "nothing else may move";
    for (const auto& removed : update.removedKeyframes) EXPECT_GT(removed.id, KeyframeId{kKeyframes});
    for (const PointId point : update.removedPoints) EXPECT_EQ(saved.p_map_m.count(point), 0U);
  }
  EXPECT_GE(mapper.submapsJoined(), 1U);
  mapper.adjustAll();
  for (const auto& keyframe : saved.keyframes) {
    ASSERT_EQ(mapper.graph().keyframes().count(keyframe->id), 1U);
    EXPECT_EQ(mapper.graph().keyframes().at(keyframe->id).T_map_cam.matrix(), keyframe->T_map_cam.matrix());
  }
  for (const auto& [id, p_map_m] : saved.p_map_m) {
    ASSERT_EQ(mapper.graph().points().count(id), 1U) << id;
    EXPECT_EQ(mapper.graph().points().at(id).point.p_map_m, p_map_m) << id;
  }
  for (const auto& [id, node] : mapper.graph().keyframes()) {
    if (node.isHeld) continue;
    EXPECT_LT(error_m(mapper, id), 0.03) << id;
  }
}

TEST_F(MapperTest, TakesBackTheLoopsOfAnEarlierMap) {
  Mapper earlier(fewAndFast(), {});
  walk(earlier, kSlip);
  ASSERT_GE(earlier.loops().size(), 1U);
  SavedGraph saved = save(earlier.graph());
  saved.loops = earlier.loops();
  saved.loops.emplace_back().newer = 9999;  // a keyframe the map does not hold
  Mapper mapper(fewAndFast(), {});
  mapper.restore(saved);
  ASSERT_EQ(mapper.loops().size(), earlier.loops().size());
  EXPECT_EQ(mapper.loops().front().older, earlier.loops().front().older);
  EXPECT_EQ(mapper.loopsClosed(), 0U) << "not by this run";
}

TEST_F(MapperTest, LeavesTheSlipWhenToldToCloseNothing) {
  GraphOptions options = fewAndFast();
  options.close_loops = false;
  Mapper mapper(options, {});
  walk(mapper, kSlip);
  EXPECT_TRUE(mapper.loops().empty());
  EXPECT_GT(error_m(mapper, kKeyframes), 0.1);
}

TEST_F(MapperTest, JoinsSubmapsThatMeet) {
  Mapper mapper(fewAndFast(), {});
  for (const auto& keyframe : walk_.walk(kRound - 10)) insert(mapper, keyframe);
  walk_.loseTrack();
  for (const auto& keyframe : walk_.walk(16)) insert(mapper, keyframe);
  ASSERT_EQ(mapper.submapsJoined(), 1U);
  for (const auto& [id, node] : mapper.graph().keyframes()) {
    EXPECT_EQ(node.submap, 1U) << id;
    EXPECT_LT(error_m(mapper, id), 0.04) << id << " stands where it should in the frame of the first";
  }
  EXPECT_EQ(closings_.front().T_map_cam.size(), closings_.front().newestKeyframe);
}

TEST_F(MapperTest, AdjustsEverythingOnceMoreAtTheEnd) {
  GraphOptions options = fewAndFast();
  options.close_loops = false;
  Mapper mapper(options, {});
  for (const auto& keyframe : walk_.walk(8)) insert(mapper, keyframe);
  walk_.loseTrack();
  for (const auto& keyframe : walk_.walk(4)) insert(mapper, keyframe);
  const auto update = mapper.adjustAll();
  const auto T = [&](KeyframeId id) { return mapper.graph().keyframes().at(id).T_map_cam; };
  EXPECT_LT(error_m(mapper, 8), 0.01);
  EXPECT_TRUE(T(9).isApprox(Eigen::Isometry3d::Identity())) << "each submap has its own frame";
  EXPECT_LT(test::distance_m(T(12), walk_.T_first_cam(9).inverse() * walk_.T_first_cam(12)), 0.01);
  EXPECT_EQ(update.newestKeyframe, 12U);
  ASSERT_EQ(update.T_map_cam.size(), 12U);
  for (const auto& [id, pose] : update.T_map_cam) EXPECT_EQ(pose.matrix(), T(id).matrix()) << id;
  ASSERT_EQ(update.p_map_m.size(), mapper.graph().points().size());
  for (const auto& [id, p_map_m] : update.p_map_m) EXPECT_EQ(p_map_m, mapper.graph().points().at(id).point.p_map_m);
  EXPECT_TRUE(Mapper(options, {}).adjustAll().T_map_cam.empty()) << "of nothing";
}

/// All that ever moved was told: who keeps books has the graph's poses.
TEST_F(MapperTest, SaysOfEveryUpdateUpToWhichKeyframeItKnows) {
  Mapper mapper(fewAndFast(), {});
  std::map<KeyframeId, Eigen::Isometry3d> books;
  for (int i = 0; i < kKeyframes; ++i) {
    const bool slips = i == kRound / 2;
    if (slips) walk_.forgetPoints();
    const auto keyframe = walk_.step(slips ? kSlip : Eigen::Isometry3d::Identity());
    const auto update = mapper.insert(keyframe);
    EXPECT_EQ(update.newestKeyframe, keyframe->id);
    EXPECT_EQ(update.submap, keyframe->submap);
    EXPECT_EQ(update.T_map_cam.count(keyframe->id), 1U) << keyframe->id;
    for (const auto& [id, pose] : update.T_map_cam) books[id] = pose;
    for (const auto& removed : update.removedKeyframes) books.erase(removed.id);
  }
  ASSERT_GE(mapper.loops().size(), 1U);
  ASSERT_EQ(books.size(), mapper.graph().keyframes().size());
  for (const auto& [id, pose] : books) EXPECT_EQ(pose.matrix(), mapper.graph().keyframes().at(id).T_map_cam.matrix());
}

TEST_F(MapperTest, DropsPointsThatNobodySeesAgain) {
  GraphOptions options = fewAndFast();
  options.probation_keyframes = 2;
  Mapper mapper(options, {});
  const auto keyframes = walk_.walk(2);
  insert(mapper, keyframes[0]);
  insert(mapper, keyframes[1]);
  walk_.forgetPoints();
  std::set<PointId> once;
  for (const auto& [id, node] : mapper.graph().points()) {
    if (*node.seenBy.begin() == 1 && node.seenBy.size() == 1) once.insert(id);
  }
  ASSERT_GT(once.size(), 10U);
  const auto update = mapper.insert(walk_.step());
  EXPECT_EQ(std::set<PointId>(update.removedPoints.begin(), update.removedPoints.end()), once);
  for (const PointId id : once) EXPECT_EQ(mapper.graph().points().count(id), 0U);
}

TEST_F(MapperTest, GrowsWithTheAreaAndNotWithTheRoundsInIt) {
  GraphOptions options = fewAndFast();
  options.bundle_adjustment.local_iterations = 2;
  options.redundancy.min_keyframe_gap = 10;
  Mapper mapper(options, {});
  std::vector<std::size_t> keyframes;
  std::vector<std::size_t> points;
  std::map<KeyframeId, odometry::RemovedKeyframe> removed;
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i < kRound; ++i) {
      const auto update = mapper.insert(walk_.step());
      walk_.recall(update);
      for (const auto& keyframe : update.removedKeyframes) removed[keyframe.id] = keyframe;
    }
    keyframes.push_back(mapper.graph().keyframes().size());
    points.push_back(mapper.graph().points().size());
  }
  EXPECT_GE(mapper.loopsClosed(), 1U);
  EXPECT_LE(keyframes.back(), keyframes[1] * 105 / 100);
  EXPECT_LE(points.back(), points[1] * 105 / 100);
  EXPECT_EQ(keyframes.back() + removed.size(), static_cast<std::size_t>(4 * kRound));
  for (const auto& [id, keyframe] : removed) {
    Eigen::Isometry3d T_heir_cam = keyframe.T_heir_cam;
    KeyframeId heir = keyframe.heir;
    for (auto next = removed.find(heir); next != removed.end(); next = removed.find(heir)) {
      T_heir_cam = next->second.T_heir_cam * T_heir_cam;
      heir = next->second.heir;
    }
    const Eigen::Isometry3d T_map_cam = mapper.graph().keyframes().at(heir).T_map_cam * T_heir_cam;
    EXPECT_LT(test::distance_m(T_map_cam, walk_.T_first_cam(id)), 0.02) << id << " is where it was";
  }
  for (const Loop& loop : mapper.loops()) {
    EXPECT_EQ(mapper.graph().keyframes().count(loop.older), 1U);
    EXPECT_EQ(mapper.graph().keyframes().count(loop.newer), 1U);
    const Eigen::Isometry3d T_older_newer = walk_.T_first_cam(loop.older).inverse() * walk_.T_first_cam(loop.newer);
    EXPECT_LT(test::distance_m(loop.T_older_newer, T_older_newer), 0.02);
  }
}

TEST_F(MapperTest, KeepsAllKeyframesWhenTold) {
  GraphOptions options = fewAndFast();
  options.cull_keyframes = false;
  options.redundancy.min_keyframe_gap = 10;
  Mapper mapper(options, {});
  for (int i = 0; i < kRound + 12; ++i) walk_.recall(mapper.insert(walk_.step()));
  EXPECT_EQ(mapper.graph().keyframes().size(), static_cast<std::size_t>(kRound + 12));
}

TEST(MapperRecall, TellsOfAPlaceThatManyKeyframesShowAFewAtATime) {
  GraphOptions options;
  options.close_loops = false;
  options.cull_keyframes = false;
  options.place_recognition.min_keyframe_gap = 5;
  options.bundle_adjustment.min_shared_points = 15;
  std::vector<PointId> here(16);
  std::vector<PointId> elsewhere(16);
  std::iota(here.begin(), here.end(), PointId{1});
  std::iota(elsewhere.begin(), elsewhere.end(), PointId{101});
  Mapper mapper(options, {});
  KeyframeId id = 0;
  while (id < 30) mapper.insert(test::handMadeKeyframe(++id, here));
  while (id < 36) mapper.insert(test::handMadeKeyframe(++id, elsewhere));
  for (const KeyframeId first : {1, 11, 21}) {
    const auto recalled = mapper.insert(test::handMadeKeyframe(++id, here)).recalledKeyframes;
    EXPECT_EQ(recalled.size(), 10U);
    EXPECT_EQ(recalled.begin()->first, first);
    EXPECT_EQ(recalled.rbegin()->first, first + 9);
  }
  EXPECT_TRUE(mapper.insert(test::handMadeKeyframe(++id, here)).recalledKeyframes.empty()) << "all are known";
}

TEST(MapperInStage, FedSlowlyItMakesTheMapOfThePlainOne) {
  const auto keyframes = SyntheticWalk({0.5, 0.5, 0}, 800).walk(8);
  Mapper plain({}, {});
  StagedMapper behind(core::StageThread::Own);
  for (const auto& keyframe : keyframes) {
    const auto expected = plain.insert(keyframe);
    behind.insert(keyframe);
    const auto updates = behind.waitForUpdates();
    ASSERT_EQ(updates.size(), 1U);
    EXPECT_EQ(updates[0].removedPoints, expected.removedPoints);
    EXPECT_EQ(updates[0].p_map_m, expected.p_map_m);
  }
  const auto finished = behind.finish();
  ASSERT_EQ(finished->graph().keyframes().size(), keyframes.size());
  for (const auto& [id, node] : plain.graph().keyframes()) {
    const auto& other = finished->graph().keyframes().at(id);
    EXPECT_EQ(node.T_map_cam.matrix(), other.T_map_cam.matrix());
    EXPECT_EQ(node.keypointOf, other.keypointOf);
  }
}

TEST(MapperInStage, FinishWorksEverythingIn) {
  const auto keyframes = SyntheticWalk({}, 800).walk(10);
  StagedMapper behind(core::StageThread::Own);
  for (const auto& keyframe : keyframes) behind.insert(keyframe);
  const auto mapper = behind.finish();
  EXPECT_EQ(mapper->graph().keyframes().size(), 10U);
  EXPECT_EQ(behind.takeUpdates().size(), 10U);
}

TEST(MapperInStage, CanBeGivenUpWithWorkPending) {
  const auto keyframes = SyntheticWalk({}, 800).walk(10);
  {
    StagedMapper behind(core::StageThread::Own);
    for (const auto& keyframe : keyframes) behind.insert(keyframe);
  }
  for (const auto& keyframe : keyframes) EXPECT_EQ(keyframe.use_count(), 1) << "nobody holds it any more";
}

TEST(MapperInStage, ThrowsWhatTheMapperThrew) {
  GraphOptions options;
  options.place_recognition.min_keyframe_gap = 1;
  SyntheticWalk walk({}, 400);
  std::vector<std::shared_ptr<odometry::Keyframe>> keyframes;
  for (int i = 0; i < 8; ++i) keyframes.push_back(walk.step());
  keyframes[1]->features.descriptors =
      cv::Mat(static_cast<int>(keyframes[1]->features.size()), 64, CV_8UC1, cv::Scalar(0));  // not ORB's
  StagedMapper behind(core::StageThread::Own, options);
  const auto insertAllAndFinish = [&] {
    for (const auto& keyframe : keyframes) behind.insert(keyframe);
    (void)behind.finish();
  };
  EXPECT_THROW(insertAllAndFinish(), cv::Exception);
  EXPECT_THROW((void)behind.takeUpdates(), cv::Exception);
}

TEST(MapperInStage, InTheCallingThreadUpdatesAreThereAtOnce) {
  StagedMapper atOnce(core::StageThread::Caller);
  SyntheticWalk walk({}, 800);
  for (int i = 0; i < 4; ++i) {
    const auto keyframe = walk.step();
    atOnce.insert(keyframe);
    const auto updates = atOnce.takeUpdates();
    ASSERT_EQ(updates.size(), 1U);
    EXPECT_EQ(updates[0].T_map_cam.count(keyframe->id), 1U) << "moved or not";
    EXPECT_TRUE(atOnce.takeUpdates().empty()) << "each is handed out once";
  }
  EXPECT_EQ(atOnce.finish()->graph().keyframes().size(), 4U);
}

TEST(MapperInStage, BothWaysHoldAllKeyframesInTheEnd) {
  const auto keyframes = SyntheticWalk({0.5, 0.5, 0}, 800).walk(6);
  StagedMapper atOnce(core::StageThread::Caller);
  StagedMapper behind(core::StageThread::Own);
  for (const auto& keyframe : keyframes) {
    atOnce.insert(keyframe);
    behind.insert(keyframe);
  }
  const auto expected = atOnce.finish();
  expected->adjustAll();
  const auto mapper = behind.finish();
  mapper->adjustAll();
  ASSERT_EQ(mapper->graph().keyframes().size(), expected->graph().keyframes().size());
  for (const auto& [id, node] : mapper->graph().keyframes()) {
    EXPECT_EQ(node.T_map_cam.matrix(), expected->graph().keyframes().at(id).T_map_cam.matrix());
  }
}

}  // namespace
}  // namespace wardslam::graph
