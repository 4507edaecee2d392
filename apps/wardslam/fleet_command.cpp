#include "fleet_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "answer.h"
#include "fleet_arguments.h"
#include "fleet_history_command.h"
#include "map_questions.h"
#include "map_rooms.h"
#include "support/interruption.h"
#include "wardslam/fleet/database.h"
#include "wardslam/fleet/push.h"
#include "wardslam/fleet/stored_maps.h"

namespace wardslam::apps {
namespace {

using Path = std::filesystem::path;
using Json = nlohmann::ordered_json;

struct PushArguments {
  std::string database;
  Path file;
  fleet::MapIdentity identity{{}, {}, "main", "0"};
  std::vector<double> pose;  ///< x y z qx qy qz qw
  double patience_s = fleet::PushOptions().patience_s;
  bool json = false;
};

struct PullArguments {
  std::string database;
  Path out;
  fleet::MapChoice choice;
  bool json = false;
};

struct AskArguments {
  std::string database;
  fleet::MapChoice choice;
  MapQuestion question;
};

void init(const std::string& database) {
  const auto steps = fleet::prepareDatabase(database);
  std::cout << fleet::withoutPassword(database) << ": schema version " << steps.now
            << (steps.before == steps.now ? ", as before\n" : "\n");
}

Eigen::Isometry3d poseOf(const std::vector<double>& numbers) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(numbers.data());
  pose.linear() = Eigen::Quaterniond(numbers[6], numbers[3], numbers[4], numbers[5]).normalized().toRotationMatrix();
  return pose;
}

Json toJson(const fleet::PushReport& report) {
  using Outcome = fleet::PushReport::Outcome;
  const char* outcome = report.outcome == Outcome::Pushed     ? "pushed"
                        : report.outcome == Outcome::WasThere ? "was there"
                                                              : "newer is there";
  return {{"outcome", outcome},
          {"keyframes", report.keyframes},
          {"objects", report.objects},
          {"changes", report.changes},
          {"file_bytes", report.file_bytes}};
}

void print(std::ostream& out, const fleet::PushReport& report) {
  if (report.outcome == fleet::PushReport::Outcome::WasThere) {
    out << "the database has it already\n";
  } else if (report.outcome == fleet::PushReport::Outcome::NewerIsThere) {
    out << "the database has a newer state of this map; nothing was sent\n";
  } else {
    out << "sent " << report.keyframes << " keyframes, " << report.objects << " objects, " << report.file_bytes
        << " bytes of the file; " << report.changes << " things are new, moved, gone or back\n";
  }
}

void push(PushArguments arguments) {
  const InterruptionGuard interruption;
  if (arguments.identity.name.empty()) arguments.identity.name = arguments.file.stem().string();
  fleet::PushOptions options;
  if (!arguments.pose.empty()) options.T_storey_map = poseOf(arguments.pose);
  options.patience_s = arguments.patience_s;
  options.note = [](const std::string& note) { std::cerr << "wardslam: " << note << "\n"; };
  options.isInterrupted = [&interruption] { return interruption.requested(); };
  const auto report = fleet::push(arguments.database, arguments.identity, arguments.file, options);
  show(arguments.json, toJson(report), [&](std::ostream& out) { print(out, report); });
}

void pull(const PullArguments& arguments) {
  const auto map = fleet::pullNewestMap(arguments.database, arguments.choice, arguments.out);
  const Json json = {{"file", arguments.out.string()},
                     {"site", map.site},
                     {"storey", map.storey},
                     {"robot", map.robot},
                     {"name", map.name},
                     {"last_stamp", map.lastStamp_s},
                     {"size_bytes", map.size_bytes}};
  show(arguments.json, json, [&](std::ostream& out) {
    out << arguments.out.string() << ": map '" << map.name << "' of robot '" << map.robot << "', site '" << map.site
        << "', storey '" << map.storey << "', " << map.size_bytes << " bytes\n";
  });
}

using Answer = void (*)(const MapQuestion&, const mapping::SemanticMap&);
using AddOptions = void (*)(CLI::App&, MapQuestion&);

void addQuestion(CLI::App& ask, const char* name, const char* help, Answer answer, AddOptions addOptions) {
  const auto arguments = std::make_shared<AskArguments>();
  CLI::App* verb = ask.add_subcommand(name, help);
  addDatabase(*verb, arguments->database);
  addChoice(*verb, arguments->choice);
  addOptions(*verb, arguments->question);
  addJson(*verb, arguments->question);
  verb->callback([arguments, answer] {
    answer(arguments->question, fleet::readNewestMap(arguments->database, arguments->choice));
  });
}

void addAsk(CLI::App& command) {
  CLI::App* ask = command.add_subcommand("ask", "Ask the newest map of a storey, as wardslam map does a file");
  ask->require_subcommand(1);
  addQuestion(*ask, "objects", "The things in the map", answerObjects, addObjectsOptions);
  addQuestion(*ask, "nearest", "The nearest thing of a class", answerNearest, addNearestOptions);
  addQuestion(*ask, "at", "What is at a point: things, zones, floor", answerPlace, addPlaceOptions);
  addQuestion(*ask, "zones", "The zones and what stands in them", answerZones, [](CLI::App&, MapQuestion&) {});
  addQuestion(*ask, "rooms", "The rooms of the floor plan and the doors between them", answerRooms, addRoomsOptions);
}

void addInit(CLI::App& command) {
  const auto database = std::make_shared<std::string>();
  CLI::App* verb = command.add_subcommand("init", "Make the tables, or bring those of an older version up to date");
  addDatabase(*verb, *database);
  verb->callback([database] { init(*database); });
}

void addPush(CLI::App& command) {
  const auto arguments = std::make_shared<PushArguments>();
  CLI::App* verb = command.add_subcommand("push", "Send what is new in a map, once, however often it is repeated");
  verb->add_option("FILE", arguments->file, "a map (.wardmap)")->required();
  addDatabase(*verb, arguments->database);
  verb->add_option("--robot", arguments->identity.robot, "whose map it is")->required();
  verb->add_option("--name", arguments->identity.name, "name of the map among those of the robot; else the file's");
  verb->add_option("--site", arguments->identity.site, "the building")->capture_default_str();
  verb->add_option("--storey", arguments->identity.storey, "the storey")->capture_default_str();
  verb->add_option("--pose", arguments->pose,
                   "x y z qx qy qz qw: takes points of the map into the frame of the storey (see wardslam map align)")
      ->expected(7);
  verb->add_option("--patience", arguments->patience_s, "seconds for which a connection that broke off is tried again")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb->add_flag("--json", arguments->json, "print JSON instead of text");
  verb->callback([arguments] { push(*arguments); });
}

void addPull(CLI::App& command) {
  const auto arguments = std::make_shared<PullArguments>();
  CLI::App* verb = command.add_subcommand("pull", "Get the file of the newest map, to localise in");
  addDatabase(*verb, arguments->database);
  verb->add_option("-o,--out", arguments->out, "the file to write (.wardmap)")->required();
  addChoice(*verb, arguments->choice);
  verb->add_flag("--json", arguments->json, "print JSON instead of text");
  verb->callback([arguments] { pull(*arguments); });
}

}  // namespace

void addFleetCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("fleet", "The database of a hospital's robots: PostgreSQL with PostGIS");
  command->require_subcommand(1);
  addInit(*command);
  addPush(*command);
  addPull(*command);
  addAsk(*command);
  addFleetHistoryCommands(*command);
}

}  // namespace wardslam::apps
