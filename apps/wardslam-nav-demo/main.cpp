#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mission.h"
#include "run_picture.h"
#include "run_report.h"
#include "simulation.h"
#include "support/command_line.h"
#include "support/interruption.h"
#include "support/program.h"
#include "support/progress.h"
#include "truth.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/mapping/floor_planner.h"
#include "wardslam/mapping/zones.h"
#include "wardslam/storage/map_file.h"
#include "watch_window.h"

namespace {

using namespace wardslam;
namespace fs = std::filesystem;

struct Arguments {
  fs::path map;
  std::string target;
  fs::path truth;
  fs::path zones;
  std::vector<std::string> forbidden;
  std::vector<double> start;  ///< x y [yaw in degrees]
  std::uint32_t seed = 1;
  int runs = 1;
  fs::path picture;
  bool view = false;
  bool json = false;
  nav_demo::SimulationOptions simulation;
};

void declare(CLI::App& app, Arguments& a) {
  app.add_option("MAP", a.map, "a map (.wardmap) that wardslam run made")->required();
  app.add_option("--to", a.target, "where to: \"bed 2\" (the second bed of the map), or \"#11\" (by its id)")
      ->required();
  app.add_option("--truth", a.truth,
                 "FILE.rawlog of rawlog-synth the map was made from: the world to drive in is the scene it shows "
                 "(floor plan, objects and true camera path lie beside it); without, the world is what the map says");
  app.add_option("--forbid", a.forbidden, "zone of the map the robot may not enter; can be given several times");
  app.add_option("--zones", a.zones, "zones (YAML, map frame) in place of the map's");
  app.add_option("--start", a.start, "x y [yaw]: m and degrees, map frame; unless told where the map's run ended")
      ->expected(2, 3);
  app.add_option("--people", a.simulation.peopleCount, "how many walk about")
      ->check(CLI::Range(0, 20))
      ->capture_default_str();
  app.add_option("--seed", a.seed, "of the first run; the next ones count on")->capture_default_str();
  app.add_option("--runs", a.runs, "how often to deliver")->check(CLI::Range(1, 10000))->capture_default_str();
  app.add_option("--time-limit", a.simulation.timeLimit_s, "s, for each run")
      ->check(CLI::Range(1.0, 3600.0))
      ->capture_default_str();
  app.add_option("--picture", a.picture, "write the first run as a picture (.png or .jpg)");
  app.add_flag("--view", a.view, "watch in a window");
  app.add_flag("--json", a.json, "print JSON instead of a table");
}

/// A folder for the navigator's tables, gone at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "wardslam-nav-demo-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw core::InputError(name + ": cannot be created");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

nav_demo::Order orderOf(const Arguments& a) {
  constexpr double kDegToRad = M_PI / 180.0;
  nav_demo::Order order{a.target, a.forbidden, {}};
  if (!a.start.empty())
    order.start_map = Eigen::Vector3d(a.start[0], a.start[1], a.start.size() > 2 ? a.start[2] * kDegToRad : 0.0);
  return order;
}

void write(const cv::Mat& picture, const fs::path& file) {
  std::vector<unsigned char> bytes;
  const std::string extension = file.extension();
  if (extension != ".png" && extension != ".jpg" && extension != ".jpeg")
    throw core::InputError(file.string() + ": must end in .png or .jpg");
  cv::imencode(extension, picture, bytes);
  core::writeFileAtomically(file, std::string(bytes.begin(), bytes.end()));
}

int deliver(const Arguments& a) {
  auto map = storage::MapFile::open(a.map).read();
  if (map.floorPlan.cells.empty()) map.floorPlan = mapping::drawFloorPlan(map, {});  // of a run that was killed
  if (!a.zones.empty()) map.zones = mapping::Zones::fromFile(a.zones).all();
  const auto mission = nav_demo::planMission(map, orderOf(a), a.simulation.robot);
  const auto truth = a.truth.empty() ? nav_demo::truthFromMap(map) : nav_demo::readTruth(a.truth, map);

  std::optional<nav_demo::WatchWindow> window;
  if (a.view) window.emplace(map, mission, a.simulation);
  const TemporaryFolder cache;
  const apps::InterruptionGuard interruption;
  apps::Progress progress(std::cerr, apps::standardErrorIsTerminal(), "run", static_cast<std::size_t>(a.runs));
  std::vector<nav_demo::RunRecord> runs;
  for (int i = 0; i < a.runs && !interruption.requested(); ++i) {
    runs.push_back(nav_demo::simulate(mission, truth, a.simulation, a.seed + static_cast<std::uint32_t>(i),
                                      cache.path(), [&](const nav_demo::Moment& moment) {
                                        return !interruption.requested() && (!window || window->show(moment));
                                      }));
    progress.update(runs.size());
  }

  if (!a.picture.empty()) write(nav_demo::drawRun(map, mission, a.simulation, runs.front()), a.picture);
  if (a.json) {
    std::cout << nav_demo::toJson(runs, mission, truth).dump(2) << "\n";
  } else {
    nav_demo::print(std::cout, runs, mission, truth);
  }
  for (const auto& run : runs) {
    if (!run.isGood()) return apps::kFailure;
  }
  return apps::kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return apps::runProgram("wardslam-nav-demo", [&]() -> int {
    CLI::App app("A simulated robot delivers something in a mapped ward, among people who walk about",
                 "wardslam-nav-demo");
    app.set_version_flag("--version", "wardslam-nav-demo " WARDSLAM_VERSION);
    Arguments arguments;
    declare(app, arguments);
    if (const auto code = apps::parseCommandLine(app, argc, argv)) return *code;
    return deliver(arguments);
  });
}
