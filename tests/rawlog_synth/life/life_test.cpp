#include "life/life.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "life/clearance.h"
#include "life/life_actors.h"
#include "life_place.h"

namespace wardslam::synth {
namespace {

constexpr double kSeconds_s = 120.0;

class Life : public testing::Test {
 protected:
  explicit Life(std::uint32_t seed = 4) : place(test::lifePlace()), walls(place.scene.things, {}) {
    LifeOptions options;
    options.seed = seed;
    options.duration_s = kSeconds_s;
    nextId = addLife(place.scene, 100, place.ways, options);
    for (const auto& actor : place.scene.actors) {
      if (const auto* member = dynamic_cast<const MemberActor*>(actor.get())) people.push_back(member);
      if (const auto* thing = dynamic_cast<const MovedActor*>(actor.get())) things.push_back(thing);
    }
  }

  /// Of all people. Time goes on in the outer loop of a test: what is long past must be lived through again.
  [[nodiscard]] std::vector<Eigen::Vector2d> placesAt(double t_s) const {
    std::vector<Eigen::Vector2d> places_m;
    for (const MemberActor* person : people) places_m.push_back(person->bodyAt(t_s).p_m);
    return places_m;
  }

  test::LifePlace place;
  ClearanceMap walls;
  std::uint16_t nextId = 0;
  std::vector<const MemberActor*> people;
  std::vector<const MovedActor*> things;
};

TEST_F(Life, NobodyWalksThroughWalls) {
  const ClearanceMap building({place.scene.things.front()}, {});
  ASSERT_GT(people.size(), 20U);
  std::vector<Eigen::Vector2d> before = placesAt(0.0);
  for (double t = 0.1; t < kSeconds_s; t += 0.1) {
    const std::vector<Eigen::Vector2d> now = placesAt(t);
    for (std::size_t i = 0; i < people.size(); ++i) {
      ASSERT_GT(building.along(before[i], now[i]), 0.04)
          << people[i]->label().name << " at " << t << " s: " << now[i].transpose();
    }
    before = now;
  }
}

TEST_F(Life, NobodyRuns) {
  std::vector<double> ways_m(people.size(), 0.0);
  std::vector<Eigen::Vector2d> before = placesAt(0.0);
  for (double t = 0.1; t < kSeconds_s; t += 0.1) {
    const std::vector<Eigen::Vector2d> now = placesAt(t);
    for (std::size_t i = 0; i < people.size(); ++i) {
      const double step_m = (now[i] - before[i]).norm();
      ASSERT_LT(step_m / 0.1, 1.7) << people[i]->label().name << " at " << t;
      ways_m[i] += step_m;
    }
    before = now;
  }
  EXPECT_GT(*std::max_element(ways_m.begin(), ways_m.end()), 40.0) << "somebody gets about";
}

TEST_F(Life, EverybodyKeepsOffTheCameraAndSomeComeClose) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (double t = 0; t < kSeconds_s; t += 0.05) {
    const Eigen::Vector2d camera = place.ways.camera_m(t);
    for (const MemberActor* person : people) {
      const double distance_m = (person->bodyAt(t).p_m - camera).norm();
      ASSERT_GE(distance_m, 0.5) << person->label().name << " at " << t;
      nearest_m = std::min(nearest_m, distance_m);
    }
  }
  EXPECT_LT(nearest_m, 1.5);
}

TEST_F(Life, WhatIsPushedComesWithSomebodyAndRestsWhereItWasLeft) {
  int pushed = 0;
  for (const MovedActor* thing : things) {
    const auto rests = thing->restsUntil(kSeconds_s);
    for (const RestInterval& rest : rests) {
      const double until_s = std::min(rest.until_s, kSeconds_s);
      for (double t = rest.from_s; t < until_s - 0.06; t += 0.5) {
        ASSERT_FALSE(thing->isMovingAt(t)) << thing->label().name << " at " << t;
        ASSERT_TRUE(thing->boundsAt(t).isApprox(rest.bounds_m, 1e-6F)) << thing->label().name << " at " << t;
      }
    }
  }
  for (double t = 0.05; t < kSeconds_s; t += 0.7) {
    for (const MovedActor* thing : things) {
      if (!thing->isMovingAt(t)) continue;
      ++pushed;
      double nearest_m = std::numeric_limits<double>::infinity();
      for (const MemberActor* person : people) {
        if (person->bodyAt(t).pose.reaching == 0.0) continue;
        nearest_m = std::min(nearest_m, (person->bodyAt(t).p_m - thing->thingAt(t).p_m).norm());
      }
      ASSERT_LT(nearest_m, 1.2) << thing->label().name << " moves by itself at " << t;
    }
  }
  EXPECT_GT(pushed, 10);
}

TEST_F(Life, MovingMeansThatSurfacesMove) {
  int moving = 0;
  int still = 0;
  for (double t = 0.02; t < kSeconds_s; t += 7.3) {
    for (const auto& actor : place.scene.actors) {
      const Surfaces now = actor->surfacesAt(t);
      const Surfaces soon = actor->surfacesAt(t + 0.05);
      float most_m = 0.0F;
      for (std::size_t i = 0; i < now.size(); ++i) {
        for (std::size_t k = 0; k < now[i].mesh.vertices.size(); ++k) {
          const auto& a = now[i].mesh.vertices[k].p_m;
          most_m = std::max(most_m, (a - soon[i].mesh.vertices[k].p_m).norm());
        }
      }
      EXPECT_EQ(actor->isMovingAt(t), most_m > 0.0F) << actor->label().name << " at " << t << ": " << most_m;
      ++(actor->isMovingAt(t) ? moving : still);
    }
  }
  EXPECT_GT(moving, 20);
  EXPECT_GT(still, 20);
}

TEST_F(Life, BoundsHoldTheSurfaces) {
  for (const auto& actor : place.scene.actors) {
    const Eigen::AlignedBox3f box = actor->boundsAt(33.33);
    for (const Surface& surface : actor->surfacesAt(33.33)) {
      for (const Vertex& vertex : surface.mesh.vertices)
        ASSERT_LT(box.exteriorDistance(vertex.p_m), 0.01F) << actor->label().name;
    }
  }
}

TEST_F(Life, IsTheSameAgainInWhateverOrderItIsAsked) {
  test::LifePlace again = test::lifePlace();
  LifeOptions options;
  options.seed = 4;
  options.duration_s = kSeconds_s;
  EXPECT_EQ(addLife(again.scene, 100, again.ways, options), nextId);
  ASSERT_EQ(again.scene.actors.size(), place.scene.actors.size());
  for (const double t : {65.0, 3.0, 110.05, 42.0}) {
    for (const double other_s : {111.0, 0.0}) (void)again.scene.actors.front()->boundsAt(other_s);
    for (std::size_t i = 0; i < again.scene.actors.size(); ++i) {
      EXPECT_EQ(again.scene.actors[i]->boundsAt(t).min(), place.scene.actors[i]->boundsAt(t).min());
      EXPECT_EQ(again.scene.actors[i]->label().id, place.scene.actors[i]->label().id);
    }
  }
}

TEST(LifeOptions, NobodyThereIsAnAnswerToo) {
  test::LifePlace place = test::lifePlace();
  LifeOptions options;
  options.density = Density::None;
  EXPECT_EQ(addLife(place.scene, 100, place.ways, options), 100);
  EXPECT_TRUE(place.scene.actors.empty());
  EXPECT_EQ(place.scene.things.size(), 3U);
}

}  // namespace
}  // namespace wardslam::synth
