#include "reactive_navigator.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/nav/reactive/CReactiveNavigationSystem.h>

#include <cmath>
#include <string>

#include "wardslam/core/mrpt_nav_compat.h"

namespace wardslam::nav_demo {
namespace {

constexpr double kRadToDeg = 180.0 / M_PI;
constexpr double kForesees_m = 3.0;

/// Families of paths the navigator chooses from: arcs forward, and turns towards a direction.
constexpr const char* kFixedSettings = R"(
[CAbstractNavigator]
alarm_seems_not_approaching_target_timeout = 1e6
dist_check_target_is_blocked = 0
hysteresis_check_target_is_blocked = 1000000
[CWaypointsNavigator]
max_distance_to_allow_skip_waypoint = 2.0
min_timesteps_confirm_skip_waypoints = 1
waypoint_angle_tolerance = 5.0
multitarget_look_ahead = 0
[CAbstractPTGBasedReactive]
holonomic_method = CHolonomicFullEval
motion_decider_method = CMultiObjMotionOpt_Scalarization
secure_distance_start = 0.02
secure_distance_end = 0.15
use_delays_model = false
max_distance_predicted_actual_path = 0.15
min_normalized_free_space_for_ptg_continuation = 0.2
enable_obstacle_filtering = false
evaluate_clearance = false
[CHolonomicFullEval]
TOO_CLOSE_OBSTACLE = 0.05
TARGET_SLOW_APPROACHING_DISTANCE = 0.3
OBSTACLE_SLOW_DOWN_DISTANCE = 0.15
HYSTERESIS_SECTOR_COUNT = 5
LOG_SCORE_MATRIX = false
clearance_threshold_ratio = 0.05
gap_width_ratio_threshold = 0.25
PHASE_COUNT = 1
PHASE1_FACTORS = [0 2]
PHASE1_THRESHOLD = 0.75
[CMultiObjectiveMotionOptimizerBase]
score1_name = target_distance
score1_formula = \
  var effective_trg_d_norm := max(0,target_d_norm-move_cur_d); \
  if(collision_free_distance>effective_trg_d_norm, 1/(1+effective_trg_d_norm^2), 0)
score2_name = collision_free_distance_score
score2_formula = \
  var effective_trg_d_norm := max(0,target_d_norm-move_cur_d); \
  if(collision_free_distance>(effective_trg_d_norm+0.05), 1.0, collision_free_distance)
score3_name = euclidean_nearness
score3_formula = 1/(1+dist_eucl_min^2)
score4_name = hysteresis_score
score4_formula = hysteresis
score5_name = ptg_priority_score
score5_formula = ptg_priority
scores_to_normalize =
[CMultiObjMotionOpt_Scalarization]
scalar_score_formula = ptg_priority_score*( \
  0.3*target_distance + 0.5*collision_free_distance_score + 8.0*euclidean_nearness + 0.1*hysteresis_score )
)";

std::string ptg(int index, const std::string& type, const RobotOptions& robot, const std::string& own) {
  const std::string key = "PTG" + std::to_string(index) + "_";
  return key + "Type = " + type + "\n" + key + "resolution = 0.05\n" + key +
         "refDistance = " + std::to_string(kForesees_m) + "\n" + key + "num_paths = 121\n" + key +
         "v_max_mps = " + std::to_string(robot.maxSpeed_mps) + "\n" + key +
         "w_max_dps = " + std::to_string(robot.maxTurn_radps * kRadToDeg) + "\n" + key + own;
}

std::string settings(const RobotOptions& robot) {
  return "[CReactiveNavigationSystem]\nmin_obstacles_height = 0.0\nmax_obstacles_height = 2.0\nPTG_COUNT = 2\n" +
         ptg(0, "CPTG_DiffDrive_C", robot, "K = 1.0\nPTG0_score_priority = 1.0\n") +
         ptg(1, "CPTG_DiffDrive_alpha", robot, "cte_a0v_deg = 57\nPTG1_cte_a0w_deg = 57\nPTG1_score_priority = 1.0\n") +
         kFixedSettings + "[CHolonomicFullEval]\n" + core::kFullEvalFactors +
         "[CAbstractPTGBasedReactive]\nref_distance = " + std::to_string(kForesees_m) +
         "\nrobotMax_V_mps = " + std::to_string(robot.maxSpeed_mps) +
         "\nrobotMax_W_degps = " + std::to_string(robot.maxTurn_radps * kRadToDeg) + "\n";
}

/// Around the robot's circle and a little more, since the tables know cells of 5 cm.
mrpt::math::CPolygon shapeOf(const RobotOptions& robot) {
  constexpr int kCorners = 16;
  const double radius_m = (robot.radius_m + 0.02) / std::cos(M_PI / kCorners);
  mrpt::math::CPolygon shape;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * M_PI * i / kCorners;
    shape.AddVertex(radius_m * std::cos(angle), radius_m * std::sin(angle));
  }
  return shape;
}

}  // namespace

/// Does not print what took how long when it ends.
struct ReactiveNavigator::System : mrpt::nav::CReactiveNavigationSystem {
  explicit System(RobotInterface& robot) : CReactiveNavigationSystem(robot, false, false) {
    m_timlog_delays.enable(false);
    setMinLoggingLevel(mrpt::system::LVL_ERROR);
  }
};

ReactiveNavigator::ReactiveNavigator(RobotInterface& robot, const RobotOptions& options,
                                     const std::filesystem::path& cache)
    : system_(std::make_unique<System>(robot)) {
  system_->loadConfigFile(mrpt::config::CConfigFileMemory(settings(options)));
  system_->params_abstract_ptg_navigator.ptg_cache_files_directory = cache.string();  // no configuration sets it
  system_->changeRobotShape(shapeOf(options));
  system_->initialize();
}

ReactiveNavigator::~ReactiveNavigator() = default;

void ReactiveNavigator::follow(const std::vector<Eigen::Vector2d>& route_m, double arrives_m) {
  constexpr double kPassesBy_m = 0.3;
  mrpt::nav::TWaypointSequence sequence;
  for (const auto& p : route_m) {
    const bool isLast = &p == &route_m.back();
    sequence.waypoints.emplace_back(p.x(), p.y(), isLast ? arrives_m : kPassesBy_m, !isLast, std::nullopt,
                                    isLast ? 0.0 : 1.0);
  }
  system_->navigateWaypoints(sequence);
}

void ReactiveNavigator::step() { system_->navigationStep(); }
void ReactiveNavigator::cancel() { system_->cancel(); }
bool ReactiveNavigator::isDriving() const {
  return system_->getCurrentState() == mrpt::nav::CAbstractNavigator::NAVIGATING;
}

}  // namespace wardslam::nav_demo
