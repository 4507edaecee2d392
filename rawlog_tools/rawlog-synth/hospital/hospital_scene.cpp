#include "hospital/hospital_scene.h"

#include <algorithm>
#include <map>
#include <utility>

#include "furniture/hospital_furniture.h"
#include "hospital/hospital_building.h"
#include "hospital/hospital_furnishing.h"
#include "hospital/hospital_identities.h"
#include "hospital/hospital_sight.h"
#include "hospital/hospital_storeys.h"
#include "hospital/hospital_textures.h"
#include "hospital/hospital_truth.h"
#include "hospital/hospital_ways.h"
#include "life/life.h"
#include "people/patient.h"
#include "scene/classes.h"
#include "scene/floor_truth.h"
#include "wardslam/core/errors.h"

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

/// Far from every storey: its camera does not come by.
const Eigen::Vector2d kNobodyDrives_m(-1000.0, -1000.0);

Density densityOf(const SceneOptions& scene, const HospitalOptions& options) {
  return scene.people ? options.people : Density::None;
}

/// Another day, or for another robot, other people are about.
std::uint32_t lifeSeed(std::uint32_t seed, const HospitalOptions& options) {
  const auto day = static_cast<std::uint32_t>(options.day);
  const auto robot = static_cast<std::uint32_t>(options.route.robot);
  return seed + 7919U * day + 104729U * robot;
}

std::vector<Hospital> makeStoreys(const SceneOptions& scene, HospitalOptions options) {
  if (options.storey < 0 || options.storey >= options.storeys)
    throw core::InputError("--storey " + std::to_string(options.storey) + ": there are " +
                           std::to_string(options.storeys) + ", numbered from 0; see --storeys");
  std::vector<Hospital> storeys;
  for (options.storey = 0; options.storey < options.storeys; ++options.storey)
    storeys.push_back(makeHospital(scene, options));
  return storeys;
}

/// With those who live there, its floor at z = 0.
Scene livelyStorey(const Hospital& storey, const SceneOptions& options, const HospitalOptions& hospital,
                   double duration_s) {
  Scene scene = buildHospital(storey, options.seed);
  Ways ways = waysOf(storey, scene);
  if (storey.plan.storey != hospital.storey) ways.camera_m = [](double) { return kNobodyDrives_m; };
  const std::uint32_t seed =
      lifeSeed(options.seed, hospital) + 15485863U * static_cast<std::uint32_t>(storey.plan.storey);
  addLife(scene, static_cast<std::uint16_t>(firstVisitorId(storey.plan.storey)), ways,
          {densityOf(options, hospital), seed, duration_s});
  return scene;
}

}  // namespace

Hospital makeHospital(const SceneOptions& scene, const HospitalOptions& options) {
  HospitalPlan plan = planHospital(scene.seed, options.storey);
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

Setting hospitalSetting(const SceneOptions& scene, const HospitalOptions& options, const CameraMount& mount) {
  const std::vector<Hospital> storeys = makeStoreys(scene, options);
  const auto driven = static_cast<std::size_t>(options.storey);
  const HospitalRoute& route = storeys[driven].route;
  const float floorZ_m = floorZOf(options.storey);
  Setting setting;
  setting.duration_s = route.round_s();
  std::vector<Scene> scenes;
  for (const Hospital& storey : storeys) scenes.push_back(livelyStorey(storey, scene, options, setting.duration_s));
  setting.scene = stacked(std::move(scenes), driven);
  setting.T_world_cam = [route, mount, floorZ_m](double t_s) -> Eigen::Isometry3d {
    return Eigen::Translation3d(0, 0, static_cast<double>(floorZ_m)) * route.T_world_cam(t_s, mount);
  };
  setting.floorPlan = [floorZ_m](const Scene& built, double until_s) { return trueFloorAt(built, until_s, floorZ_m); };
  if (storeys.size() > 1) setting.storeyAt = [n = storeys.size()](double z_m) { return storeyAt(z_m, n); };
  setting.roomAt = [storeys](const Eigen::Vector3d& p_m) {
    const HospitalPlan& plan = storeys[static_cast<std::size_t>(storeyAt(p_m.z(), storeys.size()))].plan;
    const std::size_t room = plan.roomAt(p_m.head<2>());
    return room < plan.rooms.size() ? plan.rooms[room].id : std::string();
  };
  setting.writeFurtherTruth = [storeys, driven](const std::filesystem::path& folder, double until_s) {
    std::vector<DaysOfStorey> days;
    for (const Hospital& storey : storeys) days.push_back({storey.plan, storey.today});
    writeHospitalTruth(folder, days, driven, storeys[driven].route, until_s);
  };
  return setting;
}

}  // namespace wardslam::synth
