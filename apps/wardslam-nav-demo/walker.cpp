#include "walker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "random_numbers.h"
#include "wardslam/core/errors.h"
#include "wardslam/query/route.h"

namespace wardslam::nav_demo {
namespace {

constexpr double kLongestRest_s = 2.0;
constexpr double kShortestWay_m = 1.5;
constexpr int kTries = 200;

Eigen::Vector2d anywhere(const mapping::FloorPlan& plan, std::mt19937& random) {
  return plan.origin_m + plan.resolution_m * Eigen::Vector2d(uniform(random, 0.0, plan.cells.cols),
                                                             uniform(random, 0.0, plan.cells.rows));
}

}  // namespace

Eigen::Vector2d placeAwayFrom(const WalkingGround& ground, const Eigen::Vector2d& away_m, double clear_m,
                              std::mt19937& random) {
  for (int i = 0; i < kTries; ++i) {
    const Eigen::Vector2d p = anywhere(ground.floor->plan(), random);
    if (!ground.floor->nearestFree(p, 0.0) || (p - away_m).norm() < clear_m) continue;
    if (query::planRoute(*ground.floor, p, away_m)) return p;  // not outside of the building
  }
  throw core::InputError("there is no place for a person in the room; ask for fewer (--people)");
}

Walker::Walker(const WalkingGround& ground, const WalkerHabits& habits, const Eigen::Vector2d& start_m,
               std::uint32_t seed)
    : ground_(ground), habits_(habits), p_m_(start_m), random_(seed) {
  pace_mps_ = uniform(random_, habits.slowest_mps, habits.fastest_mps);
}

void Walker::choosePlace(const query::DrivableFloor& floor) {
  way_m_.clear();
  wasAttracted_ = !wasAttracted_ && !ground_.attractions_m.empty();
  for (int i = 0; i < kTries && way_m_.empty(); ++i) {
    const Eigen::Vector2d place = wasAttracted_
                                      ? ground_.attractions_m[static_cast<std::size_t>(uniform(
                                            random_, 0.0, static_cast<double>(ground_.attractions_m.size()) - 1e-9))]
                                      : anywhere(ground_.floor->plan(), random_);
    if ((place - p_m_).norm() < kShortestWay_m) continue;
    if (auto way = query::planRoute(floor, p_m_, place, 0.2)) way_m_ = std::move(*way);
  }
  std::reverse(way_m_.begin(), way_m_.end());
}

/// The ground without where those stand who are in the way.
query::DrivableFloor Walker::floorAround(const std::vector<Disc>& others) const {
  const auto& all = ground_.floor->plan();
  mapping::FloorPlan plan{all.cells.clone(), all.resolution_m, all.origin_m};
  for (const Disc& other : others) {
    const Eigen::Vector2d middle = (other.p_m - plan.origin_m) / plan.resolution_m;
    const double radius_m = other.radius_m + habits_.radius_m + habits_.stopsAt_m / 2;
    cv::circle(plan.cells, {static_cast<int>(middle.x()), static_cast<int>(middle.y())},
               static_cast<int>(std::lround(radius_m / plan.resolution_m)), cv::Scalar(mapping::FloorPlan::kOccupied),
               cv::FILLED);
  }
  return {plan, {0.0, {}, false}};
}

/// Whether the next steps lead towards it and too near by it.
bool Walker::isInTheWay(const Disc& other) const {
  const double now_m = (other.p_m - p_m_).norm();
  const double least_m = std::min(now_m, other.radius_m + habits_.radius_m + habits_.shoulder_m);
  Eigen::Vector2d last = p_m_;
  double along_m = 0.0;
  for (auto point = way_m_.rbegin(); point != way_m_.rend() && along_m < habits_.slowsAt_m; ++point) {
    along_m += (*point - last).norm();
    last = *point;
    if ((other.p_m - *point).norm() < least_m - 1e-3) return true;
  }
  return false;
}

double Walker::wantedSpeed_mps(const std::vector<Disc>& others) const {
  double gap_m = std::numeric_limits<double>::infinity();
  for (const Disc& other : others) {
    if (isInTheWay(other)) gap_m = std::min(gap_m, (other.p_m - p_m_).norm() - other.radius_m - habits_.radius_m);
  }
  return pace_mps_ * std::clamp((gap_m - habits_.stopsAt_m) / (habits_.slowsAt_m - habits_.stopsAt_m), 0.0, 1.0);
}

void Walker::step(double dt_s, const std::vector<Disc>& others) {
  rests_s_ -= dt_s;
  if (rests_s_ > 0.0) return;
  if (waited_s_ > habits_.patience_s) {
    choosePlace(floorAround(others));
    waited_s_ = 0.0;
  }
  if (way_m_.empty()) choosePlace(*ground_.floor);
  if (way_m_.empty()) return;
  const Eigen::Vector2d ahead = way_m_.back() - p_m_;
  const double wanted_mps = wantedSpeed_mps(others);
  const double most_mps = habits_.acceleration_mps2 * dt_s;
  speed_mps_ += std::clamp(wanted_mps - speed_mps_, -most_mps, most_mps);
  waited_s_ = speed_mps_ < 0.1 ? waited_s_ + dt_s : 0.0;
  p_m_ += std::min(speed_mps_ * dt_s, ahead.norm()) * ahead.normalized();
  if ((way_m_.back() - p_m_).norm() > 1e-3) return;
  way_m_.pop_back();
  if (!way_m_.empty()) return;
  rests_s_ = uniform(random_, 0.0, kLongestRest_s);
  speed_mps_ = 0.0;
}

}  // namespace wardslam::nav_demo
