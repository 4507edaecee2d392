#include "hospital/hospital_building.h"

#include <algorithm>
#include <cmath>

#include "furniture/furniture.h"
#include "hospital/hospital_sight.h"
#include "hospital/hospital_textures.h"

namespace wardslam::synth {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kPiece_m = 5.0F;  ///< Large surfaces are made of pieces, so that what is not seen can be left out.
constexpr float kHalfWall_m = kInnerWall_m / 2;

struct Interval {
  float from_m;
  float to_m;
};

/// A side of a room, in the room's frame; the room lies to its right.
struct Side {
  Vector2f from_m;
  Vector2f along;
  float length_m;

  [[nodiscard]] float placeOf(const Vector2f& p) const { return along.dot(p - from_m); }
  [[nodiscard]] float distanceOf(const Vector2f& p) const {
    return std::abs(along.x() * (p - from_m).y() - along.y() * (p - from_m).x());
  }
};

std::vector<Side> sidesOf(const Room& room) {
  const float x = room.width_m() / 2;
  const float d = room.depth_m();
  return {{{x, 0}, {-1, 0}, 2 * x}, {{-x, 0}, {0, 1}, d}, {{-x, d}, {1, 0}, 2 * x}, {{x, d}, {0, -1}, d}};
}

Material wallOf(RoomKind kind) {
  switch (kind) {
    case RoomKind::Corridor:
    case RoomKind::Lobby:
    case RoomKind::NurseStation:
      return Material::CorridorWall;
    case RoomKind::Toilet:
    case RoomKind::Bath:
      return Material::TiledWall;
    case RoomKind::Store:
    case RoomKind::Utility:
      return Material::BareWall;
    default:
      return Material::RoomsWall;
  }
}

class Walls {
 public:
  Walls(const HospitalPlan& plan, std::size_t index, cv::RNG& rng)
      : plan_(plan), index_(index), room_(plan.rooms[index]), rng_(rng), parts_(rng) {}

  [[nodiscard]] Thing build() {
    addFloorAndCeiling();
    for (const Side& side : sidesOf(room_)) addSide(side);
    for (const Door& door : plan_.doors) {
      if (ownerOf(door) == index_) addFrame(door);
    }
    return {{0, room_.id, 0, ""}, placed(parts_.take(), room_.T_world_room), static_cast<int>(index_)};
  }

 private:
  void addFloorAndCeiling();
  void addSide(const Side& side);
  void addPiece(const Side& side, Interval part, float bottom_m, Material material);
  void addSolid(const Side& side, Interval part);
  void addFrame(const Door& door);
  [[nodiscard]] Vector2f local(const Eigen::Vector2d& p_m) const {
    return (room_.T_world_room.inverse() * Vector3f(static_cast<float>(p_m.x()), static_cast<float>(p_m.y()), 0))
        .head<2>();
  }
  [[nodiscard]] bool isCorridor() const { return room_.kind == RoomKind::Corridor; }

  const HospitalPlan& plan_;
  std::size_t index_;
  const Room& room_;
  cv::RNG& rng_;
  Assembly parts_;
};

void Walls::addFloorAndCeiling() {
  const float w = room_.width_m();
  const float d = room_.depth_m();
  const auto pieces = [](float length_m) { return std::max(1, static_cast<int>(std::ceil(length_m / kPiece_m))); };
  const int columns = pieces(w);
  const int rows = pieces(d);
  // The tiles begin at the corner; which part of the pattern lies there differs, but not among wards.
  const auto shift = [&](float texture_m) {
    const auto tiles = static_cast<int>(texture_m / kFloorTile_m);
    return room_.kind == RoomKind::Ward ? 0.0F : static_cast<float>(rng_.uniform(0, tiles)) / static_cast<float>(tiles);
  };
  const Vector2f place(shift(kFloorTexture_m), shift(kFloorTexture_m));
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < rows; ++k) {
      const Vector2f size(w / static_cast<float>(columns), d / static_cast<float>(rows));
      const Vector2f begin(static_cast<float>(i) * size.x(), static_cast<float>(k) * size.y());
      const float x = begin.x() - w / 2;
      parts_.addExact(Material::Floor, panel({x, begin.y(), 0}, {size.x(), 0, 0}, {0, size.y(), 0})
                                           .mapUv(place + Vector2f(begin.x(), -begin.y() - size.y()) / kFloorTexture_m,
                                                  size / kFloorTexture_m));
      parts_.addExact(Material::Ceiling,
                      panel({x, begin.y() + size.y(), plan_.height_m}, {size.x(), 0, 0}, {0, -size.y(), 0})
                          .mapUv(begin / kCeilingTexture_m, size / kCeilingTexture_m));
    }
  }
}

/// A piece of wall between two heights, in front of the wall's middle.
void Walls::addPiece(const Side& side, Interval part, float bottom_m, Material material) {
  const Vector2f inwards(side.along.y(), -side.along.x());
  const auto count = static_cast<float>(std::max(1, static_cast<int>(std::ceil((part.to_m - part.from_m) / kPiece_m))));
  const float step_m = (part.to_m - part.from_m) / count;
  const float height_m = plan_.height_m - bottom_m;
  for (float i = 0; i < count; ++i) {
    const float begin_m = part.from_m + i * step_m;
    const Vector2f origin = side.from_m + begin_m * side.along + kHalfWall_m * inwards;
    const Vector2f u = step_m * side.along;
    parts_.addExact(material,
                    panel({origin.x(), origin.y(), bottom_m}, {u.x(), u.y(), 0}, {0, 0, height_m})
                        .mapUv({begin_m / kWallTexture_m, 0}, {step_m / kWallTexture_m, height_m / plan_.height_m}));
  }
}

/// Wall from floor to ceiling, with its rail where it is a corridor's.
void Walls::addSolid(const Side& side, Interval part) {
  if (part.to_m - part.from_m < 1e-3F) return;
  const auto addWith = [&](Interval piece, bool bare) {
    if (piece.to_m - piece.from_m < 1e-3F) return;
    addPiece(side, piece, 0.0F, bare ? Material::BareWall : wallOf(room_.kind));
    const float length_m = piece.to_m - piece.from_m - 0.16F;
    if (bare || !isCorridor() || length_m < 0.5F) return;
    const Vector2f inwards(side.along.y(), -side.along.x());
    const Vector2f p = side.from_m + (piece.from_m + piece.to_m) / 2 * side.along + (kHalfWall_m + 0.04F) * inwards;
    const float yaw = std::atan2(side.along.y(), side.along.x());
    parts_.add(Material::Wood, box({length_m, 0.05F, 0.14F}).transform(at(p.x(), p.y(), 0.92F, yaw)));
  };
  if (index_ != plan_.bare.room || std::abs(side.along.x()) < 0.5F) return addWith(part, false);
  const float a = side.placeOf(local({plan_.bare.fromX_m, 0}));
  const float b = side.placeOf(local({plan_.bare.toX_m, 0}));
  const auto within = [&](float s) { return std::clamp(s, part.from_m, part.to_m); };
  const Interval bare{within(std::min(a, b)), within(std::max(a, b))};
  addWith({part.from_m, bare.from_m}, false);
  addWith(bare, true);
  addWith({bare.to_m, part.to_m}, false);
}

void Walls::addSide(const Side& side) {
  struct Opening {
    Interval part;
    float height_m;
  };
  std::vector<Opening> openings;
  for (const Door& door : plan_.doors) {
    if (door.room != index_ && door.corridor != index_) continue;
    const Vector2f from = local(door.from_m);
    const Vector2f to = local(door.to_m);
    if (side.distanceOf(from) > 1e-2F || side.distanceOf(to) > 1e-2F) continue;
    const float a = side.placeOf(from);
    const float b = side.placeOf(to);
    openings.push_back({{std::min(a, b), std::max(a, b)}, door.height_m});
  }
  std::sort(openings.begin(), openings.end(),
            [](const Opening& a, const Opening& b) { return a.part.from_m < b.part.from_m; });
  float done_m = kHalfWall_m;
  for (const Opening& opening : openings) {
    addSolid(side, {done_m, opening.part.from_m});
    if (opening.height_m < plan_.height_m - 1e-3F) addPiece(side, opening.part, opening.height_m, wallOf(room_.kind));
    done_m = opening.part.to_m;
  }
  addSolid(side, {done_m, side.length_m - kHalfWall_m});
}

/// Its jambs and head, as deep as the wall.
void Walls::addFrame(const Door& door) {
  constexpr float kFrame_m = 0.06F;
  const Vector2f from = local(door.from_m);
  const Vector2f to = local(door.to_m);
  const Vector2f middle = (from + to) / 2;
  const Vector2f along = (to - from).normalized();
  const float width_m = (to - from).norm();
  const bool throughout = door.height_m > plan_.height_m - 1e-3F;
  const float depth_m = throughout ? kInnerWall_m : kInnerWall_m + 0.04F;
  const Material material = throughout ? Material::BareWall : Material::Wood;
  const Isometry3f T = at(middle.x(), middle.y(), 0, std::atan2(along.y(), along.x()));
  const float shift_m = throughout ? kFrame_m / 2 : 0.0F;  // a corner of the wall stays one
  for (const float end : {-1.0F, 1.0F}) {
    const float x = end * (width_m / 2 + shift_m);
    parts_.add(material, box({kFrame_m, depth_m, door.height_m}).transform(T * at(x, 0, door.height_m / 2)));
  }
  if (!throughout)
    parts_.add(material, box({width_m + kFrame_m, depth_m, kFrame_m}).transform(T * at(0, 0, door.height_m)));
}

}  // namespace

std::vector<Thing> buildWalls(const HospitalPlan& plan, std::uint32_t seed) {
  std::vector<Thing> things;
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    // Wards are painted alike; every other room has its own numbers.
    const bool isWard = plan.rooms[i].kind == RoomKind::Ward;
    cv::RNG rng = isWard ? cv::RNG((static_cast<std::uint64_t>(seed) << 32U) + 5999) : numbersOf(plan, seed, 5000 + i);
    things.push_back(Walls(plan, i, rng).build());
  }
  return things;
}

}  // namespace wardslam::synth
