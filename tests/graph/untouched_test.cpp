#include "untouched.h"

#include <gmock/gmock.h>

#include "graph/hand_made_keyframe.h"

namespace wardslam::graph {
namespace {

using test::handMadeKeyframe;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(Untouched, AreKeyframesOfEarlierRunsThatShareNothingWithThisOne) {
  KeyframeGraph graph;
  graph.restore(handMadeKeyframe(1, {1, 2}), {});
  graph.restore(handMadeKeyframe(2, {2, 3}), {});
  graph.restore(handMadeKeyframe(3, {3, 4}), {});
  EXPECT_THAT(untouched(graph), ElementsAre(1, 2, 3));
  graph.insert(handMadeKeyframe(4, {4, 5}));
  EXPECT_THAT(untouched(graph), ElementsAre(1, 2)) << "the third shares a point with the fourth";
  graph.insert(handMadeKeyframe(5, {2}));
  EXPECT_THAT(untouched(graph), IsEmpty());
}

TEST(Untouched, IsNothingWhereThereWasNoEarlierRun) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1, 2}));
  EXPECT_THAT(untouched(graph), IsEmpty());
}

}  // namespace
}  // namespace wardslam::graph
