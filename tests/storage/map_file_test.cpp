#include "wardslam/storage/map_file.h"

#include "blob_codecs.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include "storage/stored_ward.h"
#include "support/complaint.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::storage {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace fs = std::filesystem;

using MapFileTest = StoredWard;

void expectEqual(const mapping::MapObject& a, const mapping::MapObject& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.classId, b.classId);
  EXPECT_EQ(a.probability, b.probability);
  EXPECT_EQ(a.centroid_m, b.centroid_m);
  EXPECT_EQ(a.box_m.min(), b.box_m.min());
  EXPECT_EQ(a.box_m.max(), b.box_m.max());
  EXPECT_TRUE(a.orientedBox.T_map_box.isApprox(b.orientedBox.T_map_box, 1e-12));
  EXPECT_EQ(a.orientedBox.size_m, b.orientedBox.size_m);
  EXPECT_EQ(a.color_rgb, b.color_rgb);
  EXPECT_EQ(a.firstSeen_s, b.firstSeen_s);
  EXPECT_EQ(a.lastSeen_s, b.lastSeen_s);
  EXPECT_EQ(a.views, b.views);
  EXPECT_EQ(a.zone, b.zone);
  EXPECT_EQ(a.state, b.state);
}

TEST_F(MapFileTest, WhatWasErasedIsNotReadableInTheFile) {
  const std::string name = "room of somebody who must not be named";
  ward_.zones[0].name = name;
  for (auto& entry : ward_.objects) entry.second.zone.clear();
  auto file = writeWard();
  ASSERT_NE(test::readText(path_).find(name), std::string::npos);
  MapChanges changes;
  changes.zones.emplace();
  file.write(changes);
  EXPECT_EQ(test::readText(path_).find(name), std::string::npos);
}

TEST_F(MapFileTest, CompactedItHoldsTheSameInLessRoom) {
  auto file = writeWard();
  MapChanges changes;
  changes.zones.emplace();
  for (int i = 0; i < 300; ++i) changes.zones->push_back({std::to_string(i) + std::string(200, 'z'), {}});
  file.write(changes);
  changes.zones = ward_.zones;
  file.write(changes);
  const auto size_bytes = file.info().size_bytes;
  file.compact();
  EXPECT_THAT(file.check(), IsEmpty());
  EXPECT_LT(file.info().size_bytes, size_bytes);
  EXPECT_EQ(file.info().keyframes, 3U);
  file.write(everythingOf(ward_));  // and can be gone on with
  EXPECT_EQ(MapFile::open(path_).info().zones, 2U);
  EXPECT_FALSE(fs::exists(path_.string() + ".partial"));
}

TEST_F(MapFileTest, GivesBackTheSemanticMap) {
  ward_.labels.rename(100, "drip stand");
  writeWard();
  const auto read = MapFile::open(path_).read();
  EXPECT_EQ(read.labels.name(100), "drip stand");
  EXPECT_EQ(read.labels.name(57), "chair");
  ASSERT_EQ(read.keyframes.size(), 3U);
  for (const auto& [id, keyframe] : ward_.keyframes) {
    EXPECT_EQ(read.keyframes.at(id).stamp_s, keyframe.stamp_s);
    EXPECT_EQ(read.keyframes.at(id).zone, keyframe.zone);
    EXPECT_EQ(read.keyframes.at(id).freeFan_cam_m, keyframe.freeFan_cam_m);
    ASSERT_EQ(read.keyframes.at(id).ground.has_value(), keyframe.ground.has_value());
    if (!keyframe.ground) continue;
    EXPECT_EQ(read.keyframes.at(id).ground->normal_cam, keyframe.ground->normal_cam);
    EXPECT_EQ(read.keyframes.at(id).ground->height_m, keyframe.ground->height_m);
    EXPECT_EQ(read.keyframes.at(id).ground->covariance, keyframe.ground->covariance);
    EXPECT_TRUE(read.keyframes.at(id).T_map_cam.isApprox(keyframe.T_map_cam, 1e-12));
  }
  ASSERT_EQ(read.objects.size(), ward_.objects.size());
  for (const auto& [id, object] : ward_.objects) expectEqual(read.objects.at(id), object);
  ASSERT_EQ(read.cloud.size(), 3U);
  EXPECT_EQ(read.cloud.at(2).points.at(7).p_cam_m, ward_.cloud.at(2).points.at(7).p_cam_m);
  ASSERT_EQ(read.zones.size(), 2U);
  EXPECT_EQ(read.zones[1].name, "clean zone");
  EXPECT_EQ(read.zones[1].polygon_m, ward_.zones[1].polygon_m);
  EXPECT_EQ(read.floorPlan.resolution_m, 0.05);
  EXPECT_EQ(read.floorPlan.origin_m, ward_.floorPlan.origin_m);
  EXPECT_EQ(cv::norm(read.floorPlan.cells, ward_.floorPlan.cells, cv::NORM_INF), 0);
  EXPECT_TRUE(MapFile::open(path_).read(CloudPart::LeaveOut).cloud.empty());
}

TEST_F(MapFileTest, GivesBackWhatKeyframesSaw) {
  writeWard();
  const auto views = MapFile::open(path_).readViews();
  ASSERT_EQ(views.size(), 3U);
  const auto expected = test::makeView(2, ward_);
  EXPECT_EQ(views[1].id, 2U);
  EXPECT_EQ(views[1].stamp_s, expected->stamp_s);
  EXPECT_EQ(views[1].camera.fx_px, 500.0);
  EXPECT_TRUE(views[1].T_map_cam.isApprox(expected->T_map_cam, 1e-12));
  EXPECT_TRUE(views[1].T_previous_cam->isApprox(*expected->T_previous_cam, 1e-12));
  EXPECT_EQ(views[1].features.size(), 10U);
  ASSERT_NE(views[1].depth, nullptr);
  EXPECT_EQ(views[1].depth->farthest_mm, expected->depth->farthest_mm);
  ASSERT_EQ(views[1].sightings.size(), 9U) << "without depth and never seen elsewhere, the last point is nowhere";
  EXPECT_EQ(views[1].sightings[3].point, 23U);
  EXPECT_EQ(views[1].sightings[3].keypoint, 3U);
  EXPECT_FALSE(views[0].T_previous_cam);
}

TEST_F(MapFileTest, PlacesPointsByTheDepthTheyWereSeenWith) {
  writeWard();
  const auto points = MapFile::open(path_).readPoints();
  EXPECT_EQ(points.size(), 27U);
  const auto view = test::makeView(2, ward_);
  const Eigen::Vector3d p_cam = view->camera.unproject({104.0, 201.5}, 2.0);
  EXPECT_TRUE(points.at(23).isApprox(view->T_map_cam * p_cam, 1e-12));
}

TEST_F(MapFileTest, GivesBackLoopsLabelsAndOptions) {
  writeWard();
  const auto file = MapFile::open(path_);
  const auto loops = file.readLoops();
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].from, 1U);
  EXPECT_EQ(loops[0].to, 3U);
  EXPECT_EQ(loops[0].T_from_to.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(file.header().options, "features:\n  key_points: 1000\n");
}

TEST_F(MapFileTest, LoopsThatAreWrittenAgainStayToTheLastBit) {
  MapFile file = writeWard();
  MapChanges changes;
  changes.graph = GraphContent{};
  const auto turned = [](double angle_rad) {
    const Eigen::Vector3d axis = Eigen::Vector3d(0.3, -angle_rad, 0.7).normalized();
    return Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(angle_rad, axis));
  };
  changes.loops = {{1, 2, turned(0.3)}, {1, 3, turned(1.1)}, {2, 3, turned(2.9)}};
  file.write(changes);
  const auto first = file.readLoops();
  ASSERT_EQ(first.size(), 3U);
  for (int i = 0; i < 10; ++i) {
    changes.loops = file.readLoops();
    file.write(changes);
  }
  const auto last = file.readLoops();
  ASSERT_EQ(last.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(last[i].T_from_to.matrix(), first[i].T_from_to.matrix()) << i;
  changes.loops = {last[0], {2, 3, turned(0.1)}};
  file.write(changes);
  ASSERT_EQ(file.readLoops().size(), 2U) << "those that are not named are gone";
  EXPECT_EQ(file.readLoops()[0].to, 2U);
  EXPECT_TRUE(file.readLoops()[1].T_from_to.isApprox(turned(0.1), 1e-12));
}

TEST_F(MapFileTest, TellsHowMuchItHolds) {
  writeWard();
  const auto info = MapFile::open(path_).info();
  EXPECT_EQ(info.schemaVersion, 5);
  EXPECT_EQ(info.pieces, 1U);
  EXPECT_EQ(info.keyframesElsewhere, 0U);
  EXPECT_EQ(info.size_bytes, fs::file_size(path_));
  EXPECT_EQ(info.keyframes, 3U);
  EXPECT_EQ(info.trackingPoints, 27U);
  EXPECT_EQ(info.loops, 1U);
  EXPECT_EQ(info.cloudPoints, 150U);
  EXPECT_EQ(info.objects, 7U);
  EXPECT_EQ(info.zones, 2U);
  EXPECT_EQ(info.firstStamp_s, test::kWardEnd_s - 2);
  EXPECT_EQ(info.lastStamp_s, test::kWardEnd_s);
}

TEST_F(MapFileTest, WritesWhatChanged) {
  MapFile file = writeWard();
  MapChanges changes;
  changes.keyframes[2] = ward_.keyframes.at(2);
  changes.keyframes[2].T_map_cam.translation().x() += 0.5;
  changes.cloud[1] = {};
  changes.cloud[3] = ward_.cloud.at(1);
  changes.cloud[3].points.resize(5);
  changes.objects = {ward_.objects.at(1)};
  changes.objects[0].state = mapping::ObjectState::Gone;
  changes.removedObjects = {5};
  changes.zones = {ward_.zones[0]};
  file.write(changes);

  const auto read = MapFile::open(path_).read();
  EXPECT_EQ(read.keyframes.at(2).T_map_cam.translation().x(), 1.5);
  EXPECT_EQ(read.keyframes.at(1).T_map_cam.translation().x(), 0.5);
  EXPECT_EQ(read.cloud.count(1), 0U);
  EXPECT_EQ(read.cloud.at(2).points.size(), 50U);
  EXPECT_EQ(read.cloud.at(3).points.size(), 5U);
  EXPECT_EQ(read.objects.at(1).state, mapping::ObjectState::Gone);
  EXPECT_EQ(read.objects.count(5), 0U);
  EXPECT_EQ(read.objects.size(), 6U);
  EXPECT_EQ(read.zones.size(), 1U);
  EXPECT_EQ(MapFile::open(path_).readViews().size(), 3U) << "what keyframes saw stays";
}

TEST_F(MapFileTest, PointsMoveFuseAndVanish) {
  MapFile file = writeWard();
  MapChanges changes;
  changes.p_map_m[11] = {7, 8, 9};
  changes.p_map_m[999] = {1, 1, 1};                      // unknown
  changes.fusedPoints = {{20, 12}, {21, 22}, {22, 13}};  // the second by way of the third
  changes.removedPoints = {14};
  file.write(changes);
  const auto points = file.readPoints();
  EXPECT_EQ(points.at(11), Eigen::Vector3d(7, 8, 9));
  for (const odometry::PointId absent : {999U, 20U, 21U, 22U, 14U}) EXPECT_EQ(points.count(absent), 0U) << absent;
  const auto views = file.readViews();
  EXPECT_EQ(views[0].sightings.size(), 8U);
  std::vector<odometry::PointId> seen;
  for (const auto& sighting : views[1].sightings) seen.push_back(sighting.point);
  EXPECT_THAT(seen, ElementsAre(12, 13, 23, 24, 25, 26, 27, 28)) << "21 and 22 became one";
  EXPECT_THAT(file.check(), IsEmpty());
}

TEST_F(MapFileTest, LaterSightingsOfAFusedPointGoToWhatItTurnedOutToBe) {
  MapFile file = MapFile::create(path_);
  MapChanges changes;
  changes.keyframes = ward_.keyframes;
  changes.views = {test::makeView(1, ward_)};
  file.write(changes);
  MapChanges fused;
  fused.fusedPoints = {{11, 12}};
  file.write(fused);
  auto view = test::makeView(2, ward_);
  view->sightings = {{11, 0}};
  MapChanges later;
  later.views = {view};
  file.write(later);
  const auto views = file.readViews();
  ASSERT_EQ(views.at(1).sightings.size(), 1U);
  EXPECT_EQ(views[1].sightings[0].point, 12U);
}

TEST_F(MapFileTest, AWriteIsWholeOrNothing) {
  MapFile file = writeWard();
  MapChanges changes;
  changes.removedObjects = {1};
  changes.zones = {{ward_.zones[0], ward_.zones[0]}};  // one name twice
  EXPECT_THROW(file.write(changes), core::InputError);
  EXPECT_EQ(file.read().objects.count(1), 1U);
  EXPECT_EQ(file.read().zones.size(), 2U);
}

TEST_F(MapFileTest, LeavesOneFile) {
  writeWard();
  std::vector<fs::path> files(fs::directory_iterator(folder_.path()), fs::directory_iterator());
  EXPECT_THAT(files, ElementsAre(path_));
}

TEST_F(MapFileTest, CreatingReplacesWhatWasThere) {
  writeWard();
  folder_.write("ward.wardmap-journal", "left by a run that was killed");
  EXPECT_TRUE(MapFile::create(path_).read().keyframes.empty());
  EXPECT_THAT(MapFile::open(path_).check(), IsEmpty());
}

TEST_F(MapFileTest, TheSameContentGivesTheSameBytes) {
  writeWard();
  const std::string first = test::readText(path_);
  writeWard();
  EXPECT_EQ(test::readText(path_), first);
}

TEST_F(MapFileTest, CanBeReadWhileItIsWritten) {
  MapFile writer = writeWard();
  const MapFile reader = MapFile::open(path_);
  EXPECT_EQ(reader.read().objects.size(), 7U);
  MapChanges changes;
  changes.removedObjects = {1};
  writer.write(changes);
  EXPECT_EQ(reader.read().objects.size(), 6U);
}

TEST_F(MapFileTest, AReaderCannotWrite) {
  writeWard();
  MapChanges changes;
  changes.removedObjects = {1};
  EXPECT_THROW(MapFile::open(path_).write(changes), core::InputError);
}

TEST_F(MapFileTest, SaysInOneSentenceWhatIsNoMap) {
  EXPECT_THAT(openingError(), HasSubstr("is not there"));
  fs::create_directory(path_);
  EXPECT_THAT(openingError(), HasSubstr("is a folder"));
  fs::remove(path_);
  folder_.write("ward.wardmap", "");
  EXPECT_THAT(openingError(), HasSubstr("is empty"));
  folder_.write("ward.wardmap", "ply\nformat ascii 1.0\n" + std::string(5000, 'x'));
  EXPECT_THAT(openingError(), HasSubstr("is not a WardSLAM map"));
  fs::remove(path_);
  SQLite::Database(path_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE t (x)");
  EXPECT_THAT(openingError(), HasSubstr("is a database, but not a WardSLAM map"));
}

TEST_F(MapFileTest, SaysThatItWasCutShort) {
  writeWard();
  fs::resize_file(path_, fs::file_size(path_) / 2);
  EXPECT_THAT(openingError(), HasSubstr("is damaged or cut short"));
  EXPECT_THAT(openingError(MapAccess::Write), HasSubstr("is damaged or cut short"));
  fs::resize_file(path_, 50);
  EXPECT_THAT(openingError(), HasSubstr("ward.wardmap: "));
}

TEST_F(MapFileTest, SaysThatItCannotBeCreated) {
  EXPECT_THROW((void)MapFile::create(folder_.path() / "missing" / "ward.wardmap"), core::InputError);
  EXPECT_THROW((void)MapFile::create(folder_.path()), core::InputError);
}

/// Stands between SQLite and the file system, and notes of every file that is deleted whether its folder is synced.
class WatchedFileSystem {
 public:
  WatchedFileSystem() {
    inner() = sqlite3_vfs_find(nullptr);
    synced().clear();
    watching_ = *inner();
    watching_.zName = "watching";
    watching_.xDelete = [](sqlite3_vfs* /*vfs*/, const char* name, int syncsFolder) {
      synced().push_back(syncsFolder);
      return inner()->xDelete(inner(), name, syncsFolder);
    };
    sqlite3_vfs_register(&watching_, 1);
  }
  ~WatchedFileSystem() {
    sqlite3_vfs_register(inner(), 1);
    sqlite3_vfs_unregister(&watching_);
  }
  WatchedFileSystem(const WatchedFileSystem&) = delete;
  WatchedFileSystem& operator=(const WatchedFileSystem&) = delete;

  static std::vector<int>& synced() {
    static std::vector<int> all;
    return all;
  }

 private:
  static sqlite3_vfs*& inner() {
    static sqlite3_vfs* vfs = nullptr;
    return vfs;
  }
  sqlite3_vfs watching_{};
};

/// A commit is one once the journal is gone, and a journal is gone once its folder is on the disk.
TEST_F(MapFileTest, ACommitSurvivesAPowerCut) {
  const WatchedFileSystem fileSystem;
  {
    MapFile file = writeWard();
    MapChanges changes;
    changes.removedObjects = {1};
    file.write(changes);
  }
  EXPECT_THAT(WatchedFileSystem::synced(),
              testing::AllOf(testing::SizeIs(testing::Ge(2U)), testing::Each(testing::Ne(0))));
}

/// Whatever byte is wrong: a sentence, or a map; never a crash. One in 97 bytes, which reaches every page.
TEST_F(MapFileTest, SurvivesFlippedBytes) {
  writeWard();
  const std::string sound = test::readText(path_);
  int noticed = 0;
  for (std::size_t i = 0; i < sound.size(); i += 97) {
    std::string damaged = sound;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    std::ofstream(path_, std::ios::trunc) << damaged;
    try {
      const auto file = MapFile::open(path_);
      noticed += file.check().empty() ? 0 : 1;
      (void)file.info();
      (void)file.read();
      (void)file.readViews();
    } catch (const core::InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("ward.wardmap: "));
      ++noticed;
    }
  }
  EXPECT_GT(noticed, 0);
}

/// Writes keyframe after keyframe and says so on `pipe`, until it is killed.
[[noreturn]] void driveForEver(const fs::path& path, int pipe) {
  MapFile file = MapFile::create(path);
  const auto ward = test::makeWard();
  for (std::uint64_t id = 1;; ++id) {
    auto view = test::makeView(1, ward);
    view->id = id;
    for (auto& sighting : view->sightings) sighting.point += id * 100;
    MapChanges changes;
    changes.keyframes[id] = ward.keyframes.at(1);
    changes.cloud[id] = ward.cloud.at(1);
    changes.objects = {ward.objects.at(1)};
    changes.zones = ward.zones;
    changes.floorPlan = ward.floorPlan;
    changes.views = {view};
    file.write(changes);
    if (::write(pipe, &id, sizeof id) != sizeof id) ::_exit(1);
  }
}

TEST_F(MapFileTest, KilledAtAnyMomentItHoldsAllThatWasWritten) {
  std::mt19937 random(1);
  for (int kill = 0; kill < 20; ++kill) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) driveForEver(path_, ends[1]);
    ::close(ends[1]);
    std::uint64_t written = 0;
    ASSERT_EQ(::read(ends[0], &written, sizeof written), ssize_t{sizeof written});
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 60000));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    for (std::uint64_t id = 0; ::read(ends[0], &id, sizeof id) == ssize_t{sizeof id};) written = id;
    ::close(ends[0]);

    const auto file = MapFile::open(path_);
    EXPECT_THAT(file.check(), IsEmpty());
    const std::size_t held = file.info().keyframes;
    EXPECT_GE(held, written);
    EXPECT_LE(held, written + 1) << "of the last one the child may not have been able to tell";
    EXPECT_EQ(file.readViews().size(), held);
  }
}

}  // namespace
}  // namespace wardslam::storage
