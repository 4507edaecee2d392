#pragma once

#include <mrpt/nav/reactive/CRobot2NavInterface.h>

#include <Eigen/Geometry>
#include <vector>

#include "simulated_robot.h"
#include "wardslam/navigation/obstacles.h"

namespace wardslam::nav_demo {

/// The robot as MRPT's navigators see it: everything in the map frame, as far as the robot knows it.
class RobotInterface : public mrpt::nav::CRobot2NavInterface {
 public:
  RobotInterface(SimulatedRobot& robot, navigation::Obstacles& obstacles, const Eigen::Isometry2d& T_map_world)
      : robot_(robot), obstacles_(obstacles), T_map_world_(T_map_world) {
    setMinLoggingLevel(mrpt::system::LVL_ERROR);
  }

  /// Once per step of the navigator: where the robot believes to be, and what it sees (robot frame).
  void update(double now_s, const std::vector<Eigen::Vector2d>& scan_m);

  [[nodiscard]] const Eigen::Isometry2d& T_map_robot() const { return T_map_robot_; }
  [[nodiscard]] const std::vector<Eigen::Vector2d>& scan_map_m() const { return scan_map_m_; }
  [[nodiscard]] bool isStuck() const { return isStuck_; }
  void forgetTrouble() { isStuck_ = false; }
  void turn(double turn_radps) { robot_.drive(0.0, turn_radps); }
  void halt() { robot_.drive(0.0, 0.0); }

  bool getCurrentPoseAndSpeeds(mrpt::math::TPose2D& pose, mrpt::math::TTwist2D& velocity,
                               mrpt::system::TTimeStamp& stamp, mrpt::math::TPose2D& odometry,
                               std::string& frame) override;
  bool changeSpeeds(const mrpt::kinematics::CVehicleVelCmd& command) override;
  bool stop(bool isEmergency) override;
  mrpt::kinematics::CVehicleVelCmd::Ptr getEmergencyStopCmd() override { return getStopCmd(); }
  mrpt::kinematics::CVehicleVelCmd::Ptr getStopCmd() override;
  bool senseObstacles(mrpt::maps::CSimplePointsMap& points, mrpt::system::TTimeStamp& stamp) override;
  double getNavigationTime() override { return now_s_; }
  void resetNavigationTimer() override {}
  void sendNavigationStartEvent() override {}
  void sendNavigationEndEvent() override {}
  void sendWaypointReachedEvent(int /*index*/, bool /*reached*/) override {}
  void sendNewWaypointTargetEvent(int /*index*/) override {}
  void sendNavigationEndDueToErrorEvent() override { isStuck_ = true; }
  void sendWaySeemsBlockedEvent() override { isStuck_ = true; }
  void sendApparentCollisionEvent() override {}
  void sendCannotGetCloserToBlockedTargetEvent() override { isStuck_ = true; }

 private:
  SimulatedRobot& robot_;
  navigation::Obstacles& obstacles_;
  Eigen::Isometry2d T_map_world_;
  Eigen::Isometry2d T_map_robot_ = Eigen::Isometry2d::Identity();
  std::vector<Eigen::Vector2d> scan_map_m_;
  double now_s_ = 0.0;
  bool isStuck_ = false;
};

}  // namespace wardslam::nav_demo
