#include "wardslam/merging/map_merge.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <optional>

#include "merging/furnished_maps.h"
#include "merging/meeting_maps.h"
#include "support/complaint.h"

namespace wardslam::merging {
namespace {

using test::MeetingMaps;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void goOn(const Progress& /*progress*/) {}

TEST(MapMergeTest, MapsWithAPlaceInCommonBecomeOne) {
  const MeetingMaps maps;
  const std::string before = bytesOf(maps.a()) + bytesOf(maps.b());
  const auto report = mergeMaps({maps.a(), maps.b()}, maps.file("all.wardmap"), {}, goOn);
  ASSERT_EQ(report.parts.size(), 1U);
  EXPECT_THAT(report.parts[0].files, ElementsAre("a.wardmap", "b.wardmap"));
  EXPECT_EQ(report.parts[0].keyframes, 28U);
  EXPECT_GE(report.placesFound, 2U);
  EXPECT_EQ(bytesOf(maps.a()) + bytesOf(maps.b()), before) << "the maps are as they were";

  const auto all = storage::MapFile::open(maps.file("all.wardmap"));
  EXPECT_THAT(all.check(), IsEmpty());
  EXPECT_EQ(all.info().keyframes, 28U);
  EXPECT_LT(all.info().trackingPoints, maps.runs().first.p_map_m.size() + maps.runs().second.p_map_m.size())
      << "points are one where both saw them";
  for (const auto& [id, keyframe] : all.read().keyframes)
    EXPECT_LT(test::distance_m(keyframe.T_map_cam, maps.runs().walk.T_first_cam(id)), 0.03) << id;
}

TEST(MapMergeTest, TheOrderDoesNotMatterAndTheSameMapsGiveTheSameBytes) {
  const MeetingMaps maps;
  mergeMaps({maps.a(), maps.b()}, maps.file("ab.wardmap"), {}, goOn);
  mergeMaps({maps.b(), maps.a()}, maps.file("ba.wardmap"), {}, goOn);
  mergeMaps({maps.a(), maps.b()}, maps.file("again.wardmap"), {}, goOn);
  EXPECT_TRUE(bytesOf(maps.file("ab.wardmap")) == bytesOf(maps.file("ba.wardmap")));
  EXPECT_TRUE(bytesOf(maps.file("ab.wardmap")) == bytesOf(maps.file("again.wardmap")));
}

TEST(MapMergeTest, WhatNoPlaceConnectsStaysAPartByItself) {
  const MeetingMaps maps(false);
  const auto report = mergeMaps({maps.a(), maps.b()}, maps.file("all.wardmap"), {}, goOn);
  ASSERT_EQ(report.parts.size(), 2U);
  EXPECT_THAT(report.parts[0].files, ElementsAre("a.wardmap")) << "the larger is the map";
  EXPECT_THAT(report.parts[1].files, ElementsAre("b.wardmap"));
  const auto all = storage::MapFile::open(maps.file("all.wardmap"));
  EXPECT_THAT(all.check(), IsEmpty());
  const auto parts = all.info().parts;
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_TRUE(parts[0].isMap);
  EXPECT_EQ(parts[0].from, "a.wardmap");
  EXPECT_EQ(parts[0].keyframes, 16U);
  EXPECT_EQ(parts[1].from, "b.wardmap");
  EXPECT_EQ(parts[1].keyframes, 8U);
  EXPECT_EQ(parts[1].firstStamp_s, 17.0);
  EXPECT_EQ(all.readViews().size(), 24U) << "nothing is thrown away";
}

TEST(MapMergeTest, ZonesOfAllMapsAreInIt) {
  const MeetingMaps maps;
  const mapping::Zone ward{"ward", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  MeetingMaps::write(maps.file("zoned.wardmap"), maps.runs().first, {ward});
  mergeMaps({maps.file("zoned.wardmap"), maps.b()}, maps.file("all.wardmap"), {}, goOn);
  const auto zones = storage::MapFile::open(maps.file("all.wardmap")).read().zones;
  ASSERT_EQ(zones.size(), 1U);
  EXPECT_EQ(zones.front().name, "ward");
}

TEST(MapMergeTest, WhatStoodThereLaterCounts) {
  using test::FurnishedMaps;
  constexpr core::ClassId kStays = mapping::scene::kCouch;
  constexpr core::ClassId kMoves = mapping::scene::kChair;
  constexpr core::ClassId kGoes = mapping::scene::kBed;
  const FurnishedMaps maps(
      {FurnishedMaps::cube(80, kStays, 1), FurnishedMaps::cube(110, kMoves, 2), FurnishedMaps::cube(95, kGoes, 3)},
      {FurnishedMaps::cube(80, kStays, 1), FurnishedMaps::cube(135, kMoves, 2)});
  pipeline::SlamOptions options;
  options.mapping = FurnishedMaps::mappingOptions();
  const auto report = mergeMaps({maps.a(), maps.b()}, maps.all(), options, goOn);
  ASSERT_EQ(report.parts.size(), 1U);

  std::map<core::ClassId, std::vector<mapping::MapObject>> things;
  for (const auto& [id, object] : storage::MapFile::open(maps.all()).read().objects)
    things[object.classId].push_back(object);
  ASSERT_EQ(things[kStays].size(), 1U);
  EXPECT_EQ(things[kStays][0].state, mapping::ObjectState::Static);
  ASSERT_EQ(things[kMoves].size(), 1U) << "one thing that moved";
  EXPECT_EQ(things[kMoves][0].state, mapping::ObjectState::Moved);
  EXPECT_LT((things[kMoves][0].centroid_m - maps.p_first_m(135)).norm(), 0.4);
  ASSERT_EQ(things[kGoes].size(), 1U);
  EXPECT_EQ(things[kGoes][0].state, mapping::ObjectState::Gone);
}

class InterruptedMergeTest : public testing::Test {
 protected:
  /// Ends it when so many keyframes, or whatever is counted, are done. Returns how far it was told to be first.
  std::size_t merge(const std::string& out, const std::string& unit = "", std::size_t last = 0,
                    const pipeline::SlamOptions& options = {}) {
    std::optional<std::size_t> first;
    const auto hear = [&](const Progress& progress) {
      if (progress.unit == "keyframe" && !first) first = progress.done;
      if (progress.unit == unit && progress.done == last) throw core::InputError("interrupted");
    };
    if (unit.empty()) {
      mergeMaps({maps_.a(), maps_.b()}, maps_.file(out), options, hear);
    } else {
      EXPECT_THROW(mergeMaps({maps_.a(), maps_.b()}, maps_.file(out), options, hear), core::InputError);
    }
    return first.value_or(0);
  }
  [[nodiscard]] bool isThere(const std::string& name) const { return std::filesystem::exists(maps_.file(name)); }

  const MeetingMaps maps_;
};

TEST_F(InterruptedMergeTest, NoMapIsWritten) {
  merge("all.wardmap", "keyframe", 19);
  std::vector<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(maps_.file(""))) left.push_back(entry.path().filename());
  EXPECT_THAT(left, testing::UnorderedElementsAre("a.wardmap", "b.wardmap", "all.wardmap.merging"));
  merge("all.wardmap");
  EXPECT_FALSE(isThere("all.wardmap.merging"));
}

TEST_F(InterruptedMergeTest, GoesOnFromWhereItWasToTheSameBytes) {
  EXPECT_EQ(merge("whole.wardmap"), 17U);
  for (const std::size_t last : {17, 22, 28}) {
    merge("all.wardmap", "keyframe", last);
    ASSERT_TRUE(isThere("all.wardmap.merging"));
    EXPECT_EQ(merge("all.wardmap"), last == 28 ? 0 : last + 1) << "what was done is not done again";
    EXPECT_TRUE(bytesOf(maps_.file("all.wardmap")) == bytesOf(maps_.file("whole.wardmap"))) << last;
    std::filesystem::remove(maps_.file("all.wardmap"));
  }
}

TEST_F(InterruptedMergeTest, PlacesAreKeptWhenEndedLater) {
  merge("whole.wardmap");
  merge("all.wardmap", "tile", 30);
  EXPECT_FALSE(isThere("all.wardmap"));
  EXPECT_FALSE(isThere("all.wardmap.partial"));
  EXPECT_EQ(merge("all.wardmap"), 0U) << "no keyframe has to look again";
  EXPECT_TRUE(bytesOf(maps_.file("all.wardmap")) == bytesOf(maps_.file("whole.wardmap")));
}

TEST_F(InterruptedMergeTest, BeginsAnewWhereTheWorkIsOfSomethingElse) {
  merge("all.wardmap", "keyframe", 20);
  const std::string work = bytesOf(maps_.file("all.wardmap.merging"));
  const auto beginsAnewWith = [&](const std::string& bytes, const pipeline::SlamOptions& options = {}) {
    std::ofstream(maps_.file("all.wardmap.merging"), std::ios::binary) << bytes;
    return merge("all.wardmap", "keyframe", 24, options) == 17;
  };
  EXPECT_FALSE(beginsAnewWith(work));
  EXPECT_TRUE(beginsAnewWith(work.substr(0, work.size() / 2))) << "damaged";
  EXPECT_TRUE(beginsAnewWith("nothing of the kind"));
  pipeline::SlamOptions others;
  others.graph.loop_verification.min_inliers += 1;
  EXPECT_TRUE(beginsAnewWith(work, others));
  MeetingMaps::write(maps_.a(), maps_.runs().first, {{"ward", {{0, 0}, {1, 0}, {1, 1}}}});
  EXPECT_TRUE(beginsAnewWith(work)) << "one of the maps has changed";
}

TEST(MapMergeTest, TellsHowFarItIs) {
  const MeetingMaps maps;
  std::vector<std::size_t> keyframes;
  mergeMaps({maps.a(), maps.b()}, maps.file("all.wardmap"), {}, [&](const Progress& progress) {
    if (progress.unit != "keyframe") return;
    EXPECT_EQ(progress.total, 28U);
    keyframes.push_back(progress.done);
  });
  ASSERT_EQ(keyframes.size(), 12U) << "those of the second map look for places of the first";
  EXPECT_EQ(keyframes.front(), 17U);
  EXPECT_EQ(keyframes.back(), 28U);
}

TEST(MapMergeTest, RefusesWhatMakesNoSense) {
  const MeetingMaps maps;
  const auto complaint = [&](const std::vector<std::filesystem::path>& files, const std::string& out) {
    return test::complaintOf([&] { mergeMaps(files, maps.file(out), {}, goOn); });
  };
  EXPECT_THAT(complaint({maps.a(), maps.b()}, "a.wardmap"), HasSubstr("is one of the maps"));
  std::filesystem::copy_file(maps.a(), maps.file("copy.wardmap"));
  EXPECT_THAT(complaint({maps.a(), maps.file("copy.wardmap")}, "all.wardmap"), HasSubstr("hold the same keyframes"));
  EXPECT_THAT(complaint({maps.a(), maps.file("none.wardmap")}, "all.wardmap"), HasSubstr("none.wardmap"));
}

}  // namespace
}  // namespace wardslam::merging
