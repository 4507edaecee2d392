#include "ward_scene.h"

#include <array>
#include <cmath>
#include <string>

#include "actors.h"
#include "furniture.h"
#include "ward_people.h"

namespace wardslam::synth {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;

constexpr float kPi = 3.14159265F;
constexpr float kWallGap_m = 0.12F;  ///< Between a wall and a bed's head end.

enum Class : core::ClassId {
  kChair = 57,
  kPlant = 59,
  kBed = 60,
  kTable = 61,
  kTv = 63,
  kCurtain = 101,
  kTrolley = 102,
  kIvStand = 103,
  kCabinet = 104,
  kTrashBin = 106,
  kPicture = 110,
  kMonitor = 113,
  kSign = 116,
  kOutletPanel = 120
};

/// Which way x points from a wall into the room.
constexpr float kFromNorth_rad = -kPi / 2;
constexpr float kFromSouth_rad = kPi / 2;
constexpr float kFromEast_rad = kPi;
constexpr float kFromWest_rad = 0.0F;

class WardBuilder {
 public:
  explicit WardBuilder(const WardOptions& options) : options_(options), rng_(options.seed) {}
  [[nodiscard]] Scene build();

 private:
  void addShell();
  void addBedPlaces();
  void addBedPlace(int number, float x, bool north);
  void addCorner();
  void addPictures();
  void addTrolleyAndPeople();

  Label label(const std::string& kind, core::ClassId id) {
    return {nextId_++, kind + "_" + std::to_string(++counts_[id]), id, kind};
  }
  void add(const std::string& kind, core::ClassId id, const Surfaces& surfaces, const Isometry3f& T) {
    scene_.things.push_back({label(kind, id), placed(surfaces, T)});
  }
  /// Stands on the floor and throws a soft shadow of that size.
  void stand(const std::string& kind, core::ClassId id, const Surfaces& surfaces, const Isometry3f& T, float size_x,
             float size_y);
  /// A little to the side and turned, as things stand in a room that is used.
  Isometry3f nudged(const Isometry3f& T) {
    return T * at(rng_.uniform(-0.05F, 0.05F), rng_.uniform(-0.05F, 0.05F), 0.0F, rng_.uniform(-0.12F, 0.12F));
  }

  WardOptions options_;
  cv::RNG rng_;
  RoomShape room_;
  Scene scene_;
  std::uint16_t nextId_ = 1;
  std::map<core::ClassId, int> counts_;
};

void WardBuilder::stand(const std::string& kind, core::ClassId id, const Surfaces& surfaces, const Isometry3f& T,
                        float size_x, float size_y) {
  add(kind, id, surfaces, T);
  const Vector3f half = (T.linear() * Vector3f(size_x, size_y, 0)).cwiseAbs() / 2;
  const Vector3f p = T.translation();
  room_.footprints_m.emplace_back(p.x() - half.x(), p.y() - half.y(), 2 * half.x(), 2 * half.y());
}

void WardBuilder::addShell() {
  const float l = room_.length_m;
  const float w = room_.width_m;
  const float h = room_.height_m;
  const Vector3f up(0, 0, h);
  Assembly shell(rng_);
  shell.addExact(Material::Floor, panel({0, 0, 0}, {l, 0, 0}, {0, w, 0}));
  shell.addExact(Material::Ceiling, panel({0, w, h}, {l, 0, 0}, {0, -w, 0}));
  shell.addExact(Material::WallNorth, panel({0, w, 0}, {l, 0, 0}, up));
  shell.addExact(Material::WallSouth, panel({l, 0, 0}, {-l, 0, 0}, up));
  shell.addExact(Material::WallEast, panel({l, w, 0}, {0, -w, 0}, up));
  shell.addExact(Material::WallWest, panel({0, 0, 0}, {0, w, 0}, up));
  for (const float y : {0.03F, w - 0.03F})
    shell.add(Material::Wood, box({l, 0.06F, 0.14F}).transform(at(l / 2, y, 0.92F)));
  shell.add(Material::Plastic, box({0.16F, 4.0F, 0.05F}).transform(at(l - 0.08F, w / 2, 0.88F)));  // window sill
  scene_.things.push_back({{0, "room", 0, ""}, shell.take()});
}

void WardBuilder::addBedPlace(int number, float x, bool north) {
  const float yaw = north ? kFromNorth_rad : kFromSouth_rad;
  const Isometry3f head = at(x, north ? room_.width_m - kWallGap_m : kWallGap_m, 0, yaw);
  const Isometry3f wall = at(x, north ? room_.width_m : 0.0F, 0, yaw);
  // Seen from the wall: the cabinet stands to the left of the bed, stand and chair to its right.
  stand("bed", kBed, makeBed(11 + number % 2, rng_),
        head * at(rng_.uniform(0.0F, 0.06F), 0, 0, rng_.uniform(-0.03F, 0.03F)), 0.0F, 0.0F);
  const Vector3f middle = head * Vector3f(kBedLength_m / 2, 0, 0);
  room_.footprints_m.emplace_back(middle.x() - 0.5F, middle.y() - 1.0F, 1.0F, 2.0F);
  stand("bedside_cabinet", kCabinet, makeBedsideCabinet(rng_), nudged(head * at(0.25F, 0.85F, 0)), 0.46F, 0.48F);
  if (number % 2 == 1) stand("iv_stand", kIvStand, makeIvStand(rng_), nudged(head * at(0.45F, -0.75F, 0)), 0.3F, 0.3F);
  if (number != 2 && number != 5)
    stand("chair", kChair, makeChair(rng_), nudged(head * at(1.45F, -0.95F, 0, 1.3F)), 0.44F, 0.44F);
  add("wall_outlet_panel", kOutletPanel, makeOutletPanel(rng_), wall * at(0, 0, 1.45F));
  add("patient_monitor", kMonitor, makePatientMonitor(rng_), wall * at(0, 0.42F, 1.85F));
  add("sign", kSign, makePicture(3 + number, 0.3F, rng_), wall * at(0, -0.15F, 1.9F));
}

void WardBuilder::addBedPlaces() {
  const std::array<float, 3> north_m = {1.6F, 4.4F, 7.2F};
  const std::array<float, 2> south_m = {1.8F, 4.9F};
  int number = 0;
  for (const float x : north_m) addBedPlace(++number, x, true);
  for (const float x : south_m) addBedPlace(++number, x, false);
  for (const float x : {3.0F, 6.05F}) {
    add("curtain", kCurtain, makeCurtain(rng_.uniform(0.9F, 1.3F), 2.1F, room_.height_m, rng_),
        at(x - 0.2F, room_.width_m - 0.08F, 0, kFromNorth_rad));
  }
  add("curtain", kCurtain, makeCurtain(rng_.uniform(1.0F, 1.4F), 2.1F, room_.height_m, rng_),
      at(3.2F, 0.08F, 0, kFromSouth_rad));
}

void WardBuilder::addCorner() {
  stand("dining table", kTable, makeTable(rng_), at(7.1F, 0.75F, 0, 0.2F), 0.7F, 0.7F);
  stand("chair", kChair, makeChair(rng_), nudged(at(6.35F, 0.75F, 0, 0.1F)), 0.44F, 0.44F);
  stand("chair", kChair, makeChair(rng_), nudged(at(7.2F, 1.5F, 0, -1.7F)), 0.44F, 0.44F);
  stand("potted plant", kPlant, makePlant(rng_), at(8.6F, 0.45F, 0), 0.36F, 0.36F);
  stand("potted plant", kPlant, makePlant(rng_), at(8.65F, 5.95F, 0, 1.0F), 0.36F, 0.36F);
  stand("trash_bin", kTrashBin, makeTrashBin(rng_), at(0.35F, 1.6F, 0), 0.36F, 0.4F);
  add("tv", kTv, makeTelevision(rng_), at(7.2F, 0, 1.75F, kFromSouth_rad));
}

void WardBuilder::addPictures() {
  struct Place {
    int poster = 0;
    float width_m = 0.5F;
    Isometry3f T = Isometry3f::Identity();
  };
  const float l = room_.length_m;
  const float w = room_.width_m;
  const std::array<Place, 12> places = {{{0, 0.55F, at(2.45F, w, 1.75F, kFromNorth_rad)},
                                         {1, 0.6F, at(5.35F, w, 1.8F, kFromNorth_rad)},
                                         {2, 0.5F, at(8.25F, w, 1.7F, kFromNorth_rad)},
                                         {9, 0.55F, at(0.55F, w, 1.7F, kFromNorth_rad)},
                                         {12, 0.5F, at(0.7F, 0, 1.75F, kFromSouth_rad)},
                                         {13, 0.55F, at(2.75F, 0, 1.7F, kFromSouth_rad)},
                                         {14, 0.6F, at(3.75F, 0, 1.75F, kFromSouth_rad)},
                                         {15, 0.5F, at(6.1F, 0, 1.7F, kFromSouth_rad)},
                                         {10, 0.45F, at(l, 0.65F, 1.7F, kFromEast_rad)},
                                         {11, 0.45F, at(l, 5.75F, 1.75F, kFromEast_rad)},
                                         {3, 0.5F, at(0, 2.1F, 1.75F, kFromWest_rad)},
                                         {8, 0.5F, at(0, 4.6F, 1.75F, kFromWest_rad)}}};
  for (const Place& place : places) add("picture", kPicture, makePicture(place.poster, place.width_m, rng_), place.T);
}

void WardBuilder::addTrolleyAndPeople() {
  const Surfaces trolley = makeTrolley(rng_);
  auto actor = std::make_unique<TrolleyActor>(label("trolley", kTrolley), porterWalk(), kTrolleyLeft_s, trolley);
  if (options_.people) {
    scene_.actors.push_back(std::move(actor));
    addPeople(scene_, nextId_);
    return;
  }
  scene_.things.push_back({actor->label(), actor->surfacesAt(kTrolleyLeft_s)});
}

Scene WardBuilder::build() {
  addShell();
  addBedPlaces();
  addCorner();
  addPictures();
  addTrolleyAndPeople();
  scene_.textures = paintTextures(room_, options_.seed);
  return std::move(scene_);
}

}  // namespace

Scene buildWard(const WardOptions& options) { return WardBuilder(options).build(); }

}  // namespace wardslam::synth
