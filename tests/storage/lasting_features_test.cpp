#include "lasting_features.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "storage/stored_ward.h"

namespace wardslam::storage {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class LastingFeaturesTest : public StoredWard {
 protected:
  /// All sightings but those of `lost`, as a graph is written in the end.
  MapChanges without(const std::vector<odometry::PointId>& lost) const {
    MapChanges changes;
    GraphContent& graph = changes.graph.emplace();
    for (const auto& [id, keyframe] : ward_.keyframes) {
      const auto view = test::makeView(id, ward_);
      for (const auto& sighting : view->sightings) {
        if (std::find(lost.begin(), lost.end(), sighting.point) != lost.end()) continue;
        graph.sightings[id].push_back(sighting);
        graph.p_map_m[sighting.point] = {1, 2, 3};
      }
    }
    return changes;
  }
  std::string featuresBlob(odometry::KeyframeId keyframe) const {
    SQLite::Database database(path_.string());
    SQLite::Statement find(database, "SELECT features FROM views WHERE keyframe = " + std::to_string(keyframe));
    find.executeStep();
    const auto* const first = static_cast<const char*>(find.getColumn(0).getBlob());
    return {first, first + find.getColumn(0).getBytes()};
  }
  std::string fileBytes() const { return test::readText(path_); }
};

TEST_F(LastingFeaturesTest, WhatShowsNoPointThatLastedIsErased) {
  auto file = writeWard();
  const std::string before = featuresBlob(3);
  file.write(without({20, 25, 27}));
  EXPECT_THAT(file.check(), IsEmpty());
  const auto views = file.readViews();
  ASSERT_THAT(views, SizeIs(3));
  ASSERT_THAT(views[1].features.keypoints, SizeIs(7));
  EXPECT_EQ(views[1].features.descriptors.rows, 7);
  ASSERT_THAT(views[1].sightings, SizeIs(7));
  for (const auto& [point, keypoint] : views[1].sightings) {
    const auto was = static_cast<float>(point - 20);  // its number, where it was seen and how it looks
    EXPECT_EQ(views[1].features.keypoints.at(keypoint).raw_px.x, 100.0F + was);
    EXPECT_EQ(views[1].features.descriptors.at<std::uint8_t>(static_cast<int>(keypoint), 0), point);
  }
  EXPECT_EQ(featuresBlob(3), before) << "a keyframe that loses nothing stays as it is";
}

TEST_F(LastingFeaturesTest, AKeyframeWhosePointsAreAllGoneKeepsNoFeatures) {
  auto file = writeWard();
  file.write(without({20, 21, 22, 23, 24, 25, 26, 27, 28, 29}));
  EXPECT_THAT(file.check(), IsEmpty());
  EXPECT_THAT(file.readViews()[1].features.keypoints, IsEmpty());
  EXPECT_THAT(file.readViews()[1].sightings, IsEmpty());
}

TEST_F(LastingFeaturesTest, OfAnErasedDescriptorNothingIsLeftInTheFile) {
  std::mt19937 random(7);
  std::string erased(32, ' ');
  for (char& byte : erased) byte = static_cast<char>(random());
  {
    MapFile file = MapFile::create(path_, {ward_.labels, ""});
    MapChanges changes = everythingOf(ward_);
    const auto view = test::makeView(2, ward_);
    for (int byte = 0; byte < 32; ++byte) {  // all in one blob that cannot be compressed
      for (int row = 0; row < 10; ++row) {
        view->features.descriptors.at<std::uint8_t>(row, byte) = static_cast<std::uint8_t>(random());
      }
      view->features.descriptors.at<std::uint8_t>(5, byte) =
          static_cast<std::uint8_t>(erased[static_cast<std::size_t>(byte)]);
    }
    changes.views = {view};
    file.write(changes);
  }
  ASSERT_NE(fileBytes().find(erased), std::string::npos) << "the test looks for what can be found";
  const std::string blob = featuresBlob(2);
  {
    MapFile file = MapFile::open(path_, MapAccess::Write);
    MapChanges changes;
    changes.graph.emplace().sightings[2] = {{21, 1}};
    changes.graph->p_map_m[21] = {1, 2, 3};
    file.write(changes);
  }
  EXPECT_EQ(fileBytes().find(erased), std::string::npos);
  EXPECT_EQ(fileBytes().find(blob.substr(blob.size() / 2, 40)), std::string::npos);
}

TEST_F(LastingFeaturesTest, ASightingOfNoKeyPointIsRefused) {
  auto file = writeWard();
  MapChanges changes;
  changes.graph.emplace().sightings[2] = {{21, 99}};
  EXPECT_THROW(file.write(changes), core::InputError);
}

}  // namespace
}  // namespace wardslam::storage
