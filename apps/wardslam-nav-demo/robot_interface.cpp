#include "robot_interface.h"

#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <memory>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::nav_demo {
namespace {

using mrpt::kinematics::CVehicleVelCmd_DiffDriven;

constexpr float kScanHeight_m = 0.3F;

Eigen::Isometry3d onFloor(const Eigen::Isometry2d& T) {
  const Eigen::Vector2d p = T.translation();
  return Eigen::Translation3d(p.x(), p.y(), 0.0) *
         Eigen::AngleAxisd(Eigen::Rotation2Dd(T.linear()).angle(), Eigen::Vector3d::UnitZ());
}

}  // namespace

void RobotInterface::update(double now_s, const std::vector<Eigen::Vector2d>& scan_m) {
  now_s_ = now_s;
  T_map_robot_ = T_map_world_ * robot_.fix();
  scan_map_m_.clear();
  std::vector<Eigen::Vector3f> seen_m;
  for (const auto& p_m : scan_m) {
    scan_map_m_.emplace_back(T_map_robot_ * p_m);
    const Eigen::Vector2f p = scan_map_m_.back().cast<float>();
    seen_m.emplace_back(p.x(), p.y(), kScanHeight_m);
  }
  obstacles_.see(std::move(seen_m), now_s);
  robot_.see(scan_m);
}

bool RobotInterface::getCurrentPoseAndSpeeds(mrpt::math::TPose2D& pose, mrpt::math::TTwist2D& velocity,
                                             mrpt::system::TTimeStamp& stamp, mrpt::math::TPose2D& odometry,
                                             std::string& frame) {
  const Eigen::Vector2d p = T_map_robot_.translation();
  pose = {p.x(), p.y(), Eigen::Rotation2Dd(T_map_robot_.linear()).angle()};
  velocity = {robot_.forward_mps() * std::cos(pose.phi), robot_.forward_mps() * std::sin(pose.phi),
              robot_.turn_radps()};
  stamp = core::toMrptTime(now_s_);
  odometry = pose;
  frame = "map";
  return true;
}

bool RobotInterface::changeSpeeds(const mrpt::kinematics::CVehicleVelCmd& command) {
  const auto* drive = dynamic_cast<const CVehicleVelCmd_DiffDriven*>(&command);
  if (drive == nullptr) return false;
  robot_.drive(drive->lin_vel, drive->ang_vel);
  return true;
}

bool RobotInterface::stop(bool /*isEmergency*/) {
  halt();
  return true;
}

mrpt::kinematics::CVehicleVelCmd::Ptr RobotInterface::getStopCmd() {
  auto command = std::make_shared<CVehicleVelCmd_DiffDriven>();
  command->setToStop();
  return command;
}

bool RobotInterface::senseObstacles(mrpt::maps::CSimplePointsMap& points, mrpt::system::TTimeStamp& stamp) {
  navigation::fill(obstacles_.sense(onFloor(T_map_robot_)), points, stamp);
  return true;
}

}  // namespace wardslam::nav_demo
