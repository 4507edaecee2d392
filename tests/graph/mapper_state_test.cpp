#include "wardslam/graph/mapper_state.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "graph/meeting_runs.h"
#include "wardslam/graph/mapper.h"

namespace wardslam::graph {
namespace {

/// All numbers of it: whatever is not the same in two states shows.
std::vector<double> numbersOf(const MapperState& state) {
  std::vector<double> numbers;
  const auto add = [&](const auto& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) numbers.push_back(matrix.data()[i]);
  };
  const auto addLoop = [&](const Loop& loop) {
    numbers.insert(numbers.end(), {static_cast<double>(loop.older), static_cast<double>(loop.newer),
                                   static_cast<double>(loop.inliers), static_cast<double>(loop.samePoints.size())});
    add(loop.T_older_newer.matrix());
  };
  for (const auto& keyframe : state.graph.keyframes) {
    numbers.insert(numbers.end(), {static_cast<double>(keyframe.id), static_cast<double>(keyframe.submap),
                                   static_cast<double>(keyframe.isSettled), static_cast<double>(keyframe.floor)});
    add(keyframe.T_map_cam.matrix());
    for (const auto& [point, keypoint] : keyframe.sightings) numbers.push_back(static_cast<double>(point + keypoint));
  }
  for (const auto& point : state.graph.points) {
    numbers.push_back(static_cast<double>(point.id));
    add(point.p_map_m);
    add(point.viewedFrom_map_m);
    add(point.information_per_m2);
  }
  numbers.push_back(static_cast<double>(state.graph.fusedInto.size()));
  for (const auto& join : state.joins) numbers.push_back(join.from + 100.0 * join.into);
  for (const Loop& loop : state.loops) addLoop(loop);
  for (const auto* loops : {&state.hypotheses, &state.unsettled}) {
    for (const auto& hypothesis : *loops) {
      numbers.push_back(static_cast<double>(hypothesis.size()));
      for (const Loop& loop : hypothesis) addLoop(loop);
    }
  }
  for (const auto& [id, apart_m] : state.apart_m) numbers.insert(numbers.end(), {static_cast<double>(id), apart_m});
  for (const auto& places : state.places) {
    for (const auto& place : places) {
      for (const auto keypoint : place.keypoints) numbers.push_back(keypoint);
    }
  }
  numbers.push_back(static_cast<double>(state.random));
  return numbers;
}

/// A third run, half a round on, comes back to what the others saw.
class MapperStateTest : public testing::Test {
 protected:
  MapperStateTest() {
    for (int i = 0; i < 6; ++i) runs_.walk.stepBack();
    runs_.walk.loseTrack();
    third_ = MeetingRuns::savedRun(runs_.walk.walk(8));
  }

  /// From the beginning, or where `state` was told after so many keyframes of the second run.
  [[nodiscard]] MapperState goOn(const MapperState* state, std::size_t done) const {
    Mapper mapper(fewAndFast(), {});
    cv::theRNG() = cv::RNG(state == nullptr ? cv::RNG().state : 4711);
    if (state == nullptr) {
      mapper.restore(runs_.first);
    } else {
      mapper.resume({&runs_.first, &runs_.second}, *state);
    }
    mapper.meet(
        runs_.second, [](const auto& /*update*/) {}, done);
    mapper.meet(third_, [](const auto& /*update*/) {});
    mapper.adjustAll();
    return mapper.state();
  }

  MeetingRuns runs_{true};
  SavedGraph third_;
};

TEST_F(MapperStateTest, TheSameComesOfWhatIsGoneOnFrom) {
  const auto expected = numbersOf(goOn(nullptr, 0));
  std::vector<MapperState> states;
  Mapper mapper(fewAndFast(), {});
  cv::theRNG() = cv::RNG();
  mapper.restore(runs_.first);
  mapper.meet(runs_.second, [&](const auto& /*update*/) { states.push_back(mapper.state()); });
  ASSERT_EQ(states.size(), 12U);
  ASSERT_FALSE(states.back().joins.empty());
  for (std::size_t done = 1; done <= states.size(); ++done)
    EXPECT_TRUE(numbersOf(goOn(&states[done - 1], done)) == expected) << "after " << done << " keyframes";
}

TEST_F(MapperStateTest, PiecesAndLoopsAreKnown) {
  Mapper mapper(fewAndFast(), {});
  mapper.restore(runs_.first);
  mapper.meet(runs_.second, [](const auto& /*update*/) {});
  Mapper other(fewAndFast(), {});
  other.resume({&runs_.first, &runs_.second}, mapper.state());
  EXPECT_EQ(other.pieces().sizes(), mapper.pieces().sizes());
  EXPECT_EQ(other.submapsJoined(), 1U);
  EXPECT_EQ(other.loops().size(), mapper.loops().size());
  EXPECT_EQ(other.graph().points().size(), mapper.graph().points().size());
  for (const auto& [id, node] : mapper.graph().points()) EXPECT_EQ(other.graph().points().at(id).seenBy, node.seenBy);
}

}  // namespace
}  // namespace wardslam::graph
