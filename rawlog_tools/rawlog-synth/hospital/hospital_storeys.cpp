#include "hospital/hospital_storeys.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace wardslam::synth {
namespace {

constexpr int kCellsPerStorey = 1000;

/// One of those who live at z = 0, on a higher floor.
class RaisedActor : public Actor {
 public:
  /// `outOfSight`: of a storey that is never seen, a box around all of it; nobody needs to know more closely then.
  RaisedActor(std::unique_ptr<Actor> actor, float z_m, std::optional<Eigen::AlignedBox3f> outOfSight)
      : Actor(actor->label()), actor_(std::move(actor)), up_m_(0, 0, z_m), outOfSight_(std::move(outOfSight)) {}

  [[nodiscard]] Surfaces surfacesAt(double t_s) const override {
    return placed(actor_->surfacesAt(t_s), Eigen::Isometry3f(Eigen::Translation3f(up_m_)));
  }
  [[nodiscard]] bool isMovingAt(double t_s) const override { return actor_->isMovingAt(t_s); }
  [[nodiscard]] double atRestFrom_s() const override { return actor_->atRestFrom_s(); }
  [[nodiscard]] Eigen::AlignedBox3f boundsAt(double t_s) const override {
    return outOfSight_ ? *outOfSight_ : actor_->boundsAt(t_s).translated(up_m_);
  }
  [[nodiscard]] std::vector<RestInterval> restsUntil(double t_s) const override {
    std::vector<RestInterval> rests = actor_->restsUntil(t_s);
    for (RestInterval& rest : rests) rest.bounds_m.translate(up_m_);
    return rests;
  }
  [[nodiscard]] float floorZ_m() const override { return up_m_.z(); }

 private:
  std::unique_ptr<Actor> actor_;
  Eigen::Vector3f up_m_;
  std::optional<Eigen::AlignedBox3f> outOfSight_;
};

Eigen::AlignedBox3f boxAround(const std::vector<Thing>& things) {
  Eigen::AlignedBox3f box_m;
  for (const Thing& thing : things) {
    for (const Surface& surface : thing.surfaces) {
      for (const Vertex& vertex : surface.mesh.vertices) box_m.extend(vertex.p_m);
    }
  }
  return box_m;
}

void add(Scene& building, Scene storey, int number, bool isDriven) {
  const float z_m = floorZOf(number);
  for (Thing& thing : storey.things) {
    thing.surfaces = placed(std::move(thing.surfaces), Eigen::Isometry3f(Eigen::Translation3f(0, 0, z_m)));
    thing.cell += kCellsPerStorey * number;
  }
  std::optional<Eigen::AlignedBox3f> outOfSight;
  if (!isDriven) outOfSight = boxAround(storey.things);
  std::move(storey.things.begin(), storey.things.end(), std::back_inserter(building.things));
  for (auto& actor : storey.actors)
    building.actors.push_back(std::make_unique<RaisedActor>(std::move(actor), z_m, outOfSight));
  for (const auto& [material, texture] : storey.textures) building.textures.emplace(material, texture);
  building.farthest_m = std::max(building.farthest_m, storey.farthest_m);
}

}  // namespace

int storeyAt(double z_m, std::size_t storeys) {
  const double storey = std::floor(z_m / static_cast<double>(kStoreyHeight_m));
  return static_cast<int>(std::clamp(storey, 0.0, static_cast<double>(storeys) - 1));
}

Scene stacked(std::vector<Scene> storeys, std::size_t driven) {
  if (storeys.size() == 1) return std::move(storeys.front());
  Scene building;
  building.textures = storeys[driven].textures;
  building.farthest_m = storeys[driven].farthest_m;
  building.mayBeSeen = [number = static_cast<int>(driven), sees = storeys[driven].mayBeSeen](
                           int cell, const Eigen::Isometry3d& T_world_cam) {
    return cell / kCellsPerStorey == number && sees(cell % kCellsPerStorey, T_world_cam);
  };
  for (std::size_t i = 0; i < storeys.size(); ++i)
    add(building, std::move(storeys[i]), static_cast<int>(i), i == driven);
  return building;
}

}  // namespace wardslam::synth
