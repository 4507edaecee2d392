#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/fleet/stored_maps.h"

namespace wardslam::fleet {

/// A thing stood somewhere, as one robot's map has it; lengths in metres in that map's frame, times UNIX seconds.
struct Whereabouts {
  std::string site;
  std::string storey;
  std::string robot;
  std::string map;
  mapping::ObjectId object = 0;
  std::string className;
  double since_s = 0.0;  ///< First and
  double until_s = 0.0;  ///< last time it was seen there.
  std::string ended;     ///< "moved", "gone", or empty: it is there, as far as is known.
  double ended_s = 0.0;  ///< When that was known.
  Eigen::Vector3d place_m = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box_m;
  std::string zone;
  std::string room;                 ///< By the rooms as they are known now; empty: in none.
  std::optional<std::string> next;  ///< The zone or room it came to, of what left one and is not gone.
};

/// Where a thing was at a moment, by each map that knows it: the last place it had been seen in by then. That which was
/// seen last comes first. Maps that went on from each other know one thing by one number.
[[nodiscard]] std::vector<Whereabouts> whereWas(const std::string& url, const MapChoice& choice,
                                                const std::string& className, mapping::ObjectId object, double at_s);

/// What stood within so many metres of a place, by its centroid, at a moment.
[[nodiscard]] std::vector<Whereabouts> whatStood(const std::string& url, const MapChoice& choice,
                                                 const Eigen::Vector3d& p_map_m, double radius_m, double at_s);

/// What was in a zone, or in a room where no zone is called so, and since then was found gone or outside of it; in
/// order of when. Throws core::InputError also where nothing is called so.
[[nodiscard]] std::vector<Whereabouts> whatLeft(const std::string& url, const MapChoice& choice,
                                                const std::string& place, double since_s);

}  // namespace wardslam::fleet
