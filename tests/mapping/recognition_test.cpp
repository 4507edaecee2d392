// Which thing is which once it was out of sight: through MapBuilder, as a run tells it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mapping/scene.h"
#include "wardslam/mapping/map_builder.h"

namespace wardslam::mapping {
namespace {

using scene::box;
using scene::cameraAt;
using scene::kBed;
using scene::kChair;
using scene::Thing;

constexpr double kRoomStep_m = 20.0;

/// Rooms in a row along x, each with a camera in its own origin that looks along x at a wall 3 m ahead.
class IdentityTest : public testing::Test {
 protected:
  static MapSetting setting() {
    MapSetting setting;
    setting.moving.set(scene::kPerson);
    setting.movable.set(kChair);
    return setting;
  }
  static MappingOptions options() {
    MappingOptions options;
    options.cloud.pixel_step = 1;
    options.cloud.mover_margin_px = 3;
    return options;
  }

  static Thing thing(int room, double y_m, std::uint16_t instance, core::ClassId classId = kChair) {
    return scene::chair(kRoomStep_m * room + 2, y_m, instance, classId);
  }

  /// Enters the room, which makes a keyframe, and looks at the things in it.
  void look(int room, std::vector<Thing> things, int times = 10) {
    const double x_m = kRoomStep_m * room;
    const Eigen::Isometry3d T_map_cam = cameraAt({x_m, 0, 1});
    odometry::Keyframe keyframe;
    keyframe.id = ++keyframe_;
    keyframe.T_map_cam = T_map_cam;
    keyframe.stamp_s = stamp_s_;
    builder_.addKeyframe(keyframe);
    things.push_back({box({x_m + 3.05, 0, 1}, {0.1, 6, 4}), 0, 0, {200, 190, 180}});
    for (int i = 0; i < times; ++i) {
      builder_.add(scene::render(things, T_map_cam, stamp_s_ += 0.2, keyframe_, T_map_cam));
    }
    static_cast<void>(builder_.takeChanges());  // a run writes them with every keyframe
  }
  void pass(double time_s) { stamp_s_ += time_s; }
  void lookAtEmpty(int room) { look(room, {}, 15); }

  /// As the next run begins it.
  void restart() {
    const SemanticMap map = builder_.map();
    const MapMemory memory = builder_.memory({});
    builder_ = MapBuilder(options(), setting());
    builder_.restore(map, memory);
  }

  std::map<ObjectId, MapObject> objects() { return builder_.map().objects; }

  MapBuilder builder_{options(), setting()};
  odometry::KeyframeId keyframe_ = 0;
  double stamp_s_ = 1000.0;
};

MATCHER_P2(IsAt, x_m, state, "") { return std::abs(arg.centroid_m.x() - x_m) < 1.0 && arg.state == state; }

TEST_F(IdentityTest, AThingThatStoodElsewhereAllTheTimeKeepsItsName) {
  for (const bool isAnotherRun : {false, true}) {
    builder_ = MapBuilder(options(), setting());
    look(0, {thing(0, 0, 1)});
    pass(60);
    look(1, {thing(1, 0, 1)});
    if (isAnotherRun) restart();
    pass(3600);
    lookAtEmpty(0);
    look(1, {thing(1, 0, 1)});
    const auto found = objects();
    ASSERT_EQ(found.size(), 2U) << isAnotherRun;
    EXPECT_THAT(found.at(1), IsAt(2, ObjectState::Gone)) << isAnotherRun;
    EXPECT_THAT(found.at(2), IsAt(22, ObjectState::Static)) << isAnotherRun;
  }
}

TEST_F(IdentityTest, AClockThatGoesBackBetweenRunsMakesNothingThatWasKnownNew) {
  look(0, {thing(0, -0.8, 1)});
  pass(60);
  look(0, {thing(0, -0.8, 1), thing(0, 0.8, 2)});
  ASSERT_EQ(objects().size(), 2U);
  restart();
  pass(-70);
  look(0, {thing(0, -0.8, 1), thing(0, 0.8, 2)}, 1);
  look(0, {thing(0, 0.8, 2)}, 15);
  const auto found = objects();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found.at(1).state, ObjectState::Gone);
  EXPECT_EQ(found.at(2).state, ObjectState::Static);
}

TEST_F(IdentityTest, WhatNobodyCanMoveNeverMoves) {
  look(0, {thing(0, 0.8, 1, kBed)});
  lookAtEmpty(0);
  ASSERT_EQ(objects().at(1).state, ObjectState::Gone);
  look(0, {thing(0, -0.8, 1, kBed)});
  const auto found = objects();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found.at(1).state, ObjectState::Gone);
  EXPECT_FALSE(found.at(1).maybeSameAs);
  EXPECT_EQ(found.rbegin()->second.state, ObjectState::Static);
  EXPECT_FALSE(found.rbegin()->second.maybeSameAs);
}

TEST_F(IdentityTest, WhatStandsInARoomNotSeenBeforeMayBeWhatWasLost) {
  look(0, {thing(0, 0, 1)});
  pass(600);
  lookAtEmpty(0);
  pass(600);
  look(1, {thing(1, 0, 1)});
  const auto found = objects();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found.at(1).state, ObjectState::Gone);
  const MapObject& other = found.rbegin()->second;
  EXPECT_EQ(other.state, ObjectState::Static);
  ASSERT_TRUE(other.maybeSameAs);
  EXPECT_EQ(other.maybeSameAs->id, 1U);
  EXPECT_GT(other.maybeSameAs->probability, 0.0);
  EXPECT_LT(other.maybeSameAs->probability, 0.5);
}

TEST_F(IdentityTest, WhatAppearsWhereNothingWasSeenBeforeIsWhatWasLost) {
  for (const bool isAnotherRun : {false, true}) {
    builder_ = MapBuilder(options(), setting());
    lookAtEmpty(1);
    look(0, {thing(0, 0, 1)});
    const ObjectId id = objects().begin()->first;
    pass(600);
    lookAtEmpty(0);
    if (isAnotherRun) restart();
    pass(600);
    look(1, {thing(1, 0, 1)});
    const auto found = objects();
    ASSERT_EQ(found.size(), 1U) << isAnotherRun;
    EXPECT_EQ(found.begin()->first, id);
    EXPECT_THAT(found.begin()->second, IsAt(22, ObjectState::Moved)) << isAnotherRun;
  }
}

TEST_F(IdentityTest, NobodyPushesAThingSoFarInSoShortATime) {
  lookAtEmpty(1);
  look(0, {thing(0, 0, 1)});
  lookAtEmpty(0);  // 3 s: 4.5 m at 1.5 m/s
  look(1, {thing(1, 0, 1)});
  const auto found = objects();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_FALSE(found.rbegin()->second.maybeSameAs);
}

TEST_F(IdentityTest, OfSeveralThatWereLostOneIsFoundAtMost) {
  lookAtEmpty(1);
  look(0, {thing(0, 0.8, 1), thing(0, -0.8, 2)});
  ASSERT_EQ(objects().size(), 2U);
  pass(600);
  lookAtEmpty(0);
  pass(600);
  look(1, {thing(1, 0, 1)});
  const auto found = objects();
  ASSERT_GE(found.size(), 2U) << "two were there, and one is there now";
  int there = 0;
  for (const auto& [id, object] : found) there += object.state == ObjectState::Gone ? 0 : 1;
  EXPECT_EQ(there, 1);
}

TEST_F(IdentityTest, EachOfTwoIsFoundNearWhereItStood) {
  look(0, {thing(0, 0.8, 1)});
  look(1, {thing(1, 0.8, 1)});
  ASSERT_EQ(objects().size(), 2U);
  pass(600);
  lookAtEmpty(0);
  lookAtEmpty(1);
  look(1, {thing(1, -0.8, 1)});
  look(0, {thing(0, -0.8, 1)});
  const auto found = objects();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found.at(1), IsAt(2, ObjectState::Moved));
  EXPECT_THAT(found.at(2), IsAt(22, ObjectState::Moved));
}

TEST_F(IdentityTest, AnIdIsNeverUsedAgain) {
  look(0, {thing(0, 0, 1)});
  look(1, {thing(1, 0, 1)}, 1);  // seen once: nobody is told of it, but its number is taken
  const SemanticMap map = builder_.map();
  ASSERT_EQ(map.objects.size(), 1U);
  EXPECT_GT(map.nextObjectId, 2U);
  restart();
  pass(60);
  look(2, {thing(2, 0, 1)});
  EXPECT_EQ(objects().rbegin()->first, map.nextObjectId);
}

MATCHER_P(IsTheSameAs, b, "") {
  return arg.id == b.id && arg.classId == b.classId && arg.probability == b.probability &&
         arg.centroid_m == b.centroid_m && arg.box_m.min() == b.box_m.min() && arg.box_m.max() == b.box_m.max() &&
         arg.orientedBox.T_map_box.matrix() == b.orientedBox.T_map_box.matrix() &&
         arg.orientedBox.size_m == b.orientedBox.size_m && arg.firstSeen_s == b.firstSeen_s &&
         arg.lastSeen_s == b.lastSeen_s && arg.views == b.views && arg.zone == b.zone && arg.state == b.state &&
         arg.maybeSameAs.has_value() == b.maybeSameAs.has_value();
}

/// Sees rooms one after the other, and goes on from what was remembered.
class RememberedMapTest : public IdentityTest {
 protected:
  std::set<odometry::KeyframeId> keyframes() {
    std::set<odometry::KeyframeId> ids;
    for (const auto& [id, keyframe] : builder_.map().keyframes) ids.insert(id);
    return ids;
  }
  void goOn() {
    const SemanticMap map = builder_.map();
    const MapMemory memory = builder_.memory(keyframes());
    builder_ = MapBuilder(options(), setting());
    builder_.restore(map, memory);
  }
};

TEST_F(RememberedMapTest, WhatIsReadIsToldAgainToTheLastDigit) {
  look(0, {thing(0, 0.5, 1), thing(0, -0.5, 2, kBed)}, 3);
  look(1, {thing(1, 0, 1)}, 2);  // as little as makes an object
  lookAtEmpty(0);
  look(2, {thing(2, 0, 1)}, 1);  // not told of yet
  const SemanticMap before = builder_.map();
  ASSERT_EQ(before.objects.size(), 3U);
  for (const bool hasMemory : {true, false}) {
    MapBuilder again(options(), setting());
    again.restore(before, hasMemory ? builder_.memory(keyframes()) : MapMemory{});
    const SemanticMap after = again.map();
    ASSERT_EQ(after.objects.size(), before.objects.size()) << hasMemory;
    for (const auto& [id, object] : before.objects) EXPECT_THAT(after.objects.at(id), IsTheSameAs(object)) << hasMemory;
    EXPECT_GE(after.nextObjectId, before.nextObjectId);
    EXPECT_TRUE(again.takeChanges().objects.empty()) << "nothing needs to be written";
    EXPECT_TRUE(again.takeChanges().tiles.empty());
    ASSERT_EQ(after.cloud.size(), before.cloud.size());
    for (const auto& [id, tile] : before.cloud) EXPECT_EQ(after.cloud.at(id).points.size(), tile.points.size());
  }
}

TEST_F(RememberedMapTest, TenRunsLeaveAloneWhatTheyDoNotSee) {
  look(0, {thing(0, 0.5, 1), thing(0, -0.5, 2)}, 3);
  look(1, {thing(1, 0, 1)}, 2);
  const auto before = objects();
  ASSERT_EQ(before.size(), 3U);
  for (int run = 1; run <= 10; ++run) {
    goOn();
    pass(3600);
    look(2 + run % 3, {thing(2 + run % 3, 0, 1)}, 3);
    const auto after = objects();
    for (const auto& [id, object] : before) {
      ASSERT_EQ(after.count(id), 1U) << run;
      EXPECT_THAT(after.at(id), IsTheSameAs(object)) << run;
    }
  }
  EXPECT_EQ(objects().size(), 6U);
}

TEST_F(RememberedMapTest, WhatWasSeenOnceCountsInTheNextRun) {
  look(0, {thing(0, 0, 1)}, 1);
  ASSERT_TRUE(objects().empty());
  goOn();
  look(0, {thing(0, 0, 1)}, 1);
  ASSERT_EQ(objects().size(), 1U) << "seen twice in all";
  EXPECT_EQ(objects().begin()->second.views, 2);
}

TEST_F(RememberedMapTest, ZonesOfTheNewRunTakeTheirPlace) {
  look(0, {thing(0, 0, 1)}, 3);
  const SemanticMap before = builder_.map();
  MapSetting zoned = setting();
  zoned.zones = Zones({{"ward", {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}}});
  builder_ = MapBuilder(options(), zoned);
  builder_.restore(before);
  const MapParts changed = builder_.takeChanges();
  EXPECT_THAT(changed.keyframes, testing::ElementsAre(1));
  EXPECT_THAT(changed.objects, testing::ElementsAre(1));
  EXPECT_EQ(builder_.map(changed).objects.at(1).zone, "ward");
}

}  // namespace
}  // namespace wardslam::mapping
