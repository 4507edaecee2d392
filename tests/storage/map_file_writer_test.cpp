#include "wardslam/storage/map_file_writer.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include "support/full_disk.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::storage {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A graph and a builder that hear of keyframes together, as in a run.
class MapFileWriterTest : public testing::Test {
 protected:
  std::shared_ptr<odometry::Keyframe> insert(odometry::KeyframeId id, std::uint32_t submap) {
    const auto view = test::makeView(id, ward_);
    view->submap = submap;
    for (auto& sighting : view->sightings) {
      if (id > 1 && sighting.keypoint < 5) sighting.point -= 10;  // seen by the keyframe before, too
    }
    builder_.addKeyframe(*view);
    writer_.add(view);
    return view;
  }
  void insertAndWrite(odometry::KeyframeId id, std::uint32_t submap = 0) {
    const auto view = insert(id, submap);
    const auto update = mapper_.insert(view);
    builder_.apply(update);
    writer_.apply(update);
    writer_.write(builder_);
  }
  std::vector<odometry::KeyframeId> keyframes() const {
    std::vector<odometry::KeyframeId> ids;
    for (const auto& view : MapFile::open(path_).readViews()) ids.push_back(view.id);
    return ids;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "map.wardmap";
  mapping::SemanticMap ward_ = test::makeWard();
  mapping::MapBuilder builder_{{}, {ward_.labels, {}, mapping::Zones(ward_.zones)}};
  graph::Mapper mapper_{{}, {}};
  MapFileWriter writer_{path_, {ward_.labels, "deterministic: true\n"}};
};

TEST_F(MapFileWriterTest, EveryKeyframeIsInTheFileOnceItIsWritten) {
  EXPECT_THAT(keyframes(), IsEmpty());
  insertAndWrite(1);
  EXPECT_THAT(keyframes(), ElementsAre(1));
  insertAndWrite(2);
  EXPECT_THAT(keyframes(), ElementsAre(1, 2));
  EXPECT_THAT(MapFile::open(path_).check(), IsEmpty());
  EXPECT_EQ(MapFile::open(path_).read().zones.size(), 2U);
}

TEST_F(MapFileWriterTest, CorrectedPosesAndPointsFollow) {
  insertAndWrite(1);
  insertAndWrite(2);
  odometry::MapUpdate update;
  update.T_map_cam[1] = Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3));
  update.p_map_m[12] = {4, 5, 6};
  builder_.apply(update);
  writer_.apply(update);
  writer_.write(builder_);
  const auto file = MapFile::open(path_);
  EXPECT_EQ(file.read().keyframes.at(1).T_map_cam.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(file.readPoints().at(12), Eigen::Vector3d(4, 5, 6));
}

TEST_F(MapFileWriterTest, WhatASubmapSawWaitsUntilItIsJoined) {
  insertAndWrite(1, 0);
  insertAndWrite(2, 1);
  insertAndWrite(3, 1);
  EXPECT_THAT(keyframes(), ElementsAre(1));
  odometry::MapUpdate update;
  update.joined = odometry::SubmapJoin{1, 0};
  update.T_map_cam[2] = Eigen::Isometry3d(Eigen::Translation3d(9, 0, 0));
  builder_.apply(update);
  writer_.apply(update);
  writer_.write(builder_);
  EXPECT_THAT(keyframes(), ElementsAre(1, 2, 3));
  EXPECT_EQ(MapFile::open(path_).read().keyframes.at(2).T_map_cam.translation().x(), 9.0);
  EXPECT_THAT(MapFile::open(path_).check(), IsEmpty());
}

TEST_F(MapFileWriterTest, InTheEndTheFileHoldsTheGraphAsItIs) {
  for (const odometry::KeyframeId id : {1, 2, 3}) insertAndWrite(id);
  writer_.finish(builder_, mapper_);
  const auto file = MapFile::open(path_);
  const auto views = file.readViews();
  ASSERT_EQ(views.size(), 3U);
  for (const auto& view : views) {
    std::map<odometry::PointId, std::size_t> keypointOf;
    for (const auto& sighting : view.sightings) keypointOf[sighting.point] = sighting.keypoint;
    EXPECT_EQ(keypointOf, mapper_.graph().keyframes().at(view.id).keypointOf);
  }
  const auto points = file.readPoints();
  ASSERT_EQ(points.size(), mapper_.graph().points().size());
  for (const auto& [id, node] : mapper_.graph().points()) EXPECT_EQ(points.at(id), node.point.p_map_m);
  EXPECT_THAT(file.check(), IsEmpty());
  EXPECT_EQ(file.header().options, "deterministic: true\n");
}

TEST_F(MapFileWriterTest, AWriteThatFailsIsMadeUpForLater) {
  insertAndWrite(1);
  {
    const test::FullDisk full;
    insertAndWrite(2);
    EXPECT_THAT(keyframes(), ElementsAre(1));
    EXPECT_THROW(writer_.finish(builder_, mapper_), core::InputError);
  }
  insertAndWrite(3);
  EXPECT_THAT(keyframes(), ElementsAre(1, 2, 3));
  EXPECT_THAT(MapFile::open(path_).check(), IsEmpty());
}

TEST_F(MapFileWriterTest, AWriteThatFailsIsToldOnceAndCounted) {
  std::vector<std::string> told;
  writer_.setWarningSink([&told](const std::string& sentence) { told.push_back(sentence); });
  insertAndWrite(1);
  EXPECT_EQ(writer_.failedWrites(), 0U);
  for (const odometry::KeyframeId id : {2, 3}) {
    {
      const test::FullDisk full;
      insertAndWrite(id);
      writer_.write(builder_);
    }
    writer_.write(builder_);
  }
  EXPECT_EQ(writer_.failedWrites(), 4U);
  EXPECT_THAT(told, ElementsAre(HasSubstr("is the disk full"), HasSubstr("is the disk full"))) << "once each time";
  EXPECT_THAT(keyframes(), ElementsAre(1, 2, 3));
}

/// Another program that reads the map, and goes on reading what it has opened.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : database_(file.string()) {
    database_.exec("BEGIN");
    (void)keyframes();
  }
  [[nodiscard]] int keyframes() { return database_.execAndGet("SELECT count(*) FROM keyframes").getInt(); }

 private:
  SQLite::Database database_;
};

TEST_F(MapFileWriterTest, AReaderDelaysAndLosesNothing) {
  std::vector<std::string> told;
  writer_.setWarningSink([&told](const std::string& sentence) { told.push_back(sentence); });
  insertAndWrite(1);
  {
    Reader reader(path_);
    insertAndWrite(2);
    EXPECT_EQ(writer_.failedWrites(), 1U);
    EXPECT_THAT(told, ElementsAre(HasSubstr("is in use by another program")));
  }
  insertAndWrite(3);
  EXPECT_THAT(keyframes(), ElementsAre(1, 2, 3));
}

TEST_F(MapFileWriterTest, AReaderThatDoesNotLetGoLosesNothingEither) {
  insertAndWrite(1);
  Reader reader(path_);
  insertAndWrite(2);
  writer_.finish(builder_, mapper_);
  EXPECT_EQ(reader.keyframes(), 1) << "it reads on what it has opened";
  EXPECT_THAT(keyframes(), ElementsAre(1, 2));
  EXPECT_THAT(MapFile::open(path_).check(), IsEmpty());
  EXPECT_EQ(MapFile::open(path_).header().options, "deterministic: true\n");
  EXPECT_FALSE(std::filesystem::exists(path_.string() + ".partial"));
}

TEST_F(MapFileWriterTest, AnEarlierMapStaysUntilTheFirstKeyframe) {
  insertAndWrite(1);
  insertAndWrite(2);
  MapFileWriter next(path_, {ward_.labels, "deterministic: false\n"});
  mapping::MapBuilder builder{{}, {ward_.labels, {}, {}}};
  const graph::Mapper mapper{{}, {}};
  next.write(builder);
  next.finish(builder, mapper);
  EXPECT_THAT(keyframes(), ElementsAre(1, 2)) << "nothing was seen that could take its place";
  const auto view = test::makeView(3, ward_);
  builder.addKeyframe(*view);
  next.add(view);
  next.write(builder);
  EXPECT_THAT(keyframes(), ElementsAre(3));
  EXPECT_EQ(MapFile::open(path_).header().options, "deterministic: false\n");
}

TEST_F(MapFileWriterTest, GoesOnWithAMapThatIsThere) {
  const auto path = folder_.path() / "earlier.wardmap";
  {
    MapFile earlier = MapFile::create(path);
    MapChanges changes;
    changes.keyframes[1] = ward_.keyframes.at(1);
    changes.zones = ward_.zones;
    earlier.write(changes);
  }
  MapFileWriter writer(MapFile::open(path, MapAccess::Write));
  const auto view = test::makeView(2, ward_);
  builder_.addKeyframe(*view);
  writer.add(view);
  writer.write(builder_);
  EXPECT_EQ(MapFile::open(path).read().keyframes.size(), 2U);
  EXPECT_EQ(MapFile::open(path).readViews().size(), 1U);
  EXPECT_THROW(MapFileWriter(MapFile::open(path)).finish(builder_, mapper_), core::InputError) << "opened for reading";
}

TEST_F(MapFileWriterTest, ThrowsWhereNoFileCanBe) {
  EXPECT_THROW(MapFileWriter(folder_.path() / "missing" / "map.wardmap", {}), core::InputError);
}

TEST_F(MapFileWriterTest, ARemovedKeyframeLeavesTheFileWithAllThatNamesIt) {
  for (const odometry::KeyframeId id : {1, 2, 3}) insertAndWrite(id);
  odometry::MapUpdate update;
  update.removedKeyframes = {{2, 1, Eigen::Isometry3d(Eigen::Translation3d(1, 0, 0))}};
  builder_.apply(update);
  writer_.apply(update);
  writer_.write(builder_);
  EXPECT_THAT(keyframes(), ElementsAre(1, 3));
  EXPECT_THAT(MapFile::open(path_).check(), IsEmpty());
  EXPECT_EQ(MapFile::open(path_).read().keyframes.count(2), 0U);

  SQLite::Database database(path_.string());
  SQLite::Statement way(database, "SELECT from_keyframe, to_keyframe FROM edges WHERE kind = 'odometry'");
  ASSERT_TRUE(way.executeStep()) << "the way goes on from 1 to 3";
  EXPECT_EQ(way.getColumn(0).getInt(), 1);
  EXPECT_EQ(way.getColumn(1).getInt(), 3);
  EXPECT_FALSE(way.executeStep());
}

}  // namespace
}  // namespace wardslam::storage
