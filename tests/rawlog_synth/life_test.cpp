#include "life/life.h"

#include <gtest/gtest.h>

#include <limits>

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

  test::LifePlace place;
  ClearanceMap walls;
  std::uint16_t nextId = 0;
  std::vector<const MemberActor*> people;
  std::vector<const MovedActor*> things;
};

TEST_F(Life, NobodyWalksThroughWalls) {
  const ClearanceMap building({place.scene.things.front()}, {});
  ASSERT_GT(people.size(), 20U);
  for (const MemberActor* person : people) {
    Eigen::Vector2d before = person->bodyAt(0).p_m;
    for (double t = 0.1; t < kSeconds_s; t += 0.1) {
      const Eigen::Vector2d p = person->bodyAt(t).p_m;
      ASSERT_GT(building.along(before, p), 0.04) << person->label().name << " at " << t << " s: " << p.transpose();
      before = p;
    }
  }
}

TEST_F(Life, NobodyRuns) {
  double longest_m = 0.0;
  for (const MemberActor* person : people) {
    double way_m = 0.0;
    Eigen::Vector2d before = person->bodyAt(0).p_m;
    for (double t = 0.1; t < kSeconds_s; t += 0.1) {
      const Eigen::Vector2d p = person->bodyAt(t).p_m;
      ASSERT_LT((p - before).norm() / 0.1, 1.7) << person->label().name << " at " << t;
      way_m += (p - before).norm();
      before = p;
    }
    longest_m = std::max(longest_m, way_m);
  }
  EXPECT_GT(longest_m, 40.0) << "somebody gets about";
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
        ASSERT_TRUE(thing->boundsAt(t).value().isApprox(rest.bounds_m, 1e-6F)) << thing->label().name << " at " << t;
      }
    }
    for (double t = 0.05; t < kSeconds_s; t += 0.7) {
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
  for (const auto& actor : place.scene.actors) {
    for (double t = 0.02; t < kSeconds_s; t += 7.3) {
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
    const Eigen::AlignedBox3f box = actor->boundsAt(33.33).value();
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
      EXPECT_EQ(again.scene.actors[i]->boundsAt(t).value().min(), place.scene.actors[i]->boundsAt(t).value().min());
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
