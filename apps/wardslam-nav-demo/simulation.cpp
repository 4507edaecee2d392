#include "simulation.h"

#include <mrpt/core/Clock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "delivery.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::nav_demo {
namespace {

constexpr double kStep_s = 0.02;
constexpr double kFirst_s = 1.7e9;  ///< UNIX time; any will do.

/// MRPT's navigators look at the clock here and there.
class SimulatedClock {
 public:
  SimulatedClock() {
    show(0.0);
    mrpt::Clock::setActiveClock(mrpt::Clock::Simulated);
  }
  ~SimulatedClock() { mrpt::Clock::setActiveClock(before_); }
  SimulatedClock(const SimulatedClock&) = delete;
  SimulatedClock& operator=(const SimulatedClock&) = delete;
  void show(double t_s) { mrpt::Clock::setSimulatedTime(core::toMrptTime(kFirst_s + t_s)); }

 private:
  mrpt::Clock::Source before_ = mrpt::Clock::getActiveClock();
};

/// The people, and the robot among them as they see it.
class People {
 public:
  People(const TrueWorld& world, const Mission& mission, const Truth& truth, const SimulationOptions& options,
         std::uint32_t seed)
      : floor_(world.floor(), {options.people.radius_m, {}, false}) {
    constexpr double kClear_m = 1.5;
    ground_.floor = &floor_;
    for (const auto& p : mission.route_m) ground_.attractions_m.emplace_back(truth.T_world_map * p);
    std::mt19937 random(seed);
    const Eigen::Vector2d start_m = truth.T_world_map * mission.T_map_start.translation();
    for (int i = 0; i < options.peopleCount; ++i) {
      const Eigen::Vector2d place_m = placeAwayFrom(ground_, start_m, kClear_m, random);
      walkers_.push_back(std::make_unique<Walker>(ground_, options.people, place_m, random()));
    }
  }

  void step(double dt_s, const Disc& robot) {
    for (auto& walker : walkers_) {
      std::vector<Disc> others = {robot};
      for (const auto& other : walkers_) {
        if (other != walker) others.push_back(other->disc());
      }
      walker->step(dt_s, others);
    }
  }

  [[nodiscard]] std::vector<Disc> discs() const {
    std::vector<Disc> discs;
    for (const auto& walker : walkers_) discs.push_back(walker->disc());
    return discs;
  }

 private:
  query::DrivableFloor floor_;
  WalkingGround ground_;
  std::vector<std::unique_ptr<Walker>> walkers_;
};

Moment momentOf(double t_s, const Eigen::Isometry2d& T_map_world, const SimulatedRobot& robot,
                const std::vector<Disc>& people, const std::string& phase) {
  Moment moment{t_s, T_map_world * robot.T_world_robot(), {}, phase};
  for (const auto& disc : people) moment.people_m.emplace_back(T_map_world * disc.p_m);
  return moment;
}

/// To the thing of the target's class that truly stands where the map has it.
double distanceToTarget_m(const Mission& mission, const std::string& className, const Truth& truth,
                          const Eigen::Vector2d& robot_m, double radius_m) {
  const Eigen::Vector2d mapped_m = truth.T_world_map * Eigen::Vector2d(mission.object->centroid_m.head<2>());
  double nearest_m = std::numeric_limits<double>::infinity();
  double distance_m = std::numeric_limits<double>::quiet_NaN();
  for (const auto& thing : truth.things) {
    const double off_m = (thing.box_m.center() - mapped_m).norm();
    if (thing.className != className || off_m >= nearest_m) continue;
    nearest_m = off_m;
    distance_m = thing.box_m.exteriorDistance(robot_m) - radius_m;
  }
  return distance_m;
}

}  // namespace

RunRecord simulate(const Mission& mission, const Truth& truth, const SimulationOptions& options, std::uint32_t seed,
                   const std::filesystem::path& cache, const std::function<bool(const Moment&)>& onMoment) {
  SimulatedClock clock;
  const TrueWorld world(truth.floor);
  const Eigen::Isometry2d T_map_world = truth.T_world_map.inverse();
  SimulatedRobot robot(options.robot, truth.T_world_map * mission.T_map_start, seed);
  People people(world, mission, truth, options, seed);
  navigation::Obstacles obstacles(mission.closedPlan);
  RobotInterface interface(robot, obstacles, T_map_world);
  ReactiveNavigator navigator(interface, options.robot, cache);
  Delivery delivery(mission, interface, navigator);
  Judge judge(world, mission.forbidden, truth.T_world_map, options.robot.radius_m);

  RunRecord record;
  record.seed = seed;
  const int stepsPerDecision = static_cast<int>(std::lround(options.robot.scanPeriod_s / kStep_s));
  const auto steps = static_cast<int>(std::lround(options.timeLimit_s / kStep_s));
  for (int i = 0; i <= steps && !delivery.isOver(); ++i) {
    const double t_s = i * kStep_s;
    clock.show(t_s);
    if (i % stepsPerDecision == 0) {
      interface.update(kFirst_s + t_s, scan(world, people.discs(), robot.T_world_robot(), options.scanner));
      delivery.step(t_s);
      record.moments.push_back(momentOf(t_s, T_map_world, robot, people.discs(), delivery.phase()));
      if (onMoment && !onMoment(record.moments.back())) break;
    }
    robot.step(kStep_s);
    people.step(kStep_s, {robot.T_world_robot().translation(), options.robot.radius_m});
    judge.look(robot.T_world_robot().translation(), people.discs());
    record.time_s = t_s;
  }

  record.arrived = delivery.isOver();
  record.waited_s = delivery.waited_s();
  record.replans = delivery.replans();
  record.verdict = judge.verdict();
  const Eigen::Isometry2d T_map_robot = T_map_world * robot.T_world_robot();
  record.spot = delivery.spot();
  record.goalError_m = (T_map_robot.translation() - delivery.spot().p_map_m).norm();
  record.facingError_rad =
      std::abs(std::remainder(Eigen::Rotation2Dd(T_map_robot.linear()).angle() - delivery.spot().yaw_rad, 2.0 * M_PI));
  record.toTarget_m = distanceToTarget_m(mission, mission.className, truth, robot.T_world_robot().translation(),
                                         options.robot.radius_m);
  return record;
}

}  // namespace wardslam::nav_demo
