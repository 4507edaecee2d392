#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "wardslam/mapping/zones.h"
#include "wardslam/pipeline/frame_observer.h"

namespace wardslam::pipeline {

/// How long and how far the camera went in a zone.
struct ZoneStay {
  double time_s = 0.0;
  double distance_m = 0.0;  ///< Over the floor.
  int entries = 0;
};

/// Follows the camera through the zones of the floor (P11), by the poses as they are known at the time.
class ZoneWatch : public FrameObserver {
 public:
  /// Hears where the camera comes from and which zone it enters; empty = outside of all.
  using OnEnter = std::function<void(const std::string& left, const std::string& entered, double stamp_s)>;

  explicit ZoneWatch(mapping::Zones zones, OnEnter onEnter = {});

  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

  /// By name; a step from one frame to the next counts for the zone it ends in. "" is what lies outside.
  [[nodiscard]] const std::map<std::string, ZoneStay>& stays() const { return stays_; }

 private:
  struct Place {
    double stamp_s = 0.0;
    Eigen::Vector2d p_map_m = Eigen::Vector2d::Zero();
    std::string zone;
  };

  mapping::Zones zones_;
  OnEnter onEnter_;
  std::optional<Place> last_;  ///< Nothing before the first pose and while tracking is lost.
  std::string zone_;           ///< The last one known.
  std::map<std::string, ZoneStay> stays_;
};

}  // namespace wardslam::pipeline
