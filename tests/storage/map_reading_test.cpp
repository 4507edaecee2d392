#include "map_reading.h"

#include <gmock/gmock.h>

#include "blob_codecs.h"
#include "storage/stored_ward.h"

namespace wardslam::storage {
namespace {

using testing::IsEmpty;

using MapReadingTest = StoredWard;

/// What a builder may remember of the ward.
mapping::MapMemory makeMemory() {
  mapping::MapMemory memory;
  mapping::PointMemory point;
  point.p_cam_m = {1.0F, -2.0F, 3.0F};
  point.color_rgb = {1, 2, 3};
  point.precision_m2 = 4.5F;
  point.sigma_m = 0.25F;
  point.votes = {{{1, 2.5F}, {0, 0.5F}, {4, 0.25F}}};
  point.object = 1;
  point.sightings = 7;
  point.evidence = -1;
  memory.tiles[2] = {point, {}};
  mapping::ObjectMemory& object = memory.objects[1];
  object.votes = {{57, 3.5}, {60, 0.75}};
  object.views = 5;
  object.expected = 9;
  object.missed = 2;
  object.firstSeen_s = 900;
  object.lastSeen_s = 999;
  object.lastPlace_m = {0.5F, 0.25F, 1.0F};
  object.handled_s = 950;
  object.viewsToRest = 3;
  object.erased = 11;
  object.gone_s = 960;
  object.placeWasEmpty = true;
  object.state = mapping::ObjectState::Moved;
  memory.objects[12].views = 1;
  memory.pairs[{1, 12}] = {3, 4};
  return memory;
}

TEST_F(MapReadingTest, GivesBackWhatIsRemembered) {
  writeWard();
  MapChanges changes;
  changes.memory = makeMemory();
  changes.nextObjectId = 42;
  MapFile::open(path_, MapAccess::Write).write(changes);
  const auto memory = MapFile::open(path_).readMemory();
  ASSERT_EQ(memory.tiles.size(), 1U);
  ASSERT_EQ(memory.tiles.at(2).size(), 2U);
  EXPECT_EQ(encodeTileMemory(memory.tiles.at(2)), encodeTileMemory(makeMemory().tiles.at(2)));
  EXPECT_EQ(memory.tiles.at(2)[0].votes[2].weight, 0.25F);
  ASSERT_EQ(memory.objects.size(), 2U);
  const auto& object = memory.objects.at(1);
  const auto expected = makeMemory().objects.at(1);
  EXPECT_EQ(object.votes, expected.votes);
  EXPECT_EQ(std::tie(object.views, object.expected, object.missed, object.firstSeen_s, object.lastSeen_s),
            std::tie(expected.views, expected.expected, expected.missed, expected.firstSeen_s, expected.lastSeen_s));
  EXPECT_EQ(object.lastPlace_m, expected.lastPlace_m);
  EXPECT_EQ(
      std::tie(object.handled_s, object.viewsToRest, object.erased, object.gone_s, object.placeWasEmpty),
      std::tie(expected.handled_s, expected.viewsToRest, expected.erased, expected.gone_s, expected.placeWasEmpty));
  EXPECT_EQ(object.state, expected.state);
  EXPECT_EQ(memory.pairs.at({1, 12}).together, 3);
  EXPECT_EQ(memory.pairs.at({1, 12}).apart, 4);
  EXPECT_EQ(MapFile::open(path_).read().nextObjectId, 42U);
  EXPECT_THAT(MapFile::open(path_).check(), IsEmpty());
}

TEST_F(MapReadingTest, ForgetsWhatItRememberedOfATileThatChanged) {
  writeWard();
  MapChanges changes;
  changes.memory = makeMemory();
  MapFile file = MapFile::open(path_, MapAccess::Write);
  file.write(changes);
  MapChanges later;
  later.cloud[2] = ward_.cloud.at(2);
  file.write(later);
  EXPECT_TRUE(file.readMemory().tiles.empty());
  EXPECT_EQ(file.readMemory().objects.size(), 2U);
}

TEST_F(MapReadingTest, GivesBackHintsDepthNoiseAndHowSureLoopsAre) {
  ward_.objects.at(2).maybeSameAs = mapping::MaybeSame{6, 0.25};
  MapFile file = MapFile::create(path_, {ward_.labels, ""});
  MapChanges changes = everythingOf(ward_);
  const auto view = test::makeView(1, ward_);
  view->camera.depthNoise = {0.01, 0.02, 0.5};  // not a Kinect's
  view->submap = 3;
  changes.views = {view, test::makeView(2, ward_)};
  changes.loops = {{1, 2, Eigen::Isometry3d::Identity(), 77}};
  file.write(changes);
  ASSERT_TRUE(file.read().objects.at(2).maybeSameAs);
  EXPECT_EQ(file.read().objects.at(2).maybeSameAs->id, 6U);
  EXPECT_EQ(file.read().objects.at(2).maybeSameAs->probability, 0.25);
  EXPECT_FALSE(file.read().objects.at(1).maybeSameAs);
  EXPECT_EQ(file.readViews()[0].camera.depthNoise, (core::DepthNoise{0.01, 0.02, 0.5}));
  EXPECT_EQ(file.readViews()[1].camera.depthNoise, core::DepthNoise{});
  EXPECT_EQ(file.readFreeSubmap(), 4U);
  EXPECT_EQ(file.readLoops().at(0).inliers, 77);
}

}  // namespace
}  // namespace wardslam::storage
