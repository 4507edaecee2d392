#include "hospital/hospital_scene.h"

#include <algorithm>
#include <map>
#include <utility>

#include "furniture.h"
#include "hospital/hospital_building.h"
#include "hospital/hospital_furnishing.h"
#include "hospital/hospital_furniture.h"
#include "hospital/hospital_sight.h"
#include "hospital/hospital_textures.h"
#include "hospital/hospital_truth.h"
#include "hospital/hospital_ways.h"
#include "life/life.h"

namespace wardslam::synth {
namespace {

void addItem(Scene& scene, const Item& item) {
  const Label label{static_cast<std::uint16_t>(item.identity), nameOf(item), classIdOf(item.kind),
                    classNameOf(item.kind)};
  const auto cell = static_cast<int>(item.room);
  scene.things.push_back({label, placed(modelOf(item), item.T_world_item), cell});
  if (!item.occupied) return;
  const Label patient{static_cast<std::uint16_t>(kFirstPatientId + item.number),
                      "patient_" + std::to_string(item.number), kPerson, "person"};
  scene.things.push_back({patient, placed(makePatient(item.variant), item.T_world_item), cell});
}

Density densityOf(const SceneOptions& scene, const HospitalOptions& options) {
  return scene.people ? options.people : Density::None;
}

/// Another day, or for another robot, other people are about.
std::uint32_t lifeSeed(const PlaceOptions& options) {
  const auto day = static_cast<std::uint32_t>(options.hospital.day);
  const auto robot = static_cast<std::uint32_t>(options.hospital.route.robot);
  return options.scene.seed + 7919U * day + 104729U * robot;
}

}  // namespace

Hospital makeHospital(const SceneOptions& scene, const HospitalOptions& options) {
  HospitalPlan plan = planHospital(scene.seed);
  const bool anybody = densityOf(scene, options) != Density::None;
  HospitalDay today = daysLater(plan, furnish(plan, scene.seed, anybody), options.day, scene.seed);
  HospitalRoute route(plan, options.route, scene.seed);
  return {std::move(plan), std::move(today), std::move(route)};
}

Scene buildHospital(const Hospital& hospital, std::uint32_t seed) {
  Scene scene;
  scene.things = buildWalls(hospital.plan, seed);
  for (const Item& item : hospital.today.items) addItem(scene, item);
  scene.textures = paintHospitalTextures(hospital.plan.height_m, signTexts(hospital.plan), seed);
  scene.mayBeSeen = [plan = hospital.plan](int room, const Eigen::Isometry3d& T_world_cam) {
    const Eigen::Vector2d p = T_world_cam.translation().head<2>();
    return static_cast<bool>(roomsSeenFrom(plan, p).at(static_cast<std::size_t>(room)));
  };
  scene.farthest_m = static_cast<float>(hospital.plan.size_m.norm()) + 1.0F;
  return scene;
}

Ways waysOf(const Hospital& hospital, const Scene& scene) {
  Ways ways;
  ways.graph = wayGraph(hospital.plan);
  ways.seats = seatsOf(hospital.today.items, ways.graph);
  ways.spots = standingSpots(hospital.plan, hospital.today.items, ways.graph);
  std::map<int, std::size_t> indexOf;
  for (std::size_t i = 0; i < scene.things.size(); ++i) indexOf[scene.things[i].label.id] = i;
  for (const Item& item : hospital.today.items) {
    if (!isMovable(item.kind) || item.occupied) continue;
    ways.movable.push_back({indexOf.at(item.identity), classIdOf(item.kind), hospital.plan.rooms[item.room].id,
                            item.T_world_item.cast<double>(), item.footprint_m});
  }
  ways.camera_m = [route = hospital.route](double t_s) { return route.at(t_s).p_m; };
  return ways;
}

Setting hospitalSetting(const PlaceOptions& options, const CameraMount& mount) {
  Hospital hospital = makeHospital(options.scene, options.hospital);
  Setting setting;
  setting.scene = buildHospital(hospital, options.scene.seed);
  setting.duration_s = hospital.route.round_s();
  const Ways ways = waysOf(hospital, setting.scene);
  addLife(setting.scene, kFirstVisitorId, ways,
          {densityOf(options.scene, options.hospital), lifeSeed(options), setting.duration_s});
  setting.T_world_cam = [route = hospital.route, mount](double t_s) { return route.T_world_cam(t_s, mount); };
  setting.roomAt = [plan = hospital.plan](const Eigen::Vector2d& p_m) {
    const std::size_t room = plan.roomAt(p_m);
    return room < plan.rooms.size() ? plan.rooms[room].id : std::string();
  };
  setting.writeFurtherTruth = [hospital = std::move(hospital)](const std::filesystem::path& folder, double until_s) {
    writeHospitalTruth(folder, hospital.plan, hospital.today, hospital.route, until_s);
  };
  return setting;
}

}  // namespace wardslam::synth
