#include "run_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>

#include "support/table.h"
#include "wardslam/query/route.h"

namespace wardslam::nav_demo {
namespace {

using apps::fixed;

constexpr double kRadToDeg = 180.0 / M_PI;

std::string outcomeOf(const RunRecord& run) {
  const Verdict& verdict = run.verdict;
  std::string text = run.arrived ? "delivered" : "not there";
  if (verdict.contactsWithPeople > 0) text += ", touched somebody";
  if (verdict.contactsWithThings > 0) text += ", touched something";
  if (verdict.zonesEntered > 0) text += ", in a forbidden zone";
  return text;
}

std::string metres(double value) { return std::isfinite(value) ? fixed(value, 2) : "-"; }

int countOf(const std::vector<RunRecord>& runs, bool (*isSo)(const RunRecord&)) {
  return static_cast<int>(std::count_if(runs.begin(), runs.end(), isSo));
}

}  // namespace

std::string sentenceOf(const RunRecord& run, const Mission& mission) {
  return "Deliver to " + mission.name + ": " + outcomeOf(run) + " after " + fixed(run.time_s, 1) + " s and " +
         fixed(run.verdict.way_m, 2) + " m; nearest to people " + metres(run.verdict.nearestPerson_m) +
         " m, to things " + metres(run.verdict.nearestThing_m) + " m; stands " + fixed(100.0 * run.goalError_m, 0) +
         " cm off. Seed " + std::to_string(run.seed) + ".";
}

void print(std::ostream& out, const std::vector<RunRecord>& runs, const Mission& mission, const Truth& truth) {
  out << "Deliver to " << mission.name << " (object #" << mission.object->id << "): stop at "
      << metres(mission.spot.p_map_m.x()) << " " << metres(mission.spot.p_map_m.y()) << ", facing it; "
      << metres(query::lengthOf_m(mission.T_map_start.translation(), mission.route_m)) << " m planned\n"
      << "Truth: " << truth.source << "; the map is " << fixed(1000.0 * truth.mapError_m, 1)
      << " mm off (RMS of its keyframes)\n\n";
  apps::Table table({"seed", "outcome", "time s", "way m", "to people m", "to things m", "encounters", "plans anew",
                     "waited s", "off cm", "off deg", "to target m"});
  for (const auto& run : runs) {
    table.add({std::to_string(run.seed), outcomeOf(run), fixed(run.time_s, 1), fixed(run.verdict.way_m, 2),
               metres(run.verdict.nearestPerson_m), metres(run.verdict.nearestThing_m),
               std::to_string(run.verdict.encounters), std::to_string(run.replans), fixed(run.waited_s, 1),
               fixed(100.0 * run.goalError_m, 1), fixed(run.facingError_rad * kRadToDeg, 1), metres(run.toTarget_m)});
  }
  table.print(out);
  if (runs.size() < 2) return;
  out << "\n"
      << countOf(runs, [](const auto& run) { return run.isGood(); }) << " of " << runs.size()
      << " delivered without contact; forbidden zones entered in "
      << countOf(runs, [](const auto& run) { return run.verdict.zonesEntered > 0; }) << " runs\n";
}

nlohmann::ordered_json toJson(const std::vector<RunRecord>& runs, const Mission& mission, const Truth& truth) {
  const auto number = [](double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
  };
  nlohmann::ordered_json json = {{"target", mission.name},
                                 {"object_id", mission.object->id},
                                 {"spot", {mission.spot.p_map_m.x(), mission.spot.p_map_m.y(), mission.spot.yaw_rad}},
                                 {"planned_m", query::lengthOf_m(mission.T_map_start.translation(), mission.route_m)},
                                 {"truth", truth.source},
                                 {"map_error_m", truth.mapError_m},
                                 {"good_runs", countOf(runs, [](const auto& run) { return run.isGood(); })},
                                 {"runs", nlohmann::ordered_json::array()}};
  for (const auto& run : runs) {
    const Verdict& verdict = run.verdict;
    json["runs"].push_back({{"seed", run.seed},
                            {"arrived", run.arrived},
                            {"time_s", run.time_s},
                            {"way_m", verdict.way_m},
                            {"contacts_people", verdict.contactsWithPeople},
                            {"contacts_things", verdict.contactsWithThings},
                            {"zones_entered", verdict.zonesEntered},
                            {"nearest_person_m", number(verdict.nearestPerson_m)},
                            {"nearest_thing_m", number(verdict.nearestThing_m)},
                            {"encounters", verdict.encounters},
                            {"replans", run.replans},
                            {"waited_s", run.waited_s},
                            {"goal_error_m", run.goalError_m},
                            {"facing_error_rad", run.facingError_rad},
                            {"to_target_m", number(run.toTarget_m)}});
  }
  return json;
}

}  // namespace wardslam::nav_demo
