#include "looks_between_runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mapping/scene.h"
#include "wardslam/mapping/map_builder.h"

namespace wardslam::mapping {
namespace {

using scene::cameraAt;
using scene::chair;
using scene::Thing;
using scene::wall;
using testing::IsEmpty;
using testing::SizeIs;

/// A camera in the origin that looks along x and measures one depth all over.
OtherLook lookAt(double stamp_s, double depth_m) {
  odometry::DepthImage image;
  image.depth_m = cv::Mat(150, 200, CV_32FC1, cv::Scalar(depth_m));
  return {stamp_s, cameraAt({0, 0, 0}), scene::camera(),
          std::make_shared<odometry::DepthView>(odometry::makeDepthView(image))};
}

/// Three points of thing 7, 2 m ahead, seen last at 100 s, and one of no thing, seen at 90 s.
class LooksBetweenRunsTest : public testing::Test {
 protected:
  LooksBetweenRunsTest() {
    TileMemory tile(4);
    for (std::size_t i = 0; i < 4; ++i) {
      tile[i].p_cam_m = {0.1F * static_cast<float>(i), 0.0F, 2.0F};
      tile[i].sightings = 3;
      tile[i].object = i < 3 ? 7 : 0;
      tile[i].votes[0] = {tile[i].object, 1.0F};
    }
    cloud_.restore(1, cameraAt({0, 0, 0}), tile);
  }

  [[nodiscard]] LaterLooks later(const std::vector<OtherLook>& looks) const {
    return lookLater(cloud_, looks, [](ObjectId id) { return id == 7 ? 100.0 : 90.0; });
  }

  SemanticCloud cloud_{CloudOptions()};
};

TEST_F(LooksBetweenRunsTest, TwoLaterLooksThroughAPointSayThatNothingIsThere) {
  EXPECT_THAT(later({lookAt(110, 4.0)}).seenThrough, IsEmpty()) << "one may be wrong";
  const auto found = later({lookAt(110, 4.0), lookAt(111, 4.0)});
  EXPECT_THAT(found.seenThrough, SizeIs(4));
  EXPECT_THAT(found.objects, SizeIs(1)) << "what is of no thing is no thing";
  EXPECT_EQ(found.objects.at(7).seenThrough, 3U);
  EXPECT_EQ(found.objects.at(7).standing, 0U);
}

TEST_F(LooksBetweenRunsTest, OnlyWhatIsSeenLaterCounts) {
  EXPECT_THAT(later({lookAt(91, 4.0), lookAt(92, 4.0)}).seenThrough, SizeIs(1)) << "the thing was seen after that";
  EXPECT_THAT(later({lookAt(80, 4.0), lookAt(81, 4.0)}).seenThrough, IsEmpty());
}

TEST_F(LooksBetweenRunsTest, WhatIsSeenThereStands) {
  const auto found = later({lookAt(110, 2.0), lookAt(111, 2.0)});
  EXPECT_THAT(found.seenThrough, IsEmpty());
  EXPECT_EQ(found.objects.at(7).standing, 3U);
  EXPECT_THAT(later({lookAt(110, 1.0), lookAt(111, 1.0)}).objects, IsEmpty()) << "hidden: nobody knows";
}

TEST_F(LooksBetweenRunsTest, TheLatestLooksOutweighThoseBefore) {
  std::vector<OtherLook> looks;
  for (int i = 0; i < 10; ++i) looks.push_back(lookAt(110 + i, 2.0));
  for (int i = 0; i < 4; ++i) looks.push_back(lookAt(130 + i, 4.0));
  EXPECT_THAT(later(looks).seenThrough, SizeIs(4)) << "it stood there, and was taken away";
}

TEST(IsGoneTest, IsWhatWasMostlySeenThroughOfWhatCouldBeSeen) {
  EXPECT_TRUE(isGone({10, 20}, 60));
  EXPECT_FALSE(isGone({11, 20}, 60)) << "less than twice as many";
  EXPECT_FALSE(isGone({0, 20}, 100)) << "a fifth of it";
  EXPECT_TRUE(isGone({0, 25}, 100));
  EXPECT_FALSE(isGone({0, 0}, 0));
}

TEST(WasEmptyBeforeTest, IsAPlaceHalfOfWhichWasSeenThrough) {
  const std::vector<Eigen::Vector3f> places_m = {{2, 0, 0}, {2, 0.1F, 0}, {5, 0, 0}, {5, 0.1F, 0}};
  EXPECT_TRUE(wasEmptyBefore(places_m, {lookAt(10, 4.0)}, 20)) << "of four places two are nearer than 4 m";
  EXPECT_FALSE(wasEmptyBefore(places_m, {lookAt(10, 4.0)}, 10)) << "at that time it stood there";
  EXPECT_FALSE(wasEmptyBefore(places_m, {lookAt(10, 1.0)}, 20));
  EXPECT_FALSE(wasEmptyBefore({}, {lookAt(10, 4.0)}, 20));
}

/// Two runs past one place, each a piece of its own: keyframe 1 at 100 s, keyframe 2 a day later.
class RunsTest : public testing::Test {
 protected:
  static MapSetting setting() {
    MapSetting setting;
    setting.movable.set(scene::kChair);
    return setting;
  }
  static MappingOptions options() {
    MappingOptions options;
    options.cloud.pixel_step = 1;
    return options;
  }

  /// What is seen from the origin in run `id`, in the frame of that run's piece: the map's, to keep it simple.
  void run(odometry::KeyframeId id, double start_s, const std::vector<Thing>& things) {
    auto keyframe = std::make_shared<odometry::Keyframe>();
    keyframe->id = id;
    keyframe->submap = static_cast<std::uint32_t>(id);
    keyframe->stamp_s = start_s;
    keyframe->T_map_cam = cameraAt({0, 0, 1});
    keyframe->camera = scene::camera();
    builder_.addKeyframe(*keyframe);
    for (int i = 0; i < 5; ++i) {
      const View view = scene::render(things, keyframe->T_map_cam, start_s + i, id, keyframe->T_map_cam);
      keyframe->depth = std::make_shared<odometry::DepthView>(odometry::makeDepthView({view.depth_m, {}}));
      builder_.add(view);
    }
    views_.push_back(keyframe);
    auto again = std::make_shared<odometry::Keyframe>(*keyframe);  // it looks twice
    again->stamp_s += 1;
    views_.push_back(again);
  }

  SemanticMap joined() {
    odometry::Pieces pieces;
    pieces.add(1, 1);
    pieces.add(2, 2);
    pieces.join({2, 1});
    builder_.compareRuns(views_, pieces);
    odometry::MapUpdate update;
    update.joined = odometry::SubmapJoin{2, 1};
    builder_.apply(update);
    return builder_.map();
  }

  MapBuilder builder_{options(), setting()};
  MapBuilder::Views views_;
};

TEST_F(RunsTest, AThingSeenInBothIsOne) {
  run(1, 100, {wall(), chair(2, 0, 7)});
  run(2, 86500, {wall(), chair(2, 0, 9)});
  const auto map = joined();
  ASSERT_THAT(map.objects, SizeIs(1));
  const MapObject& object = map.objects.begin()->second;
  EXPECT_EQ(object.id, 1U);
  EXPECT_EQ(object.state, ObjectState::Static);
  EXPECT_EQ(object.views, 10);
  EXPECT_EQ(object.firstSeen_s, 100.0);
  EXPECT_EQ(object.lastSeen_s, 86504.0);
}

TEST_F(RunsTest, WhatALaterRunSeesThroughIsGone) {
  run(1, 100, {wall(), chair(2, 0, 7)});
  run(2, 86500, {wall()});
  const auto map = joined();
  ASSERT_THAT(map.objects, SizeIs(1));
  EXPECT_EQ(map.objects.at(1).state, ObjectState::Gone);
  for (const auto& [id, tile] : map.cloud) {
    for (const auto& point : tile.points) EXPECT_EQ(point.object, 0U) << "no point of it is left";
  }
}

TEST_F(RunsTest, WhatAnEarlierRunDidNotSeeIsNew) {
  run(1, 100, {wall()});
  run(2, 86500, {wall(), chair(2, 0, 7)});
  const auto map = joined();
  ASSERT_THAT(map.objects, SizeIs(1));
  EXPECT_EQ(map.objects.begin()->second.state, ObjectState::Static);
}

TEST_F(RunsTest, AThingThatMovedBetweenThemIsOneThatMoved) {
  run(1, 100, {wall(), chair(2, -0.8, 7)});
  run(2, 86500, {wall(), chair(2, 0.8, 9)});
  const auto map = joined();
  ASSERT_THAT(map.objects, SizeIs(1));
  const MapObject& object = map.objects.begin()->second;
  EXPECT_EQ(object.id, 1U) << "it keeps its first number";
  EXPECT_EQ(object.state, ObjectState::Moved);
  EXPECT_NEAR(object.centroid_m.y(), 0.8, 0.05);
}

TEST_F(RunsTest, TwoAlikeOfWhichNeitherIsGoneStayTwo) {
  run(1, 100, {wall(), chair(2, -0.8, 7)});
  run(2, 86500, {wall(), chair(2, -0.8, 7), chair(2, 0.8, 9)});
  const auto map = joined();
  ASSERT_THAT(map.objects, SizeIs(2));
  for (const auto& [id, object] : map.objects) EXPECT_EQ(object.state, ObjectState::Static);
}

TEST_F(RunsTest, RunsThatNoPlaceConnectsSayNothingOfEachOther) {
  run(1, 100, {wall(), chair(2, 0, 7)});
  run(2, 86500, {wall()});
  odometry::Pieces pieces;
  pieces.add(1, 1);
  pieces.add(2, 2);
  builder_.compareRuns(views_, pieces);
  const auto map = builder_.map();
  ASSERT_THAT(map.objects, SizeIs(1));
  EXPECT_EQ(map.objects.at(1).state, ObjectState::Static);
}

}  // namespace
}  // namespace wardslam::mapping
