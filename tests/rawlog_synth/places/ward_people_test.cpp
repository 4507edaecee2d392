#include "places/ward_people.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "camera/camera_path.h"
#include "furniture/furniture.h"
#include "people/actors.h"
#include "people/anatomy.h"
#include "places/ward_scene.h"

namespace wardslam::synth {
namespace {

TrolleyActor trolley() { return {Label{1, "trolley", 102, "trolley"}, porterWalk(), kTrolleyLeft_s, {}}; }

TEST(WardPeople, ThePorterHasTheTrolleyInHandWhilePushing) {
  const TrolleyActor pushed = trolley();
  for (double t = 0; t < kTrolleyLeft_s; t += 0.1) {
    const Eigen::Vector3d handle = pushed.T_world_trolley(t) * Eigen::Vector3d(kTrolleyHandleX_m, 0, 0);
    EXPECT_NEAR((handle.head<2>() - porterWalk().at(t).p_m).norm(), anatomy::kReach_m, 1e-6);
  }
  EXPECT_TRUE(pushed.isMovingAt(2.0));
}

TEST(WardPeople, TheTrolleyStaysWhereItWasLeft) {
  const TrolleyActor left = trolley();
  const Eigen::Isometry3d there = left.T_world_trolley(kTrolleyLeft_s);
  for (double t = kTrolleyLeft_s; t < 90; t += 0.5) {
    EXPECT_TRUE(left.T_world_trolley(t).isApprox(there));
    EXPECT_FALSE(left.isMovingAt(t));
  }
  EXPECT_EQ(left.atRestFrom_s(), kTrolleyLeft_s);
  EXPECT_FALSE(porterWalk().at(kTrolleyLeft_s).moving) << "else the trolley would stop dead";
  EXPECT_GT((porterWalk().at(12.0).p_m - there.translation().head<2>()).norm(), 2.0) << "the porter walks off";
}

TEST(WardPeople, NobodyRunsIntoTheCamera) {
  const CameraPath path;
  for (const Walker& walker : {porterWalk(), nurseWalk(), visitorWalk()}) {
    for (double t = 0; t < 3 * path.period_s; t += 0.05) {
      EXPECT_GT((walker.at(t).p_m - path.T_world_cam(t).translation().head<2>()).norm(), 0.55) << t;
    }
  }
}

TEST(WardPeople, EverybodyStaysInTheRoomAndWalksAtAHumanPace) {
  const RoomShape room;
  for (const Walker& walker : {porterWalk(), nurseWalk(), visitorWalk()}) {
    for (double t = 0; t < 60; t += 0.1) {
      const Gait gait = walker.at(t);
      EXPECT_GT(gait.p_m.minCoeff(), 0.4);
      EXPECT_LT(gait.p_m.x(), room.length_m - 0.4);
      EXPECT_LT(gait.p_m.y(), room.width_m - 0.4);
      EXPECT_LT(gait.speed_mps, 2.2) << t;
    }
  }
}

TEST(WardPeople, SomebodyComesClose) {
  const CameraPath path;
  double nearest_m = std::numeric_limits<double>::max();
  for (double t = 0; t < 20; t += 0.05) {
    const Eigen::Vector2d p = nurseWalk().at(t).p_m;
    const Eigen::Vector3d seen = path.T_world_cam(t).inverse() * Eigen::Vector3d(p.x(), p.y(), 1.1);
    if (std::abs(seen.x()) < 0.5 * seen.z()) nearest_m = std::min(nearest_m, seen.z());
  }
  EXPECT_LT(nearest_m, 1.3);
}

}  // namespace
}  // namespace wardslam::synth
