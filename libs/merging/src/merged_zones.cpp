#include "merged_zones.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <tuple>

namespace wardslam::merging {
namespace {

using mapping::Zone;

constexpr double kSamePlace = 0.9;  // of what two zones cover together, that is of both
constexpr int kCellsAcross = 400;   // to measure that by
constexpr double kSameDirection_rad = 0.05;

Zone moved(Zone zone, const Eigen::Isometry3d& motion) {
  if (motion.matrix().isIdentity(0.0)) return zone;
  for (Eigen::Vector2d& corner_m : zone.polygon_m)
    corner_m = (motion * Eigen::Vector3d(corner_m.x(), corner_m.y(), 0.0)).head<2>();
  if (zone.type == mapping::ZoneType::OneWay) zone.direction_rad += std::atan2(motion(1, 0), motion(0, 0));
  return zone;
}

cv::Mat drawn(const Zone& zone, const Eigen::AlignedBox2d& box_m) {
  cv::Mat cells(kCellsAcross, kCellsAcross, CV_8UC1, cv::Scalar(0));
  std::vector<cv::Point> corners;
  for (const Eigen::Vector2d& corner_m : zone.polygon_m) {
    const Eigen::Vector2d part = (corner_m - box_m.min()).cwiseQuotient(box_m.sizes());
    corners.emplace_back(cvRound(part.x() * (kCellsAcross - 1)), cvRound(part.y() * (kCellsAcross - 1)));
  }
  cv::fillPoly(cells, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(255));
  return cells;
}

bool coverTheSame(const Zone& a, const Zone& b) {
  Eigen::AlignedBox2d box_m;
  for (const Zone* zone : {&a, &b}) {
    for (const Eigen::Vector2d& corner_m : zone->polygon_m) box_m.extend(corner_m);
  }
  const cv::Mat first = drawn(a, box_m);
  const cv::Mat second = drawn(b, box_m);
  return cv::countNonZero(first & second) >= kSamePlace * cv::countNonZero(first | second);
}

bool askTheSame(const Zone& a, const Zone& b) {
  const auto all = [](const Zone& zone) {
    return std::tie(zone.actions.entry, zone.actions.inside, zone.actions.exit);
  };
  return a.type == b.type && a.maxSpeed_mps == b.maxSpeed_mps && all(a) == all(b) &&
         std::abs(std::remainder(a.direction_rad - b.direction_rad, 2.0 * M_PI)) < kSameDirection_rad;
}

}  // namespace

MergedZones mergeZones(const std::vector<Run>& runs, const JoinedRuns& joined) {
  MergedZones merged;
  std::map<std::string, const Run*> drawnIn;
  for (const Run& run : runs) {
    const bool isInMap = joined.pieces.pieceOf(run.map.semantic.piece) == joined.map;
    for (const Zone& drawn : run.map.semantic.zones) {
      if (!isInMap) {
        merged.notes.push_back("zone '" + drawn.name + "' of " + run.name + " is left out: no place connects that map");
        continue;
      }
      const auto away_m = [&](const Eigen::Vector3d& p_m) { return distance_m(drawn, p_m.head<2>()); };
      Zone zone = moved(drawn, motionAround(away_m, run, run.map.semantic.piece, joined));
      const auto [before, isNew] = drawnIn.emplace(zone.name, &run);
      if (isNew) {
        merged.zones.push_back(std::move(zone));
        continue;
      }
      Zone& known = *std::find_if(merged.zones.begin(), merged.zones.end(),
                                  [&](const Zone& other) { return other.name == zone.name; });
      const bool isThere = coverTheSame(known, zone);
      if (isThere && askTheSame(known, zone)) continue;
      merged.notes.push_back("zone '" + zone.name + (isThere ? "' asks for something else in " : "' is elsewhere in ") +
                             before->second->name + " than in " + run.name + ": that of the later map stays");
      known = std::move(zone);
      before->second = &run;
    }
  }
  return merged;
}

}  // namespace wardslam::merging
