#include "wardslam/storage/map_copy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::storage {
namespace {

class MapCopyTest : public testing::Test {
 protected:
  MapCopyTest() { MapFile::create(map_, {ward_.labels, ""}).write(everythingOf(ward_)); }

  [[nodiscard]] std::string bytes() const {
    std::ifstream file(map_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static void change(const MapCopy& copy) {
    MapChanges changes;
    changes.removedObjects = {1};
    MapFile::open(copy.path(), MapAccess::Write).write(changes);
  }

  test::TemporaryFolder folder_;
  std::filesystem::path map_ = folder_.path() / "ward.wardmap";
  mapping::SemanticMap ward_ = test::makeWard();
};

TEST_F(MapCopyTest, HoldsWhatTheMapHoldsAndLeavesItAsItIs) {
  const std::string before = bytes();
  const MapCopy copy(map_);
  EXPECT_EQ(copy.path(), map_.string() + ".grown");
  EXPECT_THAT(MapFile::open(copy.path()).check(), testing::IsEmpty());
  EXPECT_EQ(MapFile::open(copy.path()).read().objects.size(), ward_.objects.size());
  change(copy);
  EXPECT_EQ(bytes(), before);
  copy.remove();
  EXPECT_EQ(bytes(), before);
  EXPECT_FALSE(std::filesystem::exists(copy.path()));
}

TEST_F(MapCopyTest, TakesThePlaceOfTheMap) {
  const MapCopy copy(map_);
  change(copy);
  copy.takePlace();
  EXPECT_EQ(MapFile::open(map_).read().objects.count(1), 0U);
  EXPECT_FALSE(std::filesystem::exists(copy.path()));
}

TEST_F(MapCopyTest, PutsAsideWhatAKilledRunLeft) {
  const MapCopy first(map_);
  EXPECT_FALSE(first.leftBehind());
  change(first);
  const MapCopy second(map_);
  EXPECT_EQ(MapFile::open(second.path()).read().objects.count(1), 1U);
  ASSERT_EQ(second.leftBehind(), map_.string() + ".grown.old");
  EXPECT_EQ(MapFile::open(*second.leftBehind()).read().objects.count(1), 0U);
}

TEST_F(MapCopyTest, ReplacesWhatIsNoMap) {
  std::ofstream(map_.string() + ".grown") << "half of something";
  const MapCopy copy(map_);
  EXPECT_FALSE(copy.leftBehind());
  EXPECT_EQ(MapFile::open(copy.path()).read().objects.count(1), 1U);
}

TEST_F(MapCopyTest, WantsAMap) { EXPECT_THROW(MapCopy(folder_.path() / "none.wardmap"), core::InputError); }

}  // namespace
}  // namespace wardslam::storage
