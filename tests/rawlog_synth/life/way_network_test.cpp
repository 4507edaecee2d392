#include "life/way_network.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "life/clearance.h"
#include "life_place.h"

namespace wardslam::synth {
namespace {

/// A square with one short cut: 0 - 1 - 2 - 3 - 0, and 0 - 2 across.
WayGraph square() { return {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}}}; }

TEST(WayNetwork, TakesTheShortestWay) {
  EXPECT_EQ(WayNetwork(square()).way(0, 2), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(WayNetwork(square()).way(1, 1), (std::vector<std::size_t>{1}));
}

TEST(WayNetwork, CountsMetresAndNotCorners) {
  const WayGraph detour = {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 9}}, {{0, 1}, {1, 2}, {2, 3}, {0, 4}, {4, 3}}};
  EXPECT_EQ(WayNetwork(detour).way(0, 3), (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(WayNetwork, PushesOnlyWhereThereIsRoom) {
  WayNetwork network(square());
  network.setHalfWidths({0.6, 0.6, 0.3, 0.3, 0.3});
  EXPECT_EQ(network.way(0, 2, 0.5), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_TRUE(network.way(0, 3, 0.5).empty());
}

TEST(WayNetwork, KnowsTheNearestNode) {
  EXPECT_EQ(WayNetwork(square()).nearestNode({3.2, 3.1}), 2U);
  EXPECT_EQ(WayNetwork(square()).nearestNode({-5.0, 2.1}), 3U);
}

TEST(WayNetwork, RefusesWhatIsNoGraph) {
  EXPECT_THROW(WayNetwork({}), std::invalid_argument);
  EXPECT_THROW(WayNetwork({{{0, 0}}, {{0, 1}}}), std::invalid_argument);
}

TEST(ClearanceMap, MeasuresToTheNearestWall) {
  const test::LifePlace place = test::lifePlace();
  const ClearanceMap walls(place.scene.things, {});
  EXPECT_NEAR(walls.at({12.0, 1.0}), 1.0, 0.08);
  EXPECT_NEAR(walls.at({2.0, 2.6}), 0.4, 0.08);
  EXPECT_NEAR(walls.along({5.0, 1.5}, {5.0, 5.0}), 0.8, 0.1) << "through the door";
  EXPECT_LT(walls.along({8.0, 1.5}, {8.0, 5.0}), 0.06) << "through the wall";
}

}  // namespace
}  // namespace wardslam::synth
