#include "plan_view.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "html.h"
#include "wardslam/core/markup.h"
#include "wardslam/viewer/label_layout.h"
#include "wardslam/viewer/plan_picture.h"

namespace wardslam::report {
namespace {

using core::escapedForMarkup;

constexpr double kPlanWidth_px = 1200.0;  ///< As large as the drawing gets on a screen,
constexpr double kPlanHeight_px = 800.0;
constexpr double kLetter_px = 12.0;  ///< and as large as names are then.
constexpr std::size_t kMostNames = 60;
constexpr std::array<const char*, 4> kZoneColors = {"#28a03c", "#e6961e", "#d23228", "#a05abe"};

/// The map, or where there is none one of the way alone, which then says how much is drawn.
mapping::SemanticMap mapOf(const RunRecord& run) {
  if (run.map) return *run.map;
  mapping::SemanticMap map;
  for (const core::StampedPose& pose : run.trajectory) {
    map.keyframes[map.keyframes.size()] = {pose.stamp_s, pose.T_map_cam, {}, 0, {}, {}};
  }
  return map;
}

std::string hex(const std::array<std::uint8_t, 3>& color_rgb) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", color_rgb[0], color_rgb[1], color_rgb[2]);
  return text;
}

std::string pair(const cv::Point& p) { return std::to_string(p.x) + "," + std::to_string(p.y) + " "; }

std::string dot(const char* kind, const cv::Point& p, const std::string& title) {
  return std::string("<circle class=\"") + kind + "\" cx=\"" + std::to_string(p.x) + "\" cy=\"" + std::to_string(p.y) +
         "\" r=\"7\"><title>" + title + "</title></circle>\n";
}

/// Poses farther apart in time are not joined by a line: nobody knows how the camera went.
double gapOf(const core::Trajectory& way) {
  constexpr double kUsualSteps = 5.0;
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < way.size(); ++i) steps_s.push_back(way[i].stamp_s - way[i - 1].stamp_s);
  if (steps_s.empty()) return 0.0;
  const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
  std::nth_element(steps_s.begin(), middle, steps_s.end());
  return kUsualSteps * *middle;
}

}  // namespace

PlanView::PlanView(const RunRecord& run, const core::Trajectory& truthInMap)
    : run_(run), truthInMap_(truthInMap), map_(mapOf(run)), raster_(map_) {}

cv::Rect PlanView::box() const {
  constexpr int kMargin_px = 12;
  cv::Rect box({0, 0}, raster_.size());
  for (const auto* way : {&run_.trajectory, &truthInMap_}) {
    for (const auto& pose : *way) {
      const cv::Point p = at(pose.T_map_cam.translation());
      box |= cv::Rect(p.x - kMargin_px, p.y - kMargin_px, 2 * kMargin_px, 2 * kMargin_px);
    }
  }
  return box;
}

std::string PlanView::svg() const {
  if (map_.keyframes.empty() && map_.objects.empty()) return {};
  const cv::Rect area = box();
  return "<svg id=\"plan\" role=\"img\" aria-label=\"the map from above\" viewBox=\"" + std::to_string(area.x) + " " +
         std::to_string(area.y) + " " + std::to_string(area.width) + " " + std::to_string(area.height) + "\">\n" +
         ground() + areas() + doors() + things() + ways() + names() + scaleBar() +
         "<circle id=\"here\" r=\"10\" visibility=\"hidden\"/>\n</svg>\n";
}

std::string PlanView::ground() const {
  if (!run_.map) return {};
  return "<image class=\"ground\" width=\"" + std::to_string(raster_.size().width) + "\" height=\"" +
         std::to_string(raster_.size().height) + "\" href=\"" + dataAddress(viewer::drawGround(map_), ".png") +
         "\"/>\n";
}

std::string PlanView::outline(const std::vector<Eigen::Vector2d>& corners_m) const {
  std::string list;
  for (const auto& corner_m : corners_m) list += pair(raster_.at(corner_m));
  return list;
}

/// Around the room, and around what lies within it and is none of it, as a court does in a corridor.
std::string PlanView::outline(const building::Room& room) const {
  constexpr double kLeastHole_m2 = 1.0;
  const auto& rooms = run_.rooms;
  std::vector<std::vector<cv::Point>> contours;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(rooms.ids == room.id, contours, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_SIMPLE);
  std::string path;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const bool isHole = hierarchy[i][3] >= 0;
    if (isHole && cv::contourArea(contours[i]) * rooms.resolution_m * rooms.resolution_m < kLeastHole_m2) continue;
    const char* command = "M";
    for (const auto& cell : contours[i]) {
      const Eigen::Vector2d middle = Eigen::Vector2d(cell.x, cell.y) + Eigen::Vector2d::Constant(0.5);
      path += command + pair(raster_.at(rooms.origin_m + rooms.resolution_m * middle));
      command = "L";
    }
    path += "Z ";
  }
  return path;
}

/// Rooms and zones, the larger ones first: what lies within another can be pointed at.
std::string PlanView::areas() const {
  std::vector<std::pair<double, std::string>> areas;
  const auto add = [&](const std::string& shape, const std::string& name, double size_m2) {
    const std::string kind = shape.substr(1, shape.find(' ') - 1);
    areas.emplace_back(size_m2, shape + "><title>" + escapedForMarkup(name) + "\n" + fixed(size_m2, 1) +
                                    " m²</title></" + kind + ">\n");
  };
  for (const auto& room : run_.rooms.all) {
    const std::string color = "hsl(" + std::to_string(room.id * 137 % 360) + ",60%,50%)";  // neighbours differ
    add(R"(<path class="room" tabindex="0" fill=")" + color + "\" d=\"" + outline(room) + "\"", room.name,
        room.area_m2);
  }
  for (std::size_t i = 0; i < map_.zones.size(); ++i) {
    const auto& zone = map_.zones[i];
    const std::string color = kZoneColors.at(i % kZoneColors.size());
    add(R"(<polygon class="zone" tabindex="0" fill=")" + color + "\" stroke=\"" + color + "\" points=\"" +
            outline(zone.polygon_m) + "\"",
        "zone " + zone.name, area_m2(zone));
  }
  std::stable_sort(areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string html;
  for (const auto& [size_m2, area] : areas) html += area;
  return html;
}

std::string PlanView::doors() const {
  const auto nameOf = [this](int id) { return run_.rooms.all.at(static_cast<std::size_t>(id - 1)).name; };
  std::string html;
  for (const auto& door : run_.rooms.doors) {
    html += "<path class=\"door\" tabindex=\"0\" d=\"M" + pair(raster_.at(door.from_m)) + "L" +
            pair(raster_.at(door.to_m)) + "\"><title>door between " +
            escapedForMarkup(nameOf(door.room) + " and " + nameOf(door.other)) + "\n" + fixed(door.width_m, 1) +
            " m wide</title></path>\n";
  }
  return html;
}

std::string PlanView::titleOf(const mapping::MapObject& object) const {
  const auto time = [&](double stamp_s) { return timeText(stamp_s, run_.start_s(), run_.end_s()); };
  std::string title = viewer::tagOf(object, map_.labels) + "\nclass " + std::to_string(object.classId) + " " +
                      map_.labels.name(object.classId) + ", " + fixed(100.0 * object.probability, 0) +
                      " % sure\nseen in " + std::to_string(object.views) + " images, from " + time(object.firstSeen_s) +
                      " to " + time(object.lastSeen_s);
  if (!object.zone.empty()) title += "\nin " + object.zone;
  return escapedForMarkup(title);
}

std::string PlanView::things() const {
  std::string html;
  for (const auto& [id, object] : map_.objects) {
    const std::string color = hex(object.color_rgb);
    html += std::string("<polygon class=\"thing") + (object.state == mapping::ObjectState::Gone ? " gone" : "") +
            R"(" tabindex="0" fill=")" + color + "\" stroke=\"" + color + "\" points=\"" +
            outline(viewer::footprint(object.orientedBox)) + "\"><title>" + titleOf(object) + "</title></polygon>\n";
  }
  return html;
}

double PlanView::letterHeight() const {
  const cv::Rect area = box();
  return kLetter_px * std::max(area.width / kPlanWidth_px, area.height / kPlanHeight_px);
}

std::string PlanView::names() const {
  const double height = letterHeight();
  std::vector<std::string> names;
  std::vector<cv::Rect> wanted;
  const auto add = [&](const std::string& name, const cv::Point& middle) {
    const cv::Size size(cvCeil(0.6 * height * static_cast<double>(name.size())), cvCeil(1.25 * height));
    if (!cv::Rect({0, 0}, raster_.size()).contains(middle)) return;
    names.push_back(name);
    wanted.emplace_back(middle - cv::Point(size / 2), size);
  };
  for (const auto& zone : map_.zones) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const auto& corner_m : zone.polygon_m) sum += corner_m;
    add(zone.name, raster_.at(sum / static_cast<double>(zone.polygon_m.size())));
  }
  for (const auto& room : run_.rooms.all) {
    const bool isZone =
        std::any_of(map_.zones.begin(), map_.zones.end(), [&room](const auto& zone) { return zone.name == room.name; });
    if (!isZone) add(room.name, raster_.at(room.middle_m));
  }
  if (map_.objects.size() <= kMostNames) {  // of more, each is named when it is pointed at
    for (const auto& [id, object] : map_.objects) {
      add(viewer::tagOf(object, map_.labels), raster_.at(object.orientedBox.T_map_box.translation().head<2>()));
    }
  }
  const auto places = viewer::movedApart(wanted, raster_.size());
  std::string html = "<g class=\"names\" font-size=\"" + fixed(height, 1) + "\">\n";
  for (std::size_t i = 0; i < names.size(); ++i) {
    const cv::Rect& place = places[i];
    html += "<text x=\"" + std::to_string(place.x + place.width / 2) + "\" y=\"" + fixed(place.y + height, 1) + "\">" +
            escapedForMarkup(names[i]) + "</text>\n";
  }
  return html + "</g>\n";
}

std::string PlanView::lines(const char* kind, const core::Trajectory& way) const {
  constexpr std::size_t kMost = 5000;
  const std::size_t stride = way.size() / kMost + 1;
  const double gap_s = gapOf(way);
  std::string path;
  bool isBroken = true;
  for (std::size_t i = 0; i < way.size(); ++i) {
    isBroken = isBroken || (i > 0 && way[i].stamp_s - way[i - 1].stamp_s > gap_s);
    if (!isBroken && i % stride != 0 && i + 1 < way.size()) continue;
    path += (isBroken ? "M" : "L") + pair(at(way[i].T_map_cam.translation()));
    isBroken = false;
  }
  return std::string("<path class=\"") + kind + "\" d=\"" + path + "\"/>\n";
}

std::string PlanView::ways() const {
  if (run_.trajectory.empty()) return {};
  std::string html = lines("way", run_.trajectory);
  if (!truthInMap_.empty()) html += lines("truth", truthInMap_);
  html += dot("start", at(run_.trajectory.front().T_map_cam.translation()), "the first pose");
  return html + dot("end", at(run_.trajectory.back().T_map_cam.translation()), "the last pose");
}

std::string PlanView::scaleBar() const {
  const cv::Rect area = box();
  const int x = area.x + 16;
  const int y = area.y + area.height - 16;
  return "<path class=\"scale\" d=\"M" + std::to_string(x) + "," + std::to_string(y) + " h" +
         std::to_string(raster_.toPixels(1.0)) + "\"/><text class=\"scale\" x=\"" + std::to_string(x) + "\" y=\"" +
         std::to_string(y - 8) + "\">1 m</text>\n";
}

}  // namespace wardslam::report
