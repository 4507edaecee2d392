#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <unordered_set>

#include "wardslam/odometry/map_point.h"
#include "wardslam/odometry/map_update.h"

namespace wardslam::odometry {

/// Moves a point to where an update says it is. The map turns by `R_map_before` as it goes: so does the side from which
/// the point was seen.
void moveTo(const Eigen::Vector3d& p_map_m, const Eigen::Matrix3d& R_map_before, MapPoint& point);

/// A loop moves all the points there are, and the camera waits for none but those in sight: they are moved when they
/// are asked for, the others little by little. Nobody sees a difference.
class PutOffMoves {
 public:
  void add(std::shared_ptr<const MapUpdate> update, const Eigen::Matrix3d& R_map_before);

  /// The point is where it belongs from now on.
  void settle(PointId id, MapPoint& point);

  /// So is this one, without being moved: it came after the updates.
  void skip(PointId id);

  /// Settles at most so many more of them.
  void settleSome(std::map<PointId, MapPoint>& points, std::size_t most);

  void clear() { moves_.clear(); }
  [[nodiscard]] bool empty() const { return moves_.empty(); }

 private:
  struct Move {
    std::shared_ptr<const MapUpdate> update;
    Eigen::Matrix3d R_map_before;
    PointId next = 0;                     ///< Those with lower ids are settled,
    std::unordered_set<PointId> settled;  ///< and these.
  };

  static bool settles(Move& move, PointId id) { return id >= move.next && move.settled.insert(id).second; }

  std::deque<Move> moves_;  ///< In the order in which they are to be made.
};

}  // namespace wardslam::odometry
