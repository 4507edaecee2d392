#include "run_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "run_report.h"
#include "wardslam/viewer/plan_picture.h"
#include "wardslam/viewer/plan_raster.h"

namespace wardslam::nav_demo {
namespace {

const cv::Scalar kRobot(0, 90, 235);
const cv::Scalar kPlanned(90, 90, 90);
const cv::Scalar kForbidden(30, 30, 200);
const cv::Scalar kInk(40, 40, 40);
const std::array<cv::Scalar, 4> kPeople{{{150, 60, 130}, {120, 130, 20}, {60, 110, 40}, {170, 90, 40}}};
constexpr double kBetweenMarks_s = 3.0;
constexpr int kBanner_px = 34;

class RunPainter {
 public:
  RunPainter(cv::Mat picture, const mapping::SemanticMap& map, const SimulationOptions& options)
      : picture_(std::move(picture)), raster_(map), options_(options) {}

  void hatch(const mapping::Zone& zone);
  void plannedWay(const Mission& mission);
  void people(const RunRecord& run);
  void robot(const RunRecord& run);
  void spot(const RunRecord& run);

  [[nodiscard]] const cv::Mat& picture() const { return picture_; }

 private:
  void way(const std::vector<cv::Point>& points, const cv::Scalar& color, int width_px) {
    cv::polylines(picture_, std::vector{points}, false, color, width_px, cv::LINE_AA);
  }
  void mark(const Eigen::Vector2d& p_m, double radius_m, const cv::Scalar& color, double t_s);

  cv::Mat picture_;
  viewer::PlanRaster raster_;
  const SimulationOptions& options_;
};

bool isMarked(double t_s) {
  return std::remainder(t_s, kBetweenMarks_s) > -1e-6 && std::remainder(t_s, kBetweenMarks_s) < 0.05;
}

/// A circle with the time in it.
void RunPainter::mark(const Eigen::Vector2d& p_m, double radius_m, const cv::Scalar& color, double t_s) {
  const cv::Point centre = raster_.at(p_m);
  cv::circle(picture_, centre, raster_.toPixels(radius_m), color, 2, cv::LINE_AA);
  const std::string text = std::to_string(std::lround(t_s));
  int baseline = 0;
  const cv::Size ink = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, 0.5, 1, &baseline);
  cv::putText(picture_, text, centre + cv::Point(-ink.width / 2, ink.height / 2), cv::FONT_HERSHEY_SIMPLEX, 0.5, color,
              1, cv::LINE_AA);
}

void RunPainter::hatch(const mapping::Zone& zone) {
  std::vector<cv::Point> corners;
  for (const auto& corner : zone.polygon_m) corners.push_back(raster_.at(corner));
  cv::Mat inside(picture_.size(), CV_8UC1, cv::Scalar(0));
  cv::fillPoly(inside, std::vector{corners}, cv::Scalar(255));
  cv::Mat lines(picture_.size(), CV_8UC1, cv::Scalar(0));
  for (int x = -picture_.rows; x < picture_.cols; x += 14)
    cv::line(lines, {x, picture_.rows}, {x + picture_.rows, 0}, cv::Scalar(255), 1, cv::LINE_AA);
  picture_.setTo(kForbidden, inside & (lines > 128));
  cv::polylines(picture_, std::vector{corners}, true, kForbidden, 3, cv::LINE_AA);
}

void RunPainter::plannedWay(const Mission& mission) {
  cv::Point last = raster_.at(mission.T_map_start.translation());
  for (const auto& p : mission.route_m) {
    cv::line(picture_, last, raster_.at(p), kPlanned, 1, cv::LINE_AA);
    last = raster_.at(p);
    cv::circle(picture_, last, 3, kPlanned, cv::FILLED, cv::LINE_AA);
  }
}

void RunPainter::people(const RunRecord& run) {
  if (run.moments.empty()) return;
  for (std::size_t who = 0; who < run.moments.front().people_m.size(); ++who) {
    const cv::Scalar& color = kPeople.at(who % kPeople.size());
    std::vector<cv::Point> points;
    for (const auto& moment : run.moments) points.push_back(raster_.at(moment.people_m[who]));
    way(points, color, 1);
    for (const auto& moment : run.moments)
      if (isMarked(moment.t_s)) mark(moment.people_m[who], options_.people.radius_m, color, moment.t_s);
  }
}

void RunPainter::robot(const RunRecord& run) {
  std::vector<cv::Point> points;
  for (const auto& moment : run.moments) points.push_back(raster_.at(moment.T_map_robot.translation()));
  way(points, kRobot, 3);
  for (const auto& moment : run.moments)
    if (isMarked(moment.t_s)) mark(moment.T_map_robot.translation(), options_.robot.radius_m, kRobot, moment.t_s);
  if (run.moments.empty()) return;
  const Eigen::Isometry2d& end = run.moments.back().T_map_robot;
  const Eigen::Vector2d nose = end * Eigen::Vector2d(options_.robot.radius_m, 0.0);
  cv::circle(picture_, raster_.at(end.translation()), raster_.toPixels(options_.robot.radius_m), kRobot, 4,
             cv::LINE_AA);
  cv::arrowedLine(picture_, raster_.at(end.translation()), raster_.at(nose), kRobot, 3, cv::LINE_AA, 0, 0.4);
}

void RunPainter::spot(const RunRecord& run) {
  const cv::Point p = raster_.at(run.spot.p_map_m);
  cv::drawMarker(picture_, p, kInk, cv::MARKER_TILTED_CROSS, 16, 2, cv::LINE_AA);
}

/// The picture with lines of text above it.
cv::Mat withBanner(const cv::Mat& picture, const std::vector<std::string>& lines) {
  const int height = kBanner_px * static_cast<int>(lines.size());
  cv::Mat whole(picture.rows + height, picture.cols, CV_8UC3, cv::Scalar::all(255));
  picture.copyTo(whole.rowRange(height, whole.rows));
  for (std::size_t i = 0; i < lines.size(); ++i)
    cv::putText(whole, lines[i], {12, kBanner_px * static_cast<int>(i) + 24}, cv::FONT_HERSHEY_SIMPLEX, 0.62, kInk, 1,
                cv::LINE_AA);
  return whole;
}

}  // namespace

cv::Mat drawRun(const mapping::SemanticMap& map, const Mission& mission, const SimulationOptions& options,
                const RunRecord& run) {
  RunPainter painter(viewer::drawPlan(map), map, options);
  for (const auto& zone : mission.forbidden) painter.hatch(zone);
  painter.plannedWay(mission);
  painter.people(run);
  painter.robot(run);
  painter.spot(run);
  return withBanner(
      painter.picture(),
      {sentenceOf(run, mission),
       "Orange: the robot, every 3 s (numbers: seconds); circles on thin lines: people; grey dots: the way planned; "
       "cross: where it is to stop;",
       "blue: the camera when it made the map; hatched: the robot may not enter."});
}

}  // namespace wardslam::nav_demo
