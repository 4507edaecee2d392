// usage: measure_fleet push DATABASE FOLDER MAPS    ten robots push so many maps each, whatever becomes of the server
//        measure_fleet scale DATABASE FOLDER        fills the database with 100 robots, and asks it
//        measure_fleet ask DATABASE                 asks one that is full already
//
// push: two states of each map, at once, each again until it is there. The first of all is pushed before, by the robot
// `peace`. scale: each robot has a storey of 40 m by 40 m with 16 rooms, each of which is a zone, and 1000 things, and
// pushes ten states of its map an hour apart; all things have moved in each of them. Ten push at once. See
// measure_fleet.sh.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <iostream>
#include <random>
#include <thread>
#include <vector>

#include "wardslam/fleet/database.h"
#include "wardslam/fleet/history.h"
#include "wardslam/fleet/push.h"
#include "wardslam/storage/map_file.h"

namespace {

using namespace wardslam;

constexpr int kRobots = 100;
constexpr int kAtOnce = 10;
constexpr int kStates = 10;
constexpr int kThingsPerRow = 32;
constexpr int kThings = 1000;
constexpr double kBegin_s = 1.7e9;
constexpr double kHour_s = 3600.0;
constexpr core::ClassId kChair = 57;
constexpr int kQuestions = 1000;

/// Rooms of 10 m by 10 m with walls of 0.2 m, and a door of 1 m in the middle of each wall between them.
mapping::FloorPlan makePlan() {
  mapping::FloorPlan plan;
  plan.resolution_m = 0.05;
  plan.cells = cv::Mat(800, 800, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));
  for (int wall = 0; wall <= 800; wall += 200) {
    const cv::Range thick(std::max(0, wall - 2), std::min(800, wall + 2));
    plan.cells.rowRange(thick).setTo(mapping::FloorPlan::kOccupied);
    plan.cells.colRange(thick).setTo(mapping::FloorPlan::kOccupied);
  }
  for (int wall = 200; wall < 800; wall += 200) {
    for (int door = 90; door < 800; door += 200) {
      plan.cells(cv::Range(wall - 2, wall + 2), cv::Range(door, door + 20)).setTo(mapping::FloorPlan::kFree);
      plan.cells(cv::Range(door, door + 20), cv::Range(wall - 2, wall + 2)).setTo(mapping::FloorPlan::kFree);
    }
  }
  return plan;
}

std::string wardAt(double x_m, double y_m) {
  return "ward " + std::to_string(1 + static_cast<int>(x_m / 10.0) + 4 * static_cast<int>(y_m / 10.0));
}

void place(mapping::MapObject& thing, double x_m, double y_m) {
  const Eigen::Vector3d half_m(0.25, 0.25, 0.45);
  thing.centroid_m = {x_m, y_m, half_m.z()};
  thing.box_m = {thing.centroid_m - half_m, thing.centroid_m + half_m};
  thing.orientedBox.T_map_box.translation() = thing.centroid_m;
  thing.orientedBox.size_m = 2.0 * half_m;
  thing.zone = wardAt(x_m, y_m);
}

/// State 0 to kStates - 1 of a robot's map; each has 20 keyframes more.
mapping::SemanticMap makeMap(int robot, int state, int things) {
  mapping::SemanticMap map;
  map.floorPlan = makePlan();
  for (double y_m = 0.0; y_m < 40.0; y_m += 10.0) {
    for (double x_m = 0.0; x_m < 40.0; x_m += 10.0) {
      map.zones.push_back({wardAt(x_m, y_m), {{x_m, y_m}, {x_m + 10, y_m}, {x_m + 10, y_m + 10}, {x_m, y_m + 10}}});
    }
  }
  const double begin_s = kBegin_s + robot;  // no two robots have keyframes in common
  const double now_s = begin_s + state * kHour_s;
  for (int i = 0; i < 20 * (state + 1); ++i) {
    auto& keyframe = map.keyframes[static_cast<std::uint64_t>(i + 1)];
    keyframe.stamp_s = begin_s + (i / 20) * kHour_s + i % 20;
    keyframe.T_map_cam.translation() = Eigen::Vector3d(1.0 + i % 20, 2.0 + i / 20.0, 1.0);
  }
  for (int i = 0; i < things; ++i) {
    auto& thing = map.objects[static_cast<std::uint64_t>(i + 1)];
    thing.id = static_cast<mapping::ObjectId>(i + 1);
    thing.classId = kChair;
    thing.probability = 0.9;
    thing.firstSeen_s = begin_s;
    thing.lastSeen_s = now_s + 19.0;
    thing.views = state + 1;
    if (state > 0) thing.state = mapping::ObjectState::Moved;
    // From room to room and back, half of them.
    const double moved_m = state % 2 == 0 ? 0.0 : (i % 2 == 0 ? 0.6 : 4.0);
    place(thing, 1.0 + 1.05 * (i % kThingsPerRow) + moved_m, 1.0 + 1.15 * (i / kThingsPerRow));  // NOLINT
  }
  return map;
}

void write(const std::filesystem::path& file, const mapping::SemanticMap& map) {
  (void)storage::MapFile::create(file, {map.labels, ""}, storage::everythingOf(map));
}

using Clock = std::chrono::steady_clock;
double since_s(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

void tell(const std::string& what, std::vector<double> times_s) {
  std::sort(times_s.begin(), times_s.end());
  const auto at = [&](double part) {
    return 1000.0 * times_s[static_cast<std::size_t>(part * static_cast<double>(times_s.size() - 1))];
  };
  std::cout << what << ": median " << at(0.5) << " ms, 99th percentile " << at(0.99) << " ms, of " << times_s.size()
            << "\n";
}

fleet::MapIdentity identityOf(int robot) {
  return {"robot " + std::to_string(robot), "storey", "hospital " + std::to_string(robot / 10), "1"};
}

void fill(const std::string& url, const std::filesystem::path& folder) {
  std::vector<std::vector<double>> times_s(kAtOnce);
  std::vector<std::thread> threads;
  const auto begin = Clock::now();
  for (int thread = 0; thread < kAtOnce; ++thread) {
    threads.emplace_back([&, thread] {
      const auto file = folder / (std::to_string(thread) + ".wardmap");
      for (int state = 0; state < kStates; ++state) {
        for (int robot = thread; robot < kRobots; robot += kAtOnce) {
          write(file, makeMap(robot, state, kThings));
          const auto start = Clock::now();
          (void)fleet::push(url, identityOf(robot), file);
          times_s[static_cast<std::size_t>(thread)].push_back(since_s(start));
        }
      }
    });
  }
  for (auto& thread : threads) thread.join();
  const double all_s = since_s(begin);
  std::vector<double> together_s;
  for (const auto& times : times_s) together_s.insert(together_s.end(), times.begin(), times.end());
  const double sightings = static_cast<double>(together_s.size()) * kThings;
  std::cout << sightings << " sightings by " << together_s.size() << " pushes in " << all_s
            << " s: " << sightings / all_s << " a second\n";
  tell("a push", together_s);
}

/// As a robot does: again, until the database has it. Returns how often it broke off.
int pushUntilThere(const std::string& url, const fleet::MapIdentity& identity, const std::filesystem::path& file) {
  int brokeOff = 0;
  fleet::PushOptions options;
  options.note = [&](const std::string&) { ++brokeOff; };
  while (true) {
    try {
      (void)fleet::push(url, identity, file, options);
      return brokeOff;
    } catch (const fleet::CannotConnect&) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
}

void pushThroughKills(const std::string& url, const std::filesystem::path& folder, int maps) {
  const std::vector<std::filesystem::path> states{folder / "before.wardmap", folder / "after.wardmap"};
  for (std::size_t i = 0; i < states.size(); ++i) write(states[i], makeMap(0, static_cast<int>(i), 100));
  for (const auto& state : states) (void)fleet::push(url, {"peace", "map", "hospital", "1"}, state);
  std::cout << "begun" << std::endl;
  std::atomic<int> brokeOff = 0;
  std::vector<std::thread> threads;
  for (int robot = 0; robot < kAtOnce; ++robot) {
    threads.emplace_back([&, robot] {
      for (int map = 0; map < maps; ++map) {
        const fleet::MapIdentity identity{"robot " + std::to_string(robot), "map " + std::to_string(map), "hospital",
                                          "1"};
        for (const auto& state : states) brokeOff += pushUntilThere(url, identity, state);
      }
    });
  }
  for (auto& thread : threads) thread.join();
  std::cout << "pushes: " << 2 * kAtOnce * maps << ", of which broke off and were tried again: " << brokeOff << "\n";
}

template <class Question>
void ask(const std::string& what, int questions, const Question& question) {
  std::mt19937 random(1);
  std::vector<double> times_s;
  std::size_t found = 0;
  for (int i = 0; i < questions; ++i) {
    const auto number = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
    const auto begin = Clock::now();
    found += question(number);
    times_s.push_back(since_s(begin));
  }
  tell(what + " (" + std::to_string(found) + " found)", times_s);
}

void askAll(const std::string& url) {
  const auto choiceOf = [](int robot) {
    const auto identity = identityOf(robot);
    return fleet::MapChoice{identity.site, identity.storey, identity.robot, ""};
  };
  const auto storeyOf = [](int robot) { return fleet::MapChoice{identityOf(robot).site, "1", "", ""}; };
  const auto time_s = [](int state) { return kBegin_s + 200.0 + state * kHour_s; };
  ask("where was thing n of a robot", kQuestions, [&](const auto& number) {
    const int robot = number(kRobots);
    return fleet::whereWas(url, choiceOf(robot), "chair", static_cast<mapping::ObjectId>(1 + number(kThings)),
                           time_s(number(kStates)))
        .size();
  });
  ask("what stood within 2 m, ten robots' maps of a storey", kQuestions, [&](const auto& number) {
    const int robot = number(kRobots);
    return fleet::whatStood(url, storeyOf(robot), {1.0 + number(38), 1.0 + number(38), 0.5}, 2.0,
                            time_s(number(kStates)))
        .size();
  });
  ask("what left a ward in the last hour, a robot", kQuestions, [&](const auto& number) {
    const int robot = number(kRobots);
    return fleet::whatLeft(url, choiceOf(robot), "ward " + std::to_string(1 + number(16)), time_s(kStates - 2)).size();
  });
  ask("all things, zones and the floor of a map", kQuestions / 10, [&](const auto& number) {
    const int robot = number(kRobots);
    return fleet::readNewestMap(url, choiceOf(robot)).objects.size();
  });
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 4 && arguments[0] == "push") {
    pushThroughKills(arguments[1], arguments[2], std::stoi(arguments[3]));
  } else if (arguments.size() == 3 && arguments[0] == "scale") {
    fill(arguments[1], arguments[2]);
    askAll(arguments[1]);
  } else if (arguments.size() == 2 && arguments[0] == "ask") {
    askAll(arguments[1]);
  } else {
    throw std::runtime_error("usage: measure_fleet push DATABASE FOLDER MAPS | scale DATABASE FOLDER | ask DATABASE");
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
