#include "unfinished_map.h"

#include <gmock/gmock.h>

#include "merging/meeting_maps.h"

namespace wardslam::merging {
namespace {

class UnfinishedMapTest : public testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> left() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(maps_.file("")))
      names.push_back(entry.path().filename());
    return names;
  }
  [[nodiscard]] static storage::MapChanges named(const std::string& zone) {
    storage::MapChanges changes;
    changes.zones = std::vector<mapping::Zone>{{zone, {{0, 0}, {1, 0}, {1, 1}}}};
    return changes;
  }
  [[nodiscard]] std::string zoneOf(const std::string& file) const {
    return storage::MapFile::open(maps_.file(file)).read().zones.at(0).name;
  }

  const test::MeetingMaps maps_;
};

TEST_F(UnfinishedMapTest, IsNotThereBeforeItIsFinished) {
  {
    UnfinishedMap map(maps_.file("all.wardmap"), {}, named("begun"));
    map.write(named("gone on"));
    EXPECT_FALSE(std::filesystem::exists(maps_.file("all.wardmap")));
  }
  EXPECT_THAT(left(), testing::UnorderedElementsAre("a.wardmap", "b.wardmap")) << "nothing is left of it";
}

TEST_F(UnfinishedMapTest, TakesThePlaceOfAnotherWhenItIs) {
  { UnfinishedMap(maps_.file("all.wardmap"), {}, named("first")).finish(); }
  EXPECT_EQ(zoneOf("all.wardmap"), "first");
  {
    UnfinishedMap map(maps_.file("all.wardmap"), {}, named("second"));
    EXPECT_EQ(zoneOf("all.wardmap"), "first");
    map.write(named("third"));
    map.finish();
  }
  EXPECT_EQ(zoneOf("all.wardmap"), "third");
  EXPECT_THAT(left(), testing::UnorderedElementsAre("a.wardmap", "b.wardmap", "all.wardmap"));
}

}  // namespace
}  // namespace wardslam::merging
