#include "hospital/hospital_ways.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "hospital/hospital_furnishing.h"
#include "hospital/hospital_sight.h"

namespace wardslam::synth {
namespace {

class HospitalWays : public ::testing::Test {
 protected:
  HospitalPlan plan = planHospital(2);
  std::vector<Item> items = furnish(plan, 2, true);
  WayGraph graph = wayGraph(plan);
};

TEST_F(HospitalWays, EverywhereCanBeReached) {
  std::vector<bool> reached(graph.nodes_m.size(), false);
  reached[0] = true;
  for (std::size_t i = 0; i < graph.nodes_m.size(); ++i) {
    for (const auto& [a, b] : graph.edges) {
      if (reached[a] || reached[b]) reached[a] = reached[b] = true;
    }
  }
  for (const bool node : reached) EXPECT_TRUE(node);
  std::set<std::size_t> rooms;
  for (const auto& p : graph.nodes_m) rooms.insert(plan.roomAt(p));
  EXPECT_GE(rooms.size(), 15U);
}

TEST_F(HospitalWays, EdgesAreClearOfThings) {
  for (const auto& [a, b] : graph.edges) {
    const Eigen::Vector2d way = graph.nodes_m[b] - graph.nodes_m[a];
    for (double s = 0; s <= 1.0; s += 0.05 / way.norm()) {
      const Eigen::Vector2d p = graph.nodes_m[a] + s * way;
      for (const Item& item : items) EXPECT_GT(distanceTo(item, p), kWayClearance_m) << nameOf(item);
    }
  }
}

TEST_F(HospitalWays, ThereAreSeatsAndPlacesToStand) {
  EXPECT_GT(seatsOf(items, graph).size(), 50U);
  const auto spots = standingSpots(plan, items, graph);
  EXPECT_GT(spots.size(), 30U);
  for (const StandingSpot& spot : spots) {
    for (const Item& item : items) EXPECT_GT(distanceTo(item, spot.p_m), 0.3) << nameOf(item);
  }
}

TEST_F(HospitalWays, WhatIsSeenIsKnown) {
  // Rays through the rooms that meet no wall must end in a room that is said to be seen.
  const auto isWall = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    const std::size_t a = plan.roomAt(from);
    const std::size_t b = plan.roomAt(to);
    if (a == b) return false;
    for (const Door& door : plan.doors) {
      const bool between = (door.room == a && door.corridor == b) || (door.room == b && door.corridor == a);
      const auto [low, high] = std::minmax(door.from_m.x(), door.to_m.x());
      const double x = (from.x() + to.x()) / 2;
      if (between && door.state != DoorState::Closed && x > low && x < high) return false;
    }
    return true;
  };
  for (const auto& p : graph.nodes_m) {
    const std::vector<bool> seen = roomsSeenFrom(plan, p);
    for (double angle = 0.01; angle < 6.28; angle += 0.02) {
      Eigen::Vector2d q = p;
      while (true) {
        const Eigen::Vector2d next = q + 0.02 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        if (plan.roomAt(next) >= plan.rooms.size() || isWall(q, next)) break;
        q = next;
        ASSERT_TRUE(seen[plan.roomAt(q)]) << plan.rooms[plan.roomAt(q)].id << " from " << p.transpose();
      }
    }
  }
  // And it is worth knowing.
  const auto seen = roomsSeenFrom(plan, plan.rooms[plan.corridorA].area_m.center());
  EXPECT_LT(std::count(seen.begin(), seen.end(), true), static_cast<long>(plan.rooms.size() * 2 / 3));
}

}  // namespace
}  // namespace wardslam::synth
