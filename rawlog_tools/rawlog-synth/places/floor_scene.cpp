#include "places/floor_scene.h"

#include <vector>

#include "camera/camera_path.h"
#include "furniture/furniture.h"
#include "furniture/scene_builder.h"

namespace wardslam::synth {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kLength_m = 18.0F;
constexpr float kWidth_m = 10.0F;
constexpr float kCorridor_m = 3.0F;   ///< Its width, to the middle of the wall.
constexpr float kPartition_m = 9.0F;  ///< Between the rooms.
constexpr float kThickness_m = 0.15F;
constexpr float kDoorWidth_m = 1.6F;
constexpr float kDoorHeight_m = 2.1F;

struct InnerWall {
  Vector2f from_m;
  Vector2f to_m;
  Material right;  ///< What it shows to the right of the way from one end to the other.
  Material left;
  std::vector<float> doors_m;  ///< Their middles along the wall.
};

/// One side of a wall with its openings; `doors_m` from its left end as one looks at it.
void addFace(Assembly& walls, Material material, const Vector2f& from_m, const Vector2f& to_m, float height_m,
             const std::vector<float>& doors_m) {
  const float length_m = (to_m - from_m).norm();
  const Vector2f along = (to_m - from_m) / length_m;
  const auto addPart = [&](float begin_m, float end_m, float bottom_m) {
    const Vector2f origin = from_m + begin_m * along;
    const Vector2f u = (end_m - begin_m) * along;
    const float part_m = height_m - bottom_m;
    walls.addExact(material, panel({origin.x(), origin.y(), bottom_m}, {u.x(), u.y(), 0}, {0, 0, part_m})
                                 .mapUv({begin_m / length_m, 0}, {(end_m - begin_m) / length_m, part_m / height_m}));
  };
  float done_m = 0.0F;
  for (const float door_m : doors_m) {
    addPart(done_m, door_m - kDoorWidth_m / 2, 0.0F);
    addPart(door_m - kDoorWidth_m / 2, door_m + kDoorWidth_m / 2, kDoorHeight_m);
    done_m = door_m + kDoorWidth_m / 2;
  }
  addPart(done_m, length_m, 0.0F);
}

void addDoorFrame(Assembly& walls, const Isometry3f& middle) {
  constexpr float kFrame_m = 0.06F;
  const float depth_m = kThickness_m + 0.04F;
  for (const float side : {-1.0F, 1.0F}) {
    walls.add(
        Material::Wood,
        box({kFrame_m, depth_m, kDoorHeight_m}).transform(middle * at(side * kDoorWidth_m / 2, 0, kDoorHeight_m / 2)));
  }
  walls.add(Material::Wood,
            box({kDoorWidth_m + kFrame_m, depth_m, kFrame_m}).transform(middle * at(0, 0, kDoorHeight_m)));
}

void addInnerWall(Assembly& walls, const InnerWall& wall, float height_m) {
  const float length_m = (wall.to_m - wall.from_m).norm();
  const Vector2f along = (wall.to_m - wall.from_m) / length_m;
  const Vector2f toRight = kThickness_m / 2 * Vector2f(along.y(), -along.x());
  std::vector<float> mirrored_m;
  for (auto door = wall.doors_m.rbegin(); door != wall.doors_m.rend(); ++door) mirrored_m.push_back(length_m - *door);
  addFace(walls, wall.right, wall.from_m + toRight, wall.to_m + toRight, height_m, wall.doors_m);
  addFace(walls, wall.left, wall.to_m - toRight, wall.from_m - toRight, height_m, mirrored_m);
  for (const float door_m : wall.doors_m) {
    const Vector2f p = wall.from_m + door_m * along;
    addDoorFrame(walls, at(p.x(), p.y(), 0, std::atan2(along.y(), along.x())));
  }
}

Surfaces innerWalls(SceneBuilder& floor) {
  Assembly walls(floor.rng());
  const InnerWall corridor{
      {0, kCorridor_m}, {kLength_m, kCorridor_m}, Material::CorridorWall, Material::RoomsWall, {2.0F, 16.0F}};
  const InnerWall partition{
      {kPartition_m, kCorridor_m}, {kPartition_m, kWidth_m}, Material::PartitionEast, Material::PartitionWest, {1.4F}};
  addInnerWall(walls, corridor, floor.room().height_m);
  addInnerWall(walls, partition, floor.room().height_m);
  return walls.take();
}

void addChairs(SceneBuilder& floor, const std::vector<Isometry3f>& places) {
  for (const Isometry3f& place : places)
    floor.stand("chair", kChair, makeChair(floor.rng()), floor.nudged(place), 0.44F, 0.44F);
}

void addPlants(SceneBuilder& floor, const std::vector<Vector2f>& places_m) {
  for (const Vector2f& p : places_m) {
    const float turn_rad = floor.rng().uniform(0.0F, 6.0F);
    floor.stand("potted plant", kPlant, makePlant(floor.rng()), at(p.x(), p.y(), 0, turn_rad), 0.36F, 0.36F);
  }
}

void addTable(SceneBuilder& floor, const Isometry3f& place) {
  floor.stand("dining table", kTable, makeTable(floor.rng()), place, 0.7F, 0.7F);
  addChairs(floor, {place * at(-0.75F, 0, 0, 0.1F), place * at(0.1F, 0.75F, 0, -1.7F)});
}

void addCurtain(SceneBuilder& floor, float x_m) {
  floor.add("curtain", kCurtain, makeCurtain(floor.rng().uniform(0.9F, 1.3F), 2.1F, floor.room().height_m, floor.rng()),
            at(x_m, kWidth_m - 0.08F, 0, kFromNorth_rad));
}

void addRooms(SceneBuilder& floor) {
  int number = 0;
  for (const float x : {1.5F, 4.2F, 6.9F, 10.7F, 13.4F, 16.2F}) {
    ++number;
    floor.addBedPlace(number, at(x, kWidth_m, 0, kFromNorth_rad), {number % 2 == 0, number % 3 != 0});
  }
  floor.addBedPlace(++number, at(14.7F, kCorridor_m + kThickness_m / 2, 0, kFromSouth_rad), {false, false});
  for (const float x : {2.6F, 5.4F, 11.8F, 14.7F}) addCurtain(floor, x);
  addTable(floor, at(7.3F, 6.2F, 0, 0.2F));
  addTable(floor, at(11.0F, 6.3F, 0, 2.0F));
  addChairs(floor, {at(5.9F, 3.4F, 0, kFromSouth_rad), at(6.7F, 3.4F, 0, kFromSouth_rad),
                    at(10.2F, 3.4F, 0, kFromSouth_rad), at(17.5F, 6.0F, 0, kFromEast_rad)});
  addPlants(floor, {{0.45F, 3.6F}, {8.6F, 9.5F}, {17.5F, 3.6F}});
  floor.stand("trash_bin", kTrashBin, makeTrashBin(floor.rng()), at(0.35F, 6.4F, 0), 0.36F, 0.4F);
  floor.stand("trolley", kTrolley, makeTrolley(floor.rng()), at(3.3F, 4.6F, 0, 1.4F), 0.5F, 0.9F);
  floor.add("tv", kTv, makeTelevision(floor.rng()), at(kPartition_m - kThickness_m / 2, 7.2F, 1.75F, kFromEast_rad));
}

void addCorridor(SceneBuilder& floor) {
  addChairs(floor, {at(4.6F, 0.35F, 0, kFromSouth_rad), at(5.3F, 0.35F, 0, kFromSouth_rad),
                    at(11.4F, 0.35F, 0, kFromSouth_rad), at(12.1F, 2.6F, 0, kFromNorth_rad)});
  addPlants(floor, {{0.45F, 0.45F}, {9.3F, 0.4F}, {17.5F, 0.5F}});
  floor.stand("trash_bin", kTrashBin, makeTrashBin(floor.rng()), at(7.1F, 2.65F, 0, 1.0F), 0.36F, 0.4F);
  floor.stand("iv_stand", kIvStand, makeIvStand(floor.rng()), at(6.2F, 2.6F, 0), 0.3F, 0.3F);
  floor.stand("bedside_cabinet", kCabinet, makeBedsideCabinet(floor.rng()), at(10.3F, 2.65F, 0, kFromNorth_rad), 0.48F,
              0.46F);
  floor.stand("bed", kBed, makeBed(13, floor.rng()), at(12.9F, 0.53F, 0, 0.01F), 0.0F, 0.0F);
}

void addPictures(SceneBuilder& floor) {
  const float corridorSide = kCorridor_m - kThickness_m / 2;
  const float roomSide = kCorridor_m + kThickness_m / 2;
  int poster = 0;
  const auto hang = [&](float x_m, float y_m, float facing_rad) {
    const float width_m = floor.rng().uniform(0.45F, 0.65F);
    floor.addPicture(poster++ % (kPosterColumns * kPosterRows), width_m,
                     at(x_m, y_m, floor.rng().uniform(1.6F, 1.8F), facing_rad));
  };
  for (const float x : {1.2F, 3.1F, 6.2F, 8.3F, 10.2F, 13.6F, 16.4F}) hang(x, 0.0F, kFromSouth_rad);
  for (const float x : {4.1F, 5.6F, 8.0F, 9.4F, 11.3F, 14.0F}) hang(x, corridorSide, kFromNorth_rad);
  for (const float x : {4.2F, 7.6F, 10.6F, 12.4F, 17.4F}) hang(x, roomSide, kFromSouth_rad);
  for (const float y : {0.8F, 2.2F, 3.6F, 6.6F, 8.4F}) hang(0.0F, y, kFromWest_rad);
  for (const float y : {0.9F, 2.1F, 8.2F}) hang(kLength_m, y, kFromEast_rad);
  for (const float y : {5.9F, 8.6F}) hang(kPartition_m + kThickness_m / 2, y, kFromWest_rad);
  for (const float y : {5.8F, 8.7F}) hang(kPartition_m - kThickness_m / 2, y, kFromEast_rad);
}

RoomShape floorShape() {
  RoomShape shape;
  shape.length_m = kLength_m;
  shape.width_m = kWidth_m;
  shape.innerWalls_m = {{Material::CorridorWall, kLength_m},
                        {Material::RoomsWall, kLength_m},
                        {Material::PartitionWest, kWidth_m - kCorridor_m},
                        {Material::PartitionEast, kWidth_m - kCorridor_m}};
  return shape;
}

}  // namespace

Scene buildFloor(const SceneOptions& options) {
  SceneBuilder floor(floorShape(), options.seed);
  floor.addShell(innerWalls(floor));
  addRooms(floor);
  addCorridor(floor);
  addPictures(floor);
  if (options.people) addPeople(floor.scene(), floor.nextId(), floorWays());
  return floor.take();
}

ClosedRoute FloorPath::floorRoute() {
  constexpr double kBend_m = 0.9;
  // clang-format off
  return {{{2.0, 1.5}, {2.0, 7.0}, {4.6, 7.0}, {4.6, 4.4}, {13.4, 4.4}, {13.4, 7.0}, {16.0, 7.0}, {16.0, 1.5}}, kBend_m};
  // clang-format on
}

Eigen::Isometry3d FloorPath::T_world_cam(double t_s) const {
  const auto place = route.at(t_s / round_s * route.length_m());
  return drivenCamera({place.p_m, place.heading_rad, 0.13, mount}, t_s / round_s);
}

Setting floorSetting(const SceneOptions& options, const CameraMount& mount) {
  FloorPath path;
  path.mount = mount;
  Setting setting;
  setting.scene = buildFloor(options);
  setting.T_world_cam = [path](double t_s) { return path.T_world_cam(t_s); };
  setting.duration_s = path.round_s;
  return setting;
}

PeopleWays floorWays() {
  const Walker nurse(
      {{0.0, {3.2, 0.75}}, {10.0, {12.0, 0.75}}, {14.0, {12.0, 0.75}}, {24.0, {3.2, 0.75}}, {60.0, {3.2, 0.75}}}, 0.0);
  const Walker porter({{0.0, {12.2, 6.9}},
                       {30.2, {12.2, 6.9}},
                       {33.2, {12.3, 3.6}},
                       {44.0, {12.3, 3.6}},
                       {48.0, {12.2, 6.9}},
                       {60.0, {12.2, 6.9}}},
                      0.0);
  const Walker visitor({{0.0, {5.7, 7.4}},
                        {16.0, {5.7, 7.4}},
                        {18.5, {6.0, 5.6}},
                        {20.5, {6.0, 5.6}},
                        {24.0, {5.7, 7.4}},
                        {60.0, {5.7, 7.4}}},
                       0.0);
  return {nurse, porter, visitor};
}

}  // namespace wardslam::synth
