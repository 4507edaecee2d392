#include "fleet_history_command.h"

#include <chrono>
#include <ctime>
#include <memory>
#include <vector>

#include "answer.h"
#include "fleet_arguments.h"
#include "support/interruption.h"
#include "support/program.h"
#include "support/table.h"
#include "wardslam/fleet/history.h"
#include "wardslam/fleet/watch.h"

namespace wardslam::apps {
namespace {

using Json = nlohmann::ordered_json;

struct HistoryArguments {
  std::string database;
  fleet::MapChoice choice;
  mapping::ObjectId object = 0;
  std::string className;
  std::string left;            ///< A zone or room.
  std::vector<double> near_m;  ///< x y z radius
  std::string at;
  std::string since;
  bool json = false;
};

/// UNIX seconds of "1764345600", "2026-11-28 14:00" or "2026-11-28" (UTC).
double momentOf(const std::string& text) {
  for (const char* format :
       {"%Y-%m-%d %H:%M:%S", "%Y-%m-%dT%H:%M:%S", "%Y-%m-%d %H:%M", "%Y-%m-%dT%H:%M", "%Y-%m-%d"}) {
    std::tm utc{};
    const char* end = strptime(text.c_str(), format, &utc);
    if (end != nullptr && (*end == '\0' || std::string(end) == "Z")) return static_cast<double>(timegm(&utc));
  }
  try {
    std::size_t length = 0;
    const double seconds = std::stod(text, &length);
    if (length == text.size()) return seconds;
  } catch (const std::logic_error&) {  // no number
  }
  throw UsageError("'" + text + "' is no moment: write 2026-11-28 14:00 (UTC), or UNIX seconds");
}

std::string timeText(double stamp_s) {
  const auto seconds = static_cast<std::time_t>(stamp_s);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::string text(sizeof "2000-01-01 00:00:00", '\0');
  text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &utc));
  return text;
}

Json toJson(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

Json toJson(const std::vector<fleet::Whereabouts>& list) {
  Json found = Json::array();
  for (const auto& one : list) {
    Json json = {{"site", one.site},
                 {"storey", one.storey},
                 {"robot", one.robot},
                 {"map", one.map},
                 {"id", one.object},
                 {"class_name", one.className},
                 {"since", one.since_s},
                 {"until", one.until_s},
                 {"ended", nullptr},
                 {"centroid", toJson(one.place_m)},
                 {"box_min", toJson(one.box_m.min())},
                 {"box_max", toJson(one.box_m.max())},
                 {"zone", one.zone},
                 {"room", one.room}};
    if (!one.ended.empty()) json["ended"] = {{"how", one.ended}, {"at", one.ended_s}};
    if (one.next) json["to"] = *one.next;
    found.push_back(json);
  }
  return {{"found", found}};
}

void print(std::ostream& out, const std::vector<fleet::Whereabouts>& list) {
  Table table({"thing", "robot", "map", "seen there (UTC)", "last", "then", "place [m]", "zone", "room", "to"});
  for (const auto& one : list) {
    const std::string then = one.ended.empty() ? "" : one.ended + " by " + timeText(one.ended_s);
    const std::string place =
        fixed(one.place_m.x(), 2) + " " + fixed(one.place_m.y(), 2) + " " + fixed(one.place_m.z(), 2);
    table.add({one.className + " #" + std::to_string(one.object), one.robot, one.map, timeText(one.since_s),
               timeText(one.until_s), then, place, one.zone, one.room, one.next.value_or("")});
  }
  table.print(out);
}

double now_s() { return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count(); }

std::vector<fleet::Whereabouts> find(const HistoryArguments& arguments) {
  const double at_s = arguments.at.empty() ? now_s() : momentOf(arguments.at);
  if (!arguments.left.empty()) {
    const double since_s = arguments.since.empty() ? 0.0 : momentOf(arguments.since);
    return fleet::whatLeft(arguments.database, arguments.choice, arguments.left, since_s);
  }
  if (!arguments.near_m.empty()) {
    return fleet::whatStood(arguments.database, arguments.choice, Eigen::Vector3d(arguments.near_m.data()),
                            arguments.near_m[3], at_s);
  }
  if (arguments.object == 0) throw UsageError("fleet history needs --object, --near or --left");
  return fleet::whereWas(arguments.database, arguments.choice, arguments.className, arguments.object, at_s);
}

void history(const HistoryArguments& arguments) {
  const auto found = find(arguments);
  show(arguments.json, toJson(found), [&](std::ostream& out) {
    if (found.empty()) {
      out << "nothing\n";
    } else {
      print(out, found);
    }
  });
}

Json toJson(const fleet::ToldChange& change) {
  return {{"kind", change.kind},
          {"at", change.at_s},
          {"site", change.site},
          {"storey", change.storey},
          {"robot", change.robot},
          {"map", change.map},
          {"id", change.object},
          {"class_name", change.className},
          {"centroid", toJson(change.place_m)},
          {"zone", change.zone},
          {"room", change.room},
          {"zone_before", change.zoneBefore}};
}

void print(std::ostream& out, const fleet::ToldChange& change) {
  out << timeText(change.at_s) << " " << change.kind << " " << change.className << " #" << change.object;
  const std::string& place = change.zone.empty() ? change.room : change.zone;
  if (!place.empty()) out << " in " << place;
  if (!change.zoneBefore.empty() && change.zoneBefore != change.zone) out << ", before in " << change.zoneBefore;
  out << " (" << change.robot << ", " << change.map << ")";
}

void watch(const HistoryArguments& arguments) {
  const InterruptionGuard interruption;
  fleet::Watcher watcher;
  watcher.isReady = [] { std::cerr << "wardslam: watching; Ctrl-C ends it\n"; };
  watcher.hear = [&](const fleet::ToldChange& change) {
    if (arguments.json) {
      std::cout << toJson(change).dump();
    } else {
      print(std::cout, change);
    }
    std::cout << std::endl;  // as they come
  };
  watcher.isInterrupted = [&] { return interruption.requested(); };
  fleet::watch(arguments.database, arguments.choice, watcher);
}

CLI::App* addVerb(CLI::App& command, const char* name, const char* help, void (*run)(const HistoryArguments&),
                  const std::shared_ptr<HistoryArguments>& arguments) {
  CLI::App* verb = command.add_subcommand(name, help);
  addDatabase(*verb, arguments->database);
  addChoice(*verb, arguments->choice);
  verb->add_flag("--json", arguments->json, "print JSON instead of text");
  verb->callback([arguments, run] { run(*arguments); });
  return verb;
}

}  // namespace

void addFleetHistoryCommands(CLI::App& fleetCommand) {
  const auto arguments = std::make_shared<HistoryArguments>();
  CLI::App* verb = addVerb(fleetCommand, "history",
                           "Where a thing was, what stood somewhere, or what left a zone or room", history, arguments);
  CLI::Option* at = verb->add_option("--at", arguments->at, "when: 2026-11-28 14:00 (UTC) or UNIX seconds; else now");
  CLI::Option* object = verb->add_option("--object", arguments->object, "the number of a thing: where was it?");
  verb->add_option("--class", arguments->className, "its class, such as chair")->needs(object);
  CLI::Option* near = verb->add_option("--near", arguments->near_m, "x y z and a distance, metres: what stood there?")
                          ->expected(4)
                          ->excludes(object);
  CLI::Option* left = verb->add_option("--left", arguments->left, "a zone or room: what left it?")
                          ->excludes(object)
                          ->excludes(near)
                          ->excludes(at);
  verb->add_option("--since", arguments->since, "since when, as --at; else ever")->needs(left);
  addVerb(fleetCommand, "watch", "Print what pushes change, as they come, until Ctrl-C", watch,
          std::make_shared<HistoryArguments>());
}

}  // namespace wardslam::apps
