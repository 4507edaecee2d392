#include "furniture/scene_builder.h"

#include "furniture/furniture.h"

namespace wardslam::synth {

using Eigen::Isometry3f;
using Eigen::Vector3f;

SceneBuilder::SceneBuilder(const RoomShape& room, std::uint32_t seed) : room_(room), seed_(seed), rng_(seed) {}

Label SceneBuilder::label(const std::string& kind, core::ClassId id) {
  return {nextId_++, kind + "_" + std::to_string(++counts_[id]), id, kind};
}

void SceneBuilder::add(const std::string& kind, core::ClassId id, const Surfaces& surfaces, const Isometry3f& T) {
  scene_.things.push_back({label(kind, id), placed(surfaces, T)});
}

void SceneBuilder::stand(const std::string& kind, core::ClassId id, const Surfaces& surfaces, const Isometry3f& T,
                         float size_x, float size_y) {
  add(kind, id, surfaces, T);
  const Vector3f half = (T.linear() * Vector3f(size_x, size_y, 0)).cwiseAbs() / 2;
  const Vector3f p = T.translation();
  room_.footprints_m.emplace_back(p.x() - half.x(), p.y() - half.y(), 2 * half.x(), 2 * half.y());
}

Isometry3f SceneBuilder::nudged(const Isometry3f& T) {
  return T * at(rng_.uniform(-0.05F, 0.05F), rng_.uniform(-0.05F, 0.05F), 0.0F, rng_.uniform(-0.12F, 0.12F));
}

void SceneBuilder::addShell(Surfaces further) {
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
  Surfaces building = shell.take();
  building.insert(building.end(), further.begin(), further.end());
  scene_.things.push_back({{0, "room", 0, ""}, std::move(building)});
}

void SceneBuilder::addBedPlace(int number, const Isometry3f& wall, const BedPlace& place) {
  constexpr float kWallGap_m = 0.12F;
  const Isometry3f head = wall * at(kWallGap_m, 0, 0);
  // Seen from the wall: the cabinet stands to the left of the bed, stand and chair to its right.
  stand("bed", kBed, makeBed(11 + number % 2, rng_),
        head * at(rng_.uniform(0.0F, 0.06F), 0, 0, rng_.uniform(-0.03F, 0.03F)), 0.0F, 0.0F);
  const Vector3f middle = head * Vector3f(kBedLength_m / 2, 0, 0);
  room_.footprints_m.emplace_back(middle.x() - 0.5F, middle.y() - 1.0F, 1.0F, 2.0F);
  stand("bedside_cabinet", kCabinet, makeBedsideCabinet(rng_), nudged(head * at(0.25F, 0.85F, 0)), 0.46F, 0.48F);
  if (place.ivStand) stand("iv_stand", kIvStand, makeIvStand(rng_), nudged(head * at(0.45F, -0.75F, 0)), 0.3F, 0.3F);
  if (place.chair) stand("chair", kChair, makeChair(rng_), nudged(head * at(1.45F, -0.95F, 0, 1.3F)), 0.44F, 0.44F);
  add("wall_outlet_panel", kOutletPanel, makeOutletPanel(rng_), wall * at(0, 0, 1.45F));
  add("patient_monitor", kMonitor, makePatientMonitor(rng_), wall * at(0, 0.42F, 1.85F));
  add("sign", kSign, makePicture((3 + number) % (kPosterColumns * kPosterRows), 0.3F, rng_),
      wall * at(0, -0.15F, 1.9F));
}

void SceneBuilder::addPicture(int poster, float width_m, const Isometry3f& T) {
  add("picture", kPicture, makePicture(poster, width_m, rng_), T);
}

Scene SceneBuilder::take() {
  scene_.textures = paintTextures(room_, seed_);
  return std::move(scene_);
}

}  // namespace wardslam::synth
