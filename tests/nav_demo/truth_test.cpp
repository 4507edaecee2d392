#include "truth.h"

#include <gmock/gmock.h>

#include "support/complaint.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/exchange/map_export.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam::nav_demo {
namespace {

/// The hand-made ward as rawlog-synth would leave it, with a camera that drove straight ahead, in a world in which the
/// map lies turned by a quarter and 5 m aside.
class TruthTest : public testing::Test {
 protected:
  TruthTest() {
    std::filesystem::create_directories(labels_);
    exchange::exportRosMap(test::makeWard(), labels_ / "floor.yaml");
    folder_.write("ward_labels/objects.csv", "class_name,xmin,ymin,xmax,ymax\nbed,1,2,3,4\n");
    T_world_map_.linear() = Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    T_world_map_.translation() = Eigen::Vector3d(5, 0, 0);
    map_.keyframes.clear();
    exchange::TumTrajectoryWriter groundTruth(folder_.path() / "ward.groundtruth.txt");
    for (int i = 0; i < 6; ++i) {
      Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
      T_map_cam.linear() = Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5).toRotationMatrix();
      T_map_cam.translation() = Eigen::Vector3d(0.3 * i, 0.3 * i, 1.0);
      groundTruth.write({100.0 + i, T_world_map_ * T_map_cam});
      T_map_cam.translation().z() += i % 2 == 0 ? 0.01 : -0.01;  // what tells of the way's plane is nothing but noise
      map_.keyframes[static_cast<std::uint64_t>(i) + 1] = {100.0 + i, T_map_cam, "", 0, {}, {}};
    }
    groundTruth.finish();
  }

  test::TemporaryFolder folder_;
  std::filesystem::path labels_ = folder_.path() / "ward_labels";
  Eigen::Isometry3d T_world_map_ = Eigen::Isometry3d::Identity();
  mapping::SemanticMap map_ = test::makeWard();
};

TEST_F(TruthTest, LaysTheMapRightAlsoAlongAStraightWay) {
  const Truth truth = readTruth(folder_.path() / "ward.rawlog", map_);
  const Eigen::Vector2d bed_m(5.5, 3.0);
  const Eigen::Vector2d expected_m = (T_world_map_ * Eigen::Vector3d(bed_m.x(), bed_m.y(), 0.0)).head<2>();
  EXPECT_LT((truth.T_world_map * bed_m - expected_m).norm(), 1e-6);
  EXPECT_NEAR(truth.mapError_m, 0.01, 1e-3);
  ASSERT_EQ(truth.things.size(), 1U);
  EXPECT_EQ(truth.floor.cells.size(), cv::Size(160, 120));
}

TEST_F(TruthTest, SaysWhatIsMissing) {
  for (auto& [id, keyframe] : map_.keyframes) keyframe.stamp_s += 1000.0;
  EXPECT_THAT(test::complaintOf([&] { static_cast<void>(readTruth(folder_.path() / "ward.rawlog", map_)); }),
              testing::HasSubstr("no pose at the time of any keyframe"));
  std::filesystem::remove(labels_ / "floor.yaml");
  EXPECT_THAT(test::complaintOf([&] { static_cast<void>(readTruth(folder_.path() / "ward.rawlog", map_)); }),
              testing::HasSubstr("floor.yaml: is missing"));
}

}  // namespace
}  // namespace wardslam::nav_demo
