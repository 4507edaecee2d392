#include "wardslam/building/room_finder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <string>

#include "floor_regions.h"
#include "floor_without_things.h"
#include "room_doors.h"

namespace wardslam::building {
namespace {

constexpr double kOutlineTolerance = 1.5;  // cells
constexpr double kNarrowestDoor_m = 0.5;   // nobody gets through less
constexpr double kDeep_m = 0.3;            // in a room, and not in its wall
constexpr double kIsThisZone = 0.5;        // of what is in the zone, in the room or in both

Eigen::Vector2d placeOf(const Rooms& rooms, const cv::Point& cell) {
  return rooms.origin_m + rooms.resolution_m * Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5);
}

/// Through the middles of the cells along its edge.
std::vector<Eigen::Vector2d> outlineOf(const Rooms& rooms, int id) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(rooms.ids == id, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  const auto largest = std::max_element(contours.begin(), contours.end(), [](const auto& a, const auto& b) {
    return cv::contourArea(a) < cv::contourArea(b);
  });
  std::vector<Eigen::Vector2d> outline_m;
  if (largest == contours.end()) return outline_m;
  std::vector<cv::Point> corners;
  cv::approxPolyDP(*largest, corners, kOutlineTolerance, true);
  for (const auto& corner : corners) outline_m.push_back(placeOf(rooms, corner));
  return outline_m;
}

/// Whether floor that was seen free leads from one room well into the other. Where boxes of things reach through a
/// wall, rooms touch, too.
bool isFreeAcross(const RegionBorder& border, const cv::Mat& ids, const cv::Mat& seen, double deep) {
  const double most = 1.5 * deep;  // not around by another door
  const int reach = static_cast<int>(std::ceil(most));
  cv::Rect around = cv::boundingRect(border.cells);
  around = cv::Rect(around.x - reach, around.y - reach, around.width + 2 * reach, around.height + 2 * reach) &
           cv::Rect({}, ids.size());
  cv::Mat isElsewhere(around.size(), CV_8UC1, cv::Scalar(255));
  for (const auto& cell : border.cells) isElsewhere.at<unsigned char>(cell - around.tl()) = 0;
  cv::Mat away;
  cv::distanceTransform(isElsewhere, away, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::Mat parts;
  const int count = cv::connectedComponents(seen(around) & (away <= most), parts, 4);
  std::vector<std::pair<bool, bool>> reaches(static_cast<std::size_t>(count));
  for (int row = 0; row < around.height; ++row) {
    for (int column = 0; column < around.width; ++column) {
      if (parts.at<int>(row, column) == 0 || static_cast<double>(away.at<float>(row, column)) < deep) continue;
      auto& [one, other] = reaches[static_cast<std::size_t>(parts.at<int>(row, column))];
      const int id = ids.at<int>(around.y + row, around.x + column);
      one = one || id == border.region;
      other = other || id == border.other;
    }
  }
  return std::any_of(reaches.begin(), reaches.end(), [](const auto& part) { return part.first && part.second; });
}

std::vector<Door> doorsOf(const Rooms& rooms, const FloorRegions& regions, const mapping::FloorPlan& plan) {
  const cv::Mat seen = seenFloor(plan);
  std::vector<Door> doors;
  for (const auto& border : bordersOf(regions)) {
    const double width_m = 2.0 * static_cast<double>(border.halfWidth) * rooms.resolution_m;
    if (width_m < kNarrowestDoor_m || !isFreeAcross(border, rooms.ids, seen, kDeep_m / plan.resolution_m)) continue;
    doors.push_back({border.region, border.other, placeOf(rooms, border.from), placeOf(rooms, border.to), width_m});
  }
  return doors;
}

/// Cells that the zone may reach into.
cv::Rect around(const mapping::Zone& zone, const Rooms& rooms) {
  Eigen::AlignedBox2d box_m;
  for (const auto& corner : zone.polygon_m) box_m.extend(corner);
  const cv::Rect2d all(0.0, 0.0, rooms.ids.cols, rooms.ids.rows);
  if (box_m.isEmpty()) return {};
  const Eigen::Vector2d from = (box_m.min() - rooms.origin_m) / rooms.resolution_m - Eigen::Vector2d::Ones();
  const Eigen::Vector2d size = box_m.sizes() / rooms.resolution_m + 3.0 * Eigen::Vector2d::Ones();
  return cv::Rect2d(std::floor(from.x()), std::floor(from.y()), std::ceil(size.x()), std::ceil(size.y())) & all;
}

/// How many cells each room has in the zone.
std::vector<double> cellsIn(const mapping::Zone& zone, const Rooms& rooms) {
  std::vector<double> cells(rooms.all.size(), 0.0);
  const cv::Rect reach = around(zone, rooms);
  for (int row = reach.y; row < reach.br().y; ++row) {
    for (int column = reach.x; column < reach.br().x; ++column) {
      const int id = rooms.ids.at<int>(row, column);
      if (id != 0 && mapping::contains(zone, placeOf(rooms, {column, row})))
        cells[static_cast<std::size_t>(id - 1)] += 1.0;
    }
  }
  return cells;
}

/// A room and a zone that are mostly the same have one name. As more than half of both is the same, of one room there
/// is one such zone, and of a zone one room.
void nameAfterZones(Rooms& rooms, const std::vector<mapping::Zone>& zones) {
  const double cell_m2 = rooms.resolution_m * rooms.resolution_m;
  for (const auto& zone : zones) {
    const auto inBoth = cellsIn(zone, rooms);
    const double inZone = std::accumulate(inBoth.begin(), inBoth.end(), 0.0);
    for (std::size_t i = 0; i < rooms.all.size(); ++i) {
      const double inEither = rooms.all[i].area_m2 / cell_m2 + inZone - inBoth[i];
      if (inBoth[i] > kIsThisZone * inEither) rooms.all[i].name = zone.name;
    }
  }
}

/// "room 7"; no zone is called so.
std::string numberedName(int id, const std::vector<mapping::Zone>& zones) {
  std::string name = "room " + std::to_string(id);
  const auto isTaken = [&name](const mapping::Zone& zone) { return zone.name == name; };
  while (std::any_of(zones.begin(), zones.end(), isTaken)) name += "'";
  return name;
}

}  // namespace

Rooms findRooms(const mapping::FloorPlan& plan, const std::vector<const mapping::MapObject*>& things,
                const std::vector<mapping::Zone>& zones, const RoomOptions& options) {
  Rooms rooms;
  rooms.resolution_m = plan.resolution_m;
  rooms.origin_m = plan.origin_m;
  if (plan.cells.empty()) return rooms;
  const double cell_m2 = plan.resolution_m * plan.resolution_m;
  const auto regions = cutAtNarrowPlaces(floorWithoutThings(plan, things),
                                         {options.widestDoor_m / plan.resolution_m, options.smallestRoom_m2 / cell_m2});
  rooms.ids = regions.ids;
  for (std::size_t i = 0; i < regions.middles.size(); ++i) {
    const int id = static_cast<int>(i) + 1;
    rooms.all.push_back({id, numberedName(id, zones), cell_m2 * cv::countNonZero(rooms.ids == id),
                         placeOf(rooms, regions.middles[i]), outlineOf(rooms, id)});
  }
  rooms.doors = doorsOf(rooms, regions, plan);
  nameAfterZones(rooms, zones);
  return rooms;
}

}  // namespace wardslam::building
