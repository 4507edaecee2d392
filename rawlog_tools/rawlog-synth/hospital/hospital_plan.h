#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

/// The plan of a storey: rooms, doors, windows. World frame: x along the long corridors, y across them, z up; metres.
namespace wardslam::synth {

enum class RoomKind { Corridor, Ward, NurseStation, Lobby, DayRoom, Store, Toilet, Bath, Office, Treatment, Utility };
[[nodiscard]] const char* nameOf(RoomKind kind);

/// A rectangle between the middles of its walls.
struct Room {
  std::string id;    ///< "ward-3"; unique.
  std::string name;  ///< As its sign says: "WARD 3".
  RoomKind kind = RoomKind::Corridor;
  Eigen::AlignedBox2d area_m;
  /// Frame of what stands in it: origin on the floor in the middle of the wall that has the door, x along the wall, y
  /// into the room. Rooms that look the same do so in this frame.
  Eigen::Isometry3f T_world_room = Eigen::Isometry3f::Identity();

  [[nodiscard]] float width_m() const { return static_cast<float>(area_m.sizes().x()); }
  [[nodiscard]] float depth_m() const { return static_cast<float>(area_m.sizes().y()); }
};

enum class DoorState { Open, Ajar, Closed, Passage };  ///< Passage: an opening without a leaf.
[[nodiscard]] const char* nameOf(DoorState state);

/// An opening in the wall between two rooms. Its wall runs along x or along y.
struct Door {
  std::size_t room = 0;      ///< The leaf opens into this one.
  std::size_t corridor = 0;  ///< The other one.
  Eigen::Vector2d from_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d to_m = Eigen::Vector2d::Zero();
  float height_m = 2.1F;
  DoorState state = DoorState::Open;
  float opening_rad = 0.0F;  ///< Of the leaf; 0 = closed. It hangs at `from_m`.

  [[nodiscard]] Eigen::Vector2d middle_m() const { return (from_m + to_m) / 2; }
};

/// Part of a corridor's wall.
struct WallStretch {
  std::size_t room = 0;
  double fromX_m = 0.0;
  double toX_m = 0.0;
};

struct HospitalPlan {
  int storey = 0;
  std::vector<Room> rooms;
  std::vector<Door> doors;
  WallStretch bare;  ///< Of a corridor: nothing but white walls on both sides.
  float height_m = 2.9F;
  Eigen::Vector2d size_m = Eigen::Vector2d::Zero();
  std::size_t corridorA = 0;  ///< The two long corridors, and the three that cross between them, from west to east.
  std::size_t corridorB = 0;
  std::size_t crossings[3] = {0, 0, 0};

  [[nodiscard]] double area_m2() const;
  /// Index of the room around the place; rooms.size() where there is none.
  [[nodiscard]] std::size_t roomAt(const Eigen::Vector2d& p_m) const;
};

constexpr float kInnerWall_m = 0.15F;  ///< Thickness.
constexpr double kBareLength_m = 8.0;

/// From one storey's floor to the next one's.
constexpr float kStoreyHeight_m = 3.6F;

/// Another seed, another plan: sizes, order of rooms, which way round, which doors are open. Storeys of a hospital have
/// the same outline, corridors and size of wards; all else is each one's own. At its own height z = 0.
[[nodiscard]] HospitalPlan planHospital(std::uint32_t seed, int storey = 0);

/// Numbers for something of this storey alone; `what` says for what.
[[nodiscard]] cv::RNG numbersOf(const HospitalPlan& plan, std::uint32_t seed, std::uint64_t what);

}  // namespace wardslam::synth
