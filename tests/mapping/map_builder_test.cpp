#include "wardslam/mapping/map_builder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "mapping/scene.h"

namespace wardslam::mapping {
namespace {

using scene::box;
using scene::cameraAt;
using scene::chair;
using scene::Thing;
using scene::wall;

/// As tracking hands it over: by the map as it knows it, and by the keyframe before.
odometry::Keyframe keyframe(odometry::KeyframeId id, const Eigen::Isometry3d& T_map_cam, std::uint32_t submap = 0,
                            const Eigen::Isometry3d& T_map_previous = cameraAt({0, 0, 1})) {
  odometry::Keyframe keyframe;
  keyframe.id = id;
  keyframe.submap = submap;
  keyframe.T_map_cam = T_map_cam;
  keyframe.T_previous_cam = T_map_previous.inverse() * T_map_cam;
  return keyframe;
}

MappingOptions options() {
  MappingOptions options;
  options.cloud.pixel_step = 1;  // the images are small
  options.cloud.mover_margin_px = 3;
  return options;
}

/// A builder with a keyframe in (0, 0, 1) that looks along x, and a clock.
class MapBuilderTest : public testing::Test {
 protected:
  MapBuilderTest() : builder_(options(), setting()) { builder_.addKeyframe(keyframe(1, cameraAt({0, 0, 1}))); }

  static MapSetting setting() {
    MapSetting setting;
    setting.moving.set(scene::kPerson);
    setting.movable.set(scene::kChair);
    return setting;
  }

  /// Looks `times` times from near the keyframe.
  void look(const std::vector<Thing>& things, int times, const Eigen::Vector3d& from_m = {0, 0, 1}) {
    for (int i = 0; i < times; ++i) builder_.add(scene::render(things, cameraAt(from_m), stamp_s_ += 0.2));
  }

  /// All published points, in the map frame, with what they are.
  struct Point {
    Eigen::Vector3d p_map_m;
    SemanticPoint point;
  };
  std::vector<Point> points() {
    std::vector<Point> all;
    const SemanticMap map = builder_.map();
    for (const auto& [id, tile] : map.cloud) {
      for (const SemanticPoint& point : tile.points) {
        all.push_back({map.keyframes.at(id).T_map_cam * point.p_cam_m.cast<double>(), point});
      }
    }
    return all;
  }

  std::size_t pointsIn(const Eigen::AlignedBox3d& box_m) {
    const auto all = points();
    return static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(), [&](const Point& p) { return box_m.contains(p.p_map_m); }));
  }

  std::vector<MapObject> objects() {
    std::vector<MapObject> all;
    for (const auto& [id, object] : builder_.map().objects) all.push_back(object);
    return all;
  }

  MapBuilder builder_;
  double stamp_s_ = 100.0;
};

TEST_F(MapBuilderTest, AWallIsAFlatSheetOfPointsThatDoesNotGrowWithTime) {
  look({wall()}, 3);
  const auto first = points();
  ASSERT_GT(first.size(), 1000U);
  for (const Point& p : first) {
    EXPECT_NEAR(p.p_map_m.x(), 3.0, 1e-3);
    EXPECT_EQ(p.point.classId, 0);
    EXPECT_EQ(p.point.color_rgb, (std::array<std::uint8_t, 3>{180, 190, 200}));
  }
  look({wall()}, 10);
  EXPECT_EQ(points().size(), first.size());
  EXPECT_TRUE(objects().empty());
}

TEST_F(MapBuilderTest, AChairIsAnObjectWithItsClassAndPlace) {
  look({wall(), chair(2, 0, 7)}, 4);
  ASSERT_EQ(objects().size(), 1U);
  const MapObject found = objects().front();
  EXPECT_EQ(found.classId, scene::kChair);
  EXPECT_EQ(found.state, ObjectState::Static);
  EXPECT_EQ(found.views, 4);
  EXPECT_GT(found.probability, 0.7);
  EXPECT_DOUBLE_EQ(found.firstSeen_s, 100.2);
  EXPECT_DOUBLE_EQ(found.lastSeen_s, 100.8);
  EXPECT_NEAR(found.box_m.min().x(), 1.75, 0.03);  // only its front and its top are seen
  EXPECT_NEAR(found.box_m.center().y(), 0.0, 0.03);
  EXPECT_NEAR(found.box_m.sizes().y(), 0.5, 0.05);
  EXPECT_NEAR(found.box_m.max().z(), 1.0, 0.03);
  for (const Point& p : points()) EXPECT_EQ(p.point.object, p.p_map_m.x() < 2.5 ? found.id : 0);
}

TEST_F(MapBuilderTest, InstanceIdsNeedNotBeTheSameInTwoImages) {
  look({wall(), chair(2, -0.5, 1), chair(2, 0.5, 2)}, 2);
  look({wall(), chair(2, -0.5, 2), chair(2, 0.5, 1)}, 2);
  ASSERT_EQ(objects().size(), 2U);
  EXPECT_EQ(objects()[0].views, 4);
  EXPECT_EQ(objects()[1].views, 4);
}

TEST_F(MapBuilderTest, TwoChairsSideBySideStayTwo) {
  for (double y_m = -0.4; y_m <= 0.4; y_m += 0.1) look({wall(), chair(2, -0.27, 1), chair(2, 0.27, 2)}, 1, {0, y_m, 1});
  const auto found = objects();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(std::abs(found[0].box_m.center().y() - found[1].box_m.center().y()), 0.54, 0.04);
}

TEST_F(MapBuilderTest, AThingSeenInHalvesIsOneOnceItWasSeenWhole) {
  const Thing bed{box({2, 0, 0.5}, {0.8, 1.6, 0.6}), scene::kBed, 1, {200, 220, 220}};
  const Thing left{box({2, 0.4, 0.5}, {0.8, 0.8, 0.6}), scene::kBed, 1, {200, 220, 220}};
  const Thing right{box({2, -0.4, 0.5}, {0.8, 0.8, 0.6}), scene::kBed, 2, {200, 220, 220}};
  const Thing pillar{box({1, 0, 1}, {0.2, 0.2, 2}), 0, 0, {90, 90, 90}};
  look({wall(), pillar, left, right}, 2);
  ASSERT_EQ(objects().size(), 2U);
  look({wall(), bed}, 5);
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_NEAR(objects().front().box_m.sizes().y(), 1.6, 0.08);
}

TEST_F(MapBuilderTest, SomethingBeforeAThingDoesNotCutItInTwo) {
  const Thing bed{box({2, 0, 0.5}, {0.8, 1.6, 0.6}), scene::kBed, 1, {200, 220, 220}};
  const Thing pillar{box({1, 0, 1}, {0.2, 0.3, 2}), 0, 0, {90, 90, 90}};
  look({wall(), pillar, bed}, 4);
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_NEAR(objects().front().box_m.sizes().y(), 1.6, 0.08);
}

TEST_F(MapBuilderTest, AMaskThatBleedsOntoTheWallDoesNotMakeTheThingLarger) {
  for (int i = 0; i < 4; ++i) {
    View view = scene::render({wall(), chair(2, 0, 1)}, cameraAt({0, 0, 1}), stamp_s_ += 0.2);
    const cv::Mat mask = view.segmentation.instanceIds == 1;
    cv::Mat widened;
    cv::Mat kernel = cv::Mat::ones(7, 7, CV_8UC1);
    widened = mask.clone();
    for (int v = 3; v < mask.rows - 3; ++v) {
      for (int u = 3; u < mask.cols - 3; ++u) {
        if (cv::countNonZero(mask(cv::Rect(u - 3, v - 3, 7, 7))) > 0) widened.at<std::uint8_t>(v, u) = 255;
      }
    }
    view.segmentation.instanceIds.setTo(1, widened);
    view.segmentation.classIds.setTo(scene::kChair, widened);
    builder_.add(view);
  }
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_LT(objects().front().box_m.max().x(), 2.3);
  EXPECT_NEAR(objects().front().box_m.sizes().y(), 0.5, 0.05);
}

TEST_F(MapBuilderTest, AClassThatFlipsIsVotedOn) {
  look({wall(), chair(2, 0, 1)}, 5);
  look({wall(), chair(2, 0, 1, scene::kCouch)}, 2);
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_EQ(objects().front().classId, scene::kChair);
  EXPECT_EQ(objects().front().views, 7);
  EXPECT_LT(objects().front().probability, 5.0 / 7.0 + 1e-9);
}

TEST_F(MapBuilderTest, AThingSeenOnceIsNotYetAnObject) {
  look({wall(), chair(2, 0, 1)}, 1);
  EXPECT_TRUE(objects().empty());
}

TEST_F(MapBuilderTest, ACarriedThingIsOneThingThatMoved) {
  look({wall(), chair(2, 0.8, 1)}, 5);
  ASSERT_EQ(objects().size(), 1U);
  const ObjectId id = objects().front().id;
  look({wall()}, 8);
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_EQ(objects().front().state, ObjectState::Gone);
  EXPECT_NEAR(objects().front().box_m.center().y(), 0.8, 0.05);
  look({wall(), chair(2, -0.8, 5)}, 5);
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_EQ(objects().front().id, id);
  EXPECT_EQ(objects().front().state, ObjectState::Moved);
  EXPECT_NEAR(objects().front().box_m.center().y(), -0.8, 0.05);
  EXPECT_EQ(pointsIn(chair(2, 0.8, 0).box_m), 0U);
}

TEST_F(MapBuilderTest, AThingThatComesBackIsThere) {
  look({wall(), chair(2, 0.8, 1)}, 5);
  look({wall()}, 8);
  look({wall(), chair(2, 0.8, 1)}, 5);
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_NE(objects().front().state, ObjectState::Gone);
}

TEST_F(MapBuilderTest, APersonNeverEnters) {
  const Thing person{box({2, 0, 0.9}, {0.3, 0.5, 1.8}), scene::kPerson, 1, {10, 20, 200}};
  look({wall(), person}, 10);
  EXPECT_TRUE(objects().empty());
  EXPECT_EQ(pointsIn(box({2, 0, 0.9}, {0.5, 0.7, 2.0})), 0U);
  EXPECT_GT(points().size(), 1000U);  // the wall beside does
}

TEST_F(MapBuilderTest, APersonNobodySegmentedIsGoneOnceTheWallBehindIsSeen) {
  const Thing person{box({2, 0, 0.9}, {0.3, 0.5, 1.8}), 0, 0, {10, 20, 200}};
  const Eigen::AlignedBox3d place = box({2, 0, 0.9}, {0.5, 0.7, 2.0});
  look({wall(), person}, 30);
  EXPECT_GT(pointsIn(place), 100U);
  look({wall()}, 8);
  EXPECT_EQ(pointsIn(place), 0U);
}

TEST_F(MapBuilderTest, WhatIsBehindSomethingElseStays) {
  look({wall(), chair(2, 0, 1)}, 5);
  const Thing screen{box({1, 0, 1}, {0.1, 3, 3}), 0, 0, {90, 90, 90}};
  look({wall(), chair(2, 0, 1), screen}, 10);
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_EQ(objects().front().state, ObjectState::Static);
  EXPECT_GT(objects().front().probability, 0.7);  // it could not be seen, so not seeing it says nothing
}

TEST_F(MapBuilderTest, WhatMayMoveDoesNotEnter) {
  for (int i = 0; i < 5; ++i) {
    View view = scene::render({wall(), chair(2, 0, 1)}, cameraAt({0, 0, 1}), stamp_s_ += 0.2);
    view.mayMove = view.segmentation.instanceIds == 1;
    builder_.add(view);
  }
  EXPECT_TRUE(objects().empty());
  EXPECT_EQ(pointsIn(box({2, 0, 0.5}, {0.6, 0.6, 1.2})), 0U);
}

TEST_F(MapBuilderTest, AThingPushedOutOfThePictureStandsOnlyWhereItIsFoundAgain) {
  const auto push = [&](double y_m, bool isSuspected) {
    View view =
        scene::render({chair(2, y_m, 1)}, cameraAt({0, 0, 1}), stamp_s_ += 0.2);  // nothing behind it is measured
    if (isSuspected) view.mayMove = view.segmentation.instanceIds == 1;
    builder_.add(view);
  };
  push(0.0, true);
  push(0.5, false);  // who pushes it is not in the picture any more
  push(0.55, false);
  stamp_s_ += 5.0;
  for (int i = 0; i < 4; ++i) push(-0.8, false);
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_EQ(objects().front().state, ObjectState::Moved);
  EXPECT_NEAR(objects().front().box_m.center().y(), -0.8, 0.05);
  EXPECT_EQ(pointsIn(chair(2, 0.5, 0).box_m), 0U);
}

TEST_F(MapBuilderTest, EverythingFollowsACorrectedKeyframeAndDoublesBecomeOne) {
  look({wall(), chair(2, 0, 1)}, 4);
  const std::size_t once = points().size();
  const Eigen::Isometry3d truth = cameraAt({0, 0, 1});
  const Eigen::Isometry3d wrong = cameraAt({-0.5, 0, 1});  // believes to stand half a metre behind
  builder_.addKeyframe(keyframe(2, wrong));
  for (int i = 0; i < 4; ++i) builder_.add(scene::render({wall(), chair(2, 0, 1)}, truth, stamp_s_ += 0.2, 2, truth));
  EXPECT_GT(points().size(), once * 3 / 2);
  odometry::MapUpdate update;
  update.T_map_cam[2] = truth;
  builder_.apply(update);
  EXPECT_LT(points().size(), once * 11 / 10);
  for (const Point& p : points()) EXPECT_GT(p.p_map_m.x(), 1.72) << p.p_map_m.transpose();
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_NEAR(objects().front().box_m.min().x(), 1.75, 0.03);
}

TEST_F(MapBuilderTest, ObjectsMoveWithTheirKeyframe) {
  look({wall(), chair(2, 0, 1)}, 4);
  odometry::MapUpdate update;
  update.T_map_cam[1] = cameraAt({0, 1, 1});
  builder_.apply(update);
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_NEAR(objects().front().box_m.center().y(), 1.0, 0.03);
}

TEST_F(MapBuilderTest, AnotherSubmapBelongsToTheMapOnceItIsJoined) {
  look({wall()}, 3);
  const Eigen::Isometry3d T_other_cam = cameraAt({0, 5, 1});
  builder_.addKeyframe(keyframe(2, T_other_cam, 1));
  const std::vector<Thing> there{{box({3.05, 5, 1}, {0.1, 6, 4}), 0, 0, {}}, chair(2, 5, 3)};
  for (int i = 0; i < 4; ++i) builder_.add(scene::render(there, T_other_cam, stamp_s_ += 0.2, 2, T_other_cam));
  EXPECT_TRUE(objects().empty());
  EXPECT_EQ(builder_.map().keyframes.count(2), 0U);
  const MapParts changes = builder_.takeChanges();
  ASSERT_EQ(changes.objects.size(), 1U);
  const SemanticMap pieces = builder_.map(changes);
  EXPECT_EQ(pieces.objects.begin()->second.piece, 1U);
  EXPECT_EQ(pieces.keyframes.at(2).piece, 1U);
  EXPECT_EQ(pieces.cloud.count(2), 1U);
  odometry::MapUpdate update;
  update.T_map_cam[2] = cameraAt({0, 0, 1});  // it was the same place
  update.joined = odometry::SubmapJoin{1, 0};
  builder_.apply(update);
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_NEAR(objects().front().box_m.center().y(), 0.0, 0.03);
  EXPECT_EQ(builder_.map().keyframes.count(2), 1U);
  builder_.addKeyframe(keyframe(3, cameraAt({0, 5.5, 1}), 1, T_other_cam));  // odometry has not heard of it yet
  ASSERT_EQ(builder_.map().keyframes.count(3), 1U);
  EXPECT_TRUE(builder_.map().keyframes.at(3).T_map_cam.isApprox(cameraAt({0, 0.5, 1}), 1e-9));
}

TEST_F(MapBuilderTest, WhatIsYoungerThanAnUpdateMovesAsItsNewestKeyframe) {
  const std::vector<Thing> things{wall(), chair(2, 0, 1)};
  const Eigen::Isometry3d second = cameraAt({-0.3, 0, 1});
  builder_.addKeyframe(keyframe(2, second));
  for (int i = 0; i < 2; ++i) builder_.add(scene::render(things, second, stamp_s_ += 0.2, 2, second));
  builder_.addKeyframe(keyframe(3, cameraAt({7, 0, 1}), 1));  // of another submap, in a frame of its own
  static_cast<void>(builder_.takeChanges());
  odometry::MapUpdate update;
  update.newestKeyframe = 1;
  update.T_map_cam[1] = cameraAt({0, 2, 1});  // 2 m aside
  update.joined = odometry::SubmapJoin{1, 0};
  builder_.apply(update);
  EXPECT_EQ(builder_.takeChanges().keyframes.count(2), 1U);
  for (int i = 0; i < 2; ++i) builder_.add(scene::render(things, second, stamp_s_ += 0.2, 2, second));  // was underway
  const SemanticMap map = builder_.map();
  EXPECT_TRUE(map.keyframes.at(2).T_map_cam.isApprox(cameraAt({-0.3, 2, 1}), 1e-9));
  EXPECT_TRUE(map.keyframes.at(3).T_map_cam.isApprox(cameraAt({7, 0, 1}), 1e-9)) << "it is no matter of theirs";
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_EQ(objects().front().state, ObjectState::Static);
  EXPECT_NEAR(objects().front().box_m.center().y(), 2.0, 0.03);
}

TEST_F(MapBuilderTest, TellsWhatChanged) {
  look({wall(), chair(2, 0, 1)}, 3);
  MapParts changes = builder_.takeChanges();
  EXPECT_THAT(changes.keyframes, testing::ElementsAre(1));
  EXPECT_THAT(changes.tiles, testing::ElementsAre(1));
  EXPECT_EQ(changes.objects.size(), 1U);
  EXPECT_TRUE(builder_.takeChanges().empty());

  const Eigen::Isometry3d aside = cameraAt({0, 0, 1}, M_PI);
  builder_.addKeyframe(keyframe(2, aside));
  builder_.add(scene::render({{box({-3, 0, 1}, {0.1, 6, 4}), 0, 0, {}}}, aside, stamp_s_ += 0.2, 2, aside));
  changes = builder_.takeChanges();
  EXPECT_THAT(changes.keyframes, testing::ElementsAre(2));
  EXPECT_THAT(changes.tiles, testing::ElementsAre(2));
  EXPECT_TRUE(changes.objects.empty());
}

TEST_F(MapBuilderTest, ToBeToldWhatIsKnownChangesNothing) {
  look({wall(), chair(2, 0, 1)}, 3);
  static_cast<void>(builder_.takeChanges());
  odometry::MapUpdate update;
  update.T_map_cam[1] = cameraAt({0, 0, 1});
  builder_.apply(update);
  EXPECT_TRUE(builder_.takeChanges().empty());
}

TEST_F(MapBuilderTest, GivesTheNamedPartsOnly) {
  look({wall(), chair(2, 0, 1)}, 3);
  const ObjectId id = objects().front().id;
  MapParts parts;
  EXPECT_TRUE(builder_.map(parts).cloud.empty());
  parts.objects = {id, id + 100};
  EXPECT_EQ(builder_.map(parts).objects.size(), 1U);
  EXPECT_TRUE(builder_.map(parts).keyframes.empty());
}

TEST_F(MapBuilderTest, NamesTheZoneOfObjectsAndKeyframes) {
  MapSetting zoned = setting();
  zoned.zones = Zones({{"clean", {{1, -1}, {3, -1}, {3, 1}, {1, 1}}}});
  builder_ = MapBuilder(options(), zoned);
  builder_.addKeyframe(keyframe(1, cameraAt({0, 0, 1})));
  look({wall(), chair(2, 0, 1)}, 3);
  EXPECT_EQ(objects().front().zone, "clean");
  EXPECT_EQ(builder_.map().keyframes.at(1).zone, "");
  EXPECT_EQ(builder_.map().zones.size(), 1U);
}

TEST_F(MapBuilderTest, AMapTooLargeForItsFloorPlanHasAllElse) {
  look({wall(), chair(2, 0, 7)}, 4);
  builder_.addKeyframe(keyframe(2, cameraAt({100000.0, 100000.0, 1.0})));
  const SemanticMap map = builder_.map();
  EXPECT_TRUE(map.floorPlan.cells.empty());
  EXPECT_EQ(map.keyframes.size(), 2U);
  EXPECT_EQ(map.objects.size(), 1U);
  EXPECT_THAT(builder_.floorSeen().planTrouble, testing::HasSubstr("choose a larger mapping.floor_plan.resolution_m"));
}

TEST_F(MapBuilderTest, AViewOfAnUnknownKeyframeIsLeftOut) {
  builder_.add(scene::render({wall()}, cameraAt({0, 0, 1}), 1.0, 77));
  EXPECT_TRUE(builder_.map().cloud.empty());
}

TEST_F(MapBuilderTest, WithoutMasksThereIsACloudOfNoClass) {
  for (int i = 0; i < 3; ++i) {
    View view = scene::render({wall(), chair(2, 0, 1)}, cameraAt({0, 0, 1}), stamp_s_ += 0.2);
    view.segmentation = {};
    builder_.add(view);
  }
  EXPECT_GT(points().size(), 1000U);
  EXPECT_TRUE(objects().empty());
}

TEST_F(MapBuilderTest, WhatHungOnARemovedKeyframeStaysAndHangsOnItsHeir) {
  look({wall(), chair(2, 0, 1)}, 4);
  const Eigen::Isometry3d T_map_second = cameraAt({-0.4, 0, 1});
  builder_.addKeyframe(keyframe(2, T_map_second));
  const auto wider = scene::render({wall(), chair(2, 0, 1)}, T_map_second, stamp_s_ += 0.2, 2, T_map_second);
  for (int i = 0; i < 4; ++i) builder_.add(wider);
  const std::vector<Point> before = points();
  static_cast<void>(builder_.takeChanges());
  odometry::MapUpdate update;
  update.removedKeyframes = {{2, 1, cameraAt({0, 0, 1}).inverse() * T_map_second}};
  builder_.apply(update);

  const MapParts changes = builder_.takeChanges();
  EXPECT_EQ(changes.keyframes.count(2), 1U);
  EXPECT_THAT(changes.tiles, testing::ElementsAre(1, 2));
  EXPECT_TRUE(changes.objects.empty()) << "they stay where they were, to the last bit";
  const SemanticMap map = builder_.map();
  EXPECT_EQ(map.keyframes.count(2), 0U);
  EXPECT_EQ(map.cloud.count(2), 0U);
  ASSERT_EQ(points().size(), before.size());
  EXPECT_EQ(objects().size(), 1U);
  builder_.add(wider);  // came late: its keyframe is gone
  EXPECT_EQ(points().size(), before.size());

  update = {};
  update.T_map_cam[1] = cameraAt({0, 1, 1});
  builder_.apply(update);
  Eigen::AlignedBox3d was;
  Eigen::AlignedBox3d is;
  for (const Point& p : before) was.extend(p.p_map_m.cast<double>());
  for (const Point& p : points()) is.extend(p.p_map_m.cast<double>());
  EXPECT_TRUE(is.min().isApprox(was.min() + Eigen::Vector3d(0, 1, 0), 1e-2)) << "all of it moves along with the heir";
  EXPECT_TRUE(is.max().isApprox(was.max() + Eigen::Vector3d(0, 1, 0), 1e-2));
}

}  // namespace
}  // namespace wardslam::mapping
