#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "scene/classes.h"
#include "scene/scene.h"
#include "textures/textures.h"

namespace wardslam::synth {

/// Which way x points from a wall into the room.
constexpr float kFromNorth_rad = -3.14159265F / 2;
constexpr float kFromSouth_rad = 3.14159265F / 2;
constexpr float kFromEast_rad = 3.14159265F;
constexpr float kFromWest_rad = 0.0F;

struct BedPlace {
  bool ivStand = true;
  bool chair = true;
};

/// Furnishes a building: numbers and names what it puts there, and remembers what throws a shadow on the floor.
class SceneBuilder {
 public:
  SceneBuilder(const RoomShape& room, std::uint32_t seed);

  [[nodiscard]] const RoomShape& room() const { return room_; }
  [[nodiscard]] cv::RNG& rng() { return rng_; }
  [[nodiscard]] Scene& scene() { return scene_; }
  [[nodiscard]] std::uint16_t nextId() const { return nextId_; }

  Label label(const std::string& kind, core::ClassId id);
  void add(const std::string& kind, core::ClassId id, const Surfaces& surfaces, const Eigen::Isometry3f& T);
  /// Stands on the floor and throws a soft shadow of that size.
  void stand(const std::string& kind, core::ClassId id, const Surfaces& surfaces, const Eigen::Isometry3f& T,
             float size_x, float size_y);
  /// A little to the side and turned, as things stand in a room that is used.
  [[nodiscard]] Eigen::Isometry3f nudged(const Eigen::Isometry3f& T);

  /// Floor, ceiling and outer walls with their rails.
  void addShell(Surfaces further = {});
  /// A bed with its head to the wall and what belongs to it. `wall`: on the floor at the wall, x into the room.
  void addBedPlace(int number, const Eigen::Isometry3f& wall, const BedPlace& place);
  void addPicture(int poster, float width_m, const Eigen::Isometry3f& T);

  /// Paints what has been built.
  [[nodiscard]] Scene take();

 private:
  RoomShape room_;
  std::uint32_t seed_;
  cv::RNG rng_;
  Scene scene_;
  std::uint16_t nextId_ = 1;
  std::map<core::ClassId, int> counts_;
};

}  // namespace wardslam::synth
