#include "bug_report.h"

#include <fstream>
#include <iterator>
#include <sstream>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/pipeline/slam_options.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
  std::ifstream in(file);
  if (!in) return "(not there)\n";
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string describeMap(const fs::path& file) {
  if (!fs::exists(file)) return "(not there)\n";
  std::ostringstream text;
  try {
    const auto map = storage::MapFile::open(file);
    const auto info = map.info();
    text << "schema: " << info.schemaVersion << "\nbytes: " << info.size_bytes << "\nkeyframes: " << info.keyframes
         << "\npieces: " << info.pieces << "\ntracking points: " << info.trackingPoints << "\nloops: " << info.loops
         << "\ncloud points: " << info.cloudPoints << "\nobjects: " << info.objects << "\nzones: " << info.zones
         << "\n";
    for (const auto& problem : map.check()) text << "damaged: " << problem << "\n";
  } catch (const core::InputError& error) {
    text << "does not open: " << fs::path(error.what()).filename().string() << "\n";
  }
  return text.str();
}

}  // namespace

void writeBugReport(const fs::path& file, const Findings& findings, const fs::path& run) {
  std::ostringstream text;
  text << "WardSLAM: report of a fault\n\nNo pictures, no map and no way of the camera are in here; read it before you "
          "send it.\n\nWhat I did:\n\nWhat I expected:\n\nWhat happened (with all that was told):\n\n## Computer\n";
  for (const auto& [kind, subject, text_] : findings) {
    text << (kind == Finding::Kind::Good   ? ""
             : kind == Finding::Kind::Note ? "note: "
                                           : "TROUBLE: ")
         << subject << ": " << text_ << "\n";
  }
  if (!run.empty()) {
    text << "\n## summary.json\n" << textOf(run / "summary.json");
    text << "\n## config.yaml\n" << textOf(run / "config.yaml");
    text << "\n## map.wardmap\n" << describeMap(run / "map.wardmap");
  }
  core::writeFileAtomically(file, pipeline::withoutFolders(text.str()));
}

}  // namespace wardslam::apps
