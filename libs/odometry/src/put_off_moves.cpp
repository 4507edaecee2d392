#include "put_off_moves.h"

#include <utility>

namespace wardslam::odometry {

void moveTo(const Eigen::Vector3d& p_map_m, const Eigen::Matrix3d& R_map_before, MapPoint& point) {
  Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
  turned.linear() = R_map_before;
  turned.translation() = p_map_m - R_map_before * point.p_map_m;
  move(point, turned);
}

void PutOffMoves::add(std::shared_ptr<const MapUpdate> update, const Eigen::Matrix3d& R_map_before) {
  moves_.push_back({std::move(update), R_map_before, 0, {}});
}

void PutOffMoves::settle(PointId id, MapPoint& point) {
  for (Move& move : moves_) {
    if (!settles(move, id)) continue;
    const auto p_map_m = move.update->p_map_m.find(id);
    if (p_map_m != move.update->p_map_m.end()) moveTo(p_map_m->second, move.R_map_before, point);
  }
}

void PutOffMoves::skip(PointId id) {
  for (Move& move : moves_) move.settled.insert(id);
}

void PutOffMoves::settleSome(std::map<PointId, MapPoint>& points, std::size_t most) {
  if (moves_.empty()) return;
  Move& first = moves_.front();
  auto point = points.lower_bound(first.next);
  for (std::size_t count = 0; count < most && point != points.end(); ++count, ++point)
    settle(point->first, point->second);
  if (point == points.end()) {
    moves_.pop_front();
  } else {
    first.next = point->first;
  }
}

}  // namespace wardslam::odometry
