#include "map_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "answer.h"
#include "map_export_command.h"
#include "map_merge_command.h"
#include "map_questions.h"
#include "map_report.h"
#include "map_rooms.h"
#include "map_view_command.h"
#include "stored_map.h"
#include "wardslam/core/errors.h"
#include "wardslam/query/map_difference.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::apps {
namespace {

using storage::CloudPart;
using storage::MapFile;

struct MapArguments {
  std::filesystem::path file;
  std::filesystem::path other;
  MapQuestion question;
};

void info(const MapArguments& arguments) {
  const auto info = MapFile::open(arguments.file).info();
  const auto plan = readStoredMap(arguments.file, CloudPart::LeaveOut).floorPlan;
  show(arguments.question.json, toJson(info, plan), [&](std::ostream& out) { print(out, info, plan); });
}

/// Reads the map and asks it.
template <void (*answer)(const MapQuestion&, const mapping::SemanticMap&)>
void ask(const MapArguments& arguments) {
  answer(arguments.question, readStoredMap(arguments.file, CloudPart::LeaveOut));
}

/// Whether both maps can be asked for places.
bool haveKeyPoints(const MapArguments& arguments) {
  return MapFile::open(arguments.file).info().trackingPoints > 0 &&
         MapFile::open(arguments.other).info().trackingPoints > 0;
}

/// Maps of runs that knew nothing of each other have frames of their own: the places that both show tell how these lie.
void bringIntoOneFrame(const MapArguments& arguments, mapping::SemanticMap& after) {
  if (!haveKeyPoints(arguments)) return;
  const auto alignment = alignWithProgress(arguments.file, arguments.other, {});
  if (!alignment) {
    std::cerr << "wardslam: no place of " << arguments.file.string() << " is found in " << arguments.other.string()
              << ": they are compared as if they had one frame\n";
  } else if (!alignment->haveOneFrame) {
    for (auto& [id, object] : after.objects) query::moveObject(object, alignment->T_a_b);
  }
}

void diff(const MapArguments& arguments) {
  const auto before = readStoredMap(arguments.file, CloudPart::LeaveOut);
  auto after = readStoredMap(arguments.other, CloudPart::LeaveOut);
  bringIntoOneFrame(arguments, after);
  const auto difference = query::difference(before, after);
  show(arguments.question.json, toJson(difference, after.labels),
       [&](std::ostream& out) { print(out, difference, after.labels); });
}

void check(const MapArguments& arguments) {
  const auto problems = MapFile::open(arguments.file).check();
  show(arguments.question.json, {{"sound", problems.empty()}, {"problems", problems}}, [&](std::ostream& out) {
    for (const auto& problem : problems) out << problem << "\n";
    if (problems.empty()) out << arguments.file.string() << ": sound\n";
  });
  if (problems.empty()) return;
  throw core::InputError(arguments.file.string() + ": is damaged (" + problems.front() + ")");
}

CLI::App* addVerb(CLI::App& command, const char* name, const char* help, void (*run)(const MapArguments&),
                  const std::shared_ptr<MapArguments>& arguments) {
  CLI::App* verb = command.add_subcommand(name, help);
  verb->add_option("FILE", arguments->file, "a map (.wardmap)")->required();
  addJson(*verb, arguments->question);
  verb->callback([arguments, run] { run(*arguments); });
  return verb;
}

}  // namespace

void addMapCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("map", "Ask a saved map what stands where");
  command->require_subcommand(1);
  const auto arguments = std::make_shared<MapArguments>();

  addVerb(*command, "info", "How much the map holds", info, arguments);

  auto& question = arguments->question;
  addObjectsOptions(*addVerb(*command, "objects", "The things in the map", ask<answerObjects>, arguments), question);
  addNearestOptions(*addVerb(*command, "nearest", "The nearest thing of a class", ask<answerNearest>, arguments),
                    question);
  addPlaceOptions(*addVerb(*command, "at", "What is at a point: things, zones, floor", ask<answerPlace>, arguments),
                  question);
  addVerb(*command, "zones", "The zones and what stands in them", ask<answerZones>, arguments);
  addVerb(*command, "diff", "What moved, is gone or is new from FILE to OTHER, two maps of one place", diff, arguments)
      ->add_option("OTHER", arguments->other,
                   "the later map (.wardmap); where its frame is another, the places that both show tell how it lies")
      ->required();
  addRoomsOptions(*addVerb(*command, "rooms", "The rooms of the floor plan and the doors between them",
                           ask<answerRooms>, arguments),
                  question);
  addMapMergeCommands(*command);
  addMapExportCommand(*command);
  addMapViewCommand(*command);
  addVerb(*command, "check", "Whether the whole file can be read and holds together", check, arguments);
}

}  // namespace wardslam::apps
