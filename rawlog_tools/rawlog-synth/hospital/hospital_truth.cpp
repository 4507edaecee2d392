#include "hospital/hospital_truth.h"

#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"

namespace wardslam::synth {
namespace {

using Json = nlohmann::ordered_json;

double millimetres(double value_m) { return std::round(value_m * 1000) / 1000; }

Json pointJson(const Eigen::Vector2d& p_m) { return {millimetres(p_m.x()), millimetres(p_m.y())}; }

std::vector<Eigen::Vector2d> cornersOf(const Room& room) {
  const Eigen::Vector2d low = room.area_m.min();
  const Eigen::Vector2d high = room.area_m.max();
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

Json feature(Json properties, const char* type, Json coordinates) {
  return {{"type", "Feature"},
          {"properties", std::move(properties)},
          {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}}};
}

Json roomFeature(const Room& room, int storey) {
  Json ring = Json::array();
  for (const auto& corner : cornersOf(room)) ring.push_back(pointJson(corner));
  ring.push_back(ring.front());
  return feature({{"what", "room"},
                  {"id", room.id},
                  {"name", room.name},
                  {"kind", nameOf(room.kind)},
                  {"storey", storey},
                  {"area_m2", millimetres(room.area_m.volume())}},
                 "Polygon", Json::array({ring}));
}

Json doorFeature(const HospitalPlan& plan, std::size_t index) {
  const Door& door = plan.doors[index];
  return feature(
      {{"what", "door"},
       {"id", (plan.storey > 0 ? "s" + std::to_string(plan.storey) + "-door-" : "door-") + std::to_string(index + 1)},
       {"rooms", {plan.rooms[door.room].id, plan.rooms[door.corridor].id}},
       {"storey", plan.storey},
       {"state", nameOf(door.state)},
       {"open_rad", millimetres(static_cast<double>(door.opening_rad))},
       {"width_m", millimetres((door.to_m - door.from_m).norm())},
       {"height_m", millimetres(static_cast<double>(door.height_m))}},
      "LineString", {pointJson(door.from_m), pointJson(door.to_m)});
}

Json bareFeature(const HospitalPlan& plan) {
  const WallStretch& bare = plan.bare;
  const double y = plan.rooms[bare.room].area_m.center().y();
  return feature({{"what", "bare_walls"}, {"room", plan.rooms[bare.room].id}, {"storey", plan.storey}}, "LineString",
                 {pointJson({bare.fromX_m, y}), pointJson({bare.toX_m, y})});
}

void writePlace(std::ostream& text, const HospitalPlan& plan, const std::optional<Item>& item) {
  if (!item) {
    text << ",,,,";
    return;
  }
  const Eigen::Vector2d p = middleOf(*item);
  const Eigen::Vector3f front = item->T_world_item.linear().col(0);
  text << "," << plan.rooms[item->room].id << "," << p.x() << "," << p.y() << "," << std::atan2(front.y(), front.x());
}

void writeChange(std::ostream& text, const HospitalPlan& plan, const DayChange& change) {
  const Item& item = change.before ? *change.before : *change.after;
  text << change.day << "," << item.identity << "," << nameOf(item) << "," << classNameOf(item.kind) << ","
       << nameOf(change.what);
  writePlace(text, plan, change.before);
  writePlace(text, plan, change.after);
  text << "\n";
}

}  // namespace

std::string roomsGeoJson(const std::vector<const HospitalPlan*>& storeys) {
  Json features = Json::array();
  for (const HospitalPlan* plan : storeys) {
    for (const Room& room : plan->rooms) features.push_back(roomFeature(room, plan->storey));
    for (std::size_t i = 0; i < plan->doors.size(); ++i) features.push_back(doorFeature(*plan, i));
    features.push_back(bareFeature(*plan));
  }
  return Json({{"type", "FeatureCollection"}, {"features", features}}).dump(1) + "\n";
}

std::string zonesYaml(const HospitalPlan& plan) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << "# The rooms; x and y in metres, world frame.\nzones:\n";
  for (const Room& room : plan.rooms) {
    text << "- name: " << room.id << "\n  polygon: [";
    const char* separator = "";
    for (const auto& corner : cornersOf(room)) {
      text << separator << "[" << corner.x() << ", " << corner.y() << "]";
      separator = ", ";
    }
    text << "]\n";
  }
  return text.str();
}

std::string daysCsv(const std::vector<DaysOfStorey>& storeys) {
  std::ostringstream text;
  text << "day,identity,name,class_name,what,from_room,from_x,from_y,from_yaw,to_room,to_x,to_y,to_yaw\n"
       << std::fixed << std::setprecision(3);
  for (const DaysOfStorey& storey : storeys) {
    for (const DayChange& change : storey.today.changes) writeChange(text, storey.plan, change);
  }
  return text.str();
}

void writeHospitalTruth(const std::filesystem::path& folder, const std::vector<DaysOfStorey>& storeys,
                        std::size_t driven, const HospitalRoute& route, double until_s) {
  const auto& [plan, today] = storeys.at(driven);
  std::vector<const HospitalPlan*> plans;
  for (const DaysOfStorey& storey : storeys) plans.push_back(&storey.plan);
  core::writeFileAtomically(folder / "rooms.geojson", roomsGeoJson(plans));
  core::writeFileAtomically(folder / "zones.yaml", zonesYaml(plan));
  core::writeFileAtomically(folder / "days.csv", daysCsv(storeys));
  const auto picture = folder / "plan.png";
  if (!cv::imwrite(picture.string(), planPicture(plan, today, route, until_s)))
    throw core::InputError(picture.string() + ": could not be written; is the disk full?");
}

}  // namespace wardslam::synth
