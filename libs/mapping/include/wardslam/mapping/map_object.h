#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>

#include "wardslam/mapping/semantic_cloud_tile.h"

namespace wardslam::mapping {

enum class ObjectState {
  Static,  ///< Stands where the map says.
  Moved,   ///< Stands there now, and stood elsewhere before.
  Gone,    ///< Was there; its place has since been seen empty.
};

/// "static", "moved" or "gone".
[[nodiscard]] std::string toString(ObjectState state);

/// A box whose sides need not be parallel to the axes of the map frame.
struct OrientedBox {
  Eigen::Isometry3d T_map_box = Eigen::Isometry3d::Identity();  ///< Origin at the box's centre.
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();             ///< Full lengths along the box's own axes.
};

/// A thing that was lost and may have been found in another record; which, nobody saw.
struct MaybeSame {
  ObjectId id = 0;           ///< The record of what was lost.
  double probability = 0.0;  ///< 0..1
};

/// A row of the instance database (P9). Everything in the map frame.
struct MapObject {
  ObjectId id = 0;
  core::ClassId classId = 0;
  double probability = 0.0;  ///< That it is of this class, 0..1.
  Eigen::Vector3d centroid_m = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box_m;  ///< Parallel to the axes of the map frame.
  OrientedBox orientedBox;
  std::array<std::uint8_t, 3> color_rgb{};  ///< The semantic colour of its class.
  double firstSeen_s = 0.0;                 ///< UNIX time.
  double lastSeen_s = 0.0;
  int views = 0;     ///< Frames of the map that saw it.
  std::string zone;  ///< Innermost zone its centroid lies in; empty = none.
  ObjectState state = ObjectState::Static;
  std::optional<MaybeSame> maybeSameAs;  ///< A hint; it never makes two records one.
};

}  // namespace wardslam::mapping
