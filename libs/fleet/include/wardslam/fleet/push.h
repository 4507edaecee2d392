#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace wardslam::fleet {

/// A robot's map. A robot may have several, by name.
struct MapIdentity {
  std::string robot;
  std::string name;
  std::string site;
  std::string storey;
};

/// What a push sent; all 0 where the database had it already.
struct PushReport {
  enum class Outcome { Pushed, WasThere, NewerIsThere };
  Outcome outcome = Outcome::Pushed;
  std::size_t keyframes = 0;
  std::size_t objects = 0;
  std::size_t changes = 0;       ///< Things that are new, moved, gone or back.
  std::uint64_t file_bytes = 0;  ///< Of the file, what had changed.
};

struct PushOptions {
  /// Takes points of the map into the frame of the storey. Without: as the map that this one goes on from, or the first
  /// of its storey; else it is not known.
  std::optional<Eigen::Isometry3d> T_storey_map;
  double patience_s = 60.0;  ///< How long a connection that broke off is tried again.
  std::function<void(const std::string&)> note = [](const std::string&) {};
  std::function<bool()> isInterrupted = [] { return false; };
};

/// Brings the database abreast of a map file, of which it sends what is new. Pieces of the file go ahead and stay; the
/// rest is one transaction: whatever becomes of connection, server or program, all of it is there or nothing, and a
/// push that is repeated adds nothing. The file may be written to meanwhile. Throws core::InputError.
PushReport push(const std::string& url, const MapIdentity& identity, const std::filesystem::path& file,
                const PushOptions& options = {});

}  // namespace wardslam::fleet
