#include "wardslam/pipeline/earlier_map.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::pipeline {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class EarlierMapTest : public ::testing::Test {
 protected:
  const test::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "ward.wardmap";
};

TEST_F(EarlierMapTest, HasKeyframesWhereTheMapHasThemAndTheirPoints) {
  auto keyframe = std::make_shared<odometry::Keyframe>();
  keyframe->id = 7;
  keyframe->submap = 2;
  keyframe->features.keypoints.resize(1);
  keyframe->features.keypoints[0].depth_m = 2.0F;
  keyframe->features.descriptors = cv::Mat::zeros(1, 32, CV_8UC1);
  keyframe->sightings = {{31, 0}};
  storage::MapChanges changes;
  changes.keyframes[7].T_map_cam.translation() = Eigen::Vector3d(1, 2, 3);
  changes.keyframes[7].piece = 4;
  changes.keyframes[7].ground = core::GroundPlane{-Eigen::Vector3d::UnitY(), 1.1, Eigen::Matrix3d::Identity()};
  changes.views = {keyframe};
  changes.p_map_m[31] = Eigen::Vector3d(4, 5, 6);
  storage::MapFile::create(file_).write(changes);

  const EarlierMap earlier = readEarlierMap(file_);
  ASSERT_EQ(earlier.graph.keyframes.size(), 1U);
  EXPECT_EQ(earlier.graph.keyframes[0]->id, 7U);
  EXPECT_EQ(earlier.graph.keyframes[0]->submap, 4U);
  EXPECT_EQ(earlier.graph.map, 4U);
  EXPECT_EQ(earlier.graph.freeSubmap, 5U);
  EXPECT_TRUE(earlier.graph.keyframes[0]->T_map_cam.translation().isApprox(Eigen::Vector3d(1, 2, 3)));
  ASSERT_TRUE(earlier.graph.keyframes[0]->ground);
  EXPECT_EQ(earlier.graph.keyframes[0]->ground->height_m, 1.1);
  EXPECT_EQ(earlier.graph.p_map_m.at(31), Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(earlier.semantic.keyframes.count(7), 1U);
}

TEST_F(EarlierMapTest, HasLoopsAndWhatIsRemembered) {
  storage::MapChanges changes;
  for (const odometry::KeyframeId id : {1, 2}) {
    auto keyframe = std::make_shared<odometry::Keyframe>();
    keyframe->id = id;
    keyframe->features.descriptors = cv::Mat(0, 32, CV_8UC1);
    changes.keyframes[id];
    changes.views.push_back(keyframe);
  }
  changes.loops = {{1, 2, Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3)), 44}};
  changes.memory.emplace().objects[7].views = 3;
  storage::MapFile::create(file_).write(changes);
  const EarlierMap earlier = readEarlierMap(file_);
  ASSERT_EQ(earlier.graph.loops.size(), 1U);
  EXPECT_EQ(earlier.graph.loops[0].older, 1U);
  EXPECT_EQ(earlier.graph.loops[0].newer, 2U);
  EXPECT_EQ(earlier.graph.loops[0].inliers, 44);
  EXPECT_EQ(earlier.graph.loops[0].T_older_newer.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(earlier.memory.objects.at(7).views, 3);
}

TEST_F(EarlierMapTest, WithoutKeyframesIsOfNoUse) {
  static_cast<void>(storage::MapFile::create(file_));
  EXPECT_THAT([&] { static_cast<void>(readEarlierMap(file_)); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("ward.wardmap"), HasSubstr("no keyframes"))));
}

}  // namespace
}  // namespace wardslam::pipeline
