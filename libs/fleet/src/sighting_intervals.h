#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "wardslam/mapping/map_object.h"

namespace wardslam::fleet {

/// A thing was seen in one place from `since_s` to `until_s`. What it stands in is its `zone`.
struct Stay {
  double since_s = 0.0;
  double until_s = 0.0;
  Eigen::Vector3d place_m = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box_m;
  std::string zone;
  std::string ended;     ///< "moved", "gone", or empty: it is there, as far as is known.
  double ended_s = 0.0;  ///< When it was known.
};

/// What the map remembers of a thing besides; 0: nothing.
struct Traces {
  double handled_s = 0.0;  ///< Last in somebody's hands.
  double gone_s = 0.0;     ///< Its place was found empty.
};

/// What a map that was pushed adds to what was known of one thing.
struct StayUpdate {
  std::optional<Stay> last;  ///< The last stay as it is now; none: as it was.
  std::optional<Stay> next;  ///< One that follows.
  std::string change;        ///< "new", "moved", "gone", "back", or empty.
};

/// A thing that stands further from where it was, and is called moved, has moved; less is a better look at it.
constexpr double kMoved_m = 0.3;

/// `lastPlace_m`: where the last stay was, by what the map knows now (corrections move all of a map). `mapEnd_s`: stamp
/// of the newest keyframe.
[[nodiscard]] StayUpdate updateStays(const std::optional<Stay>& last, const Eigen::Vector3d& lastPlace_m,
                                     const mapping::MapObject& object, const Traces& traces, double mapEnd_s);

}  // namespace wardslam::fleet
