#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

#include "wardslam/fleet/stored_maps.h"

namespace wardslam::fleet {

/// What a push brought about one thing.
struct ToldChange {
  std::string site;
  std::string storey;
  std::string robot;
  std::string map;
  mapping::ObjectId object = 0;
  std::string className;
  std::string kind;  ///< "new", "moved", "gone" or "back".
  double at_s = 0.0;
  Eigen::Vector3d place_m = Eigen::Vector3d::Zero();  ///< In the frame of the map.
  std::string zone;
  std::string room;
  std::string zoneBefore;
};

struct Watcher {
  std::function<void()> isReady = [] {};  ///< From now on nothing is missed.
  std::function<void(const ToldChange&)> hear;
  std::function<bool()> isInterrupted;  ///< Asked several times a second.
};

/// Tells what pushes to the chosen maps change as they come, until it is interrupted. Throws core::InputError, also
/// when the connection breaks off: what comes then would be missed.
void watch(const std::string& url, const MapChoice& choice, const Watcher& watcher);

}  // namespace wardslam::fleet
