#include "gates/object_truth.h"

#include <cstdint>
#include <fstream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <stdexcept>

#include "wardslam/evaluation/absolute_trajectory_error.h"
#include "wardslam/evaluation/object_files.h"

namespace wardslam::gates {
namespace fs = std::filesystem;
namespace {

constexpr double kSamePlace = 0.5;  ///< Part of a box that lies in another.

struct Visibility {
  int frames = 0;
  int maxPixels = 0;
};

std::map<int, Visibility> visibilities(const fs::path& instances) {
  std::map<int, Visibility> all;
  for (const auto& file : fs::directory_iterator(instances)) {
    const cv::Mat ids = cv::imread(file.path().string(), cv::IMREAD_UNCHANGED);
    if (ids.type() != CV_16UC1) throw std::runtime_error(file.path().string() + ": no image of instances");
    std::map<int, int> pixels;
    for (auto id = ids.begin<std::uint16_t>(); id != ids.end<std::uint16_t>(); ++id) ++pixels[*id];
    for (const auto& [id, count] : pixels) {
      ++all[id].frames;
      all[id].maxPixels = std::max(all[id].maxPixels, count);
    }
  }
  return all;
}

/// objects.csv with the columns the evaluation wants and rawlog-synth does not write.
void writeWithVisibility(const fs::path& labels, const fs::path& file) {
  const auto seen = visibilities(labels / "instances");
  std::ifstream in(labels / "objects.csv");
  std::ofstream out(file);
  std::string line;
  std::getline(in, line);
  out << line << ",frames_visible,max_pixels\n";
  while (std::getline(in, line)) {
    const auto visibility = seen.find(std::stoi(line));  // its first column
    const Visibility how = visibility == seen.end() ? Visibility{} : visibility->second;
    out << line << "," << how.frames << "," << how.maxPixels << "\n";
  }
}

double partInside(const Eigen::AlignedBox3d& box, const Eigen::AlignedBox3d& other) {
  const Eigen::AlignedBox3d shared = box.intersection(other);
  return shared.isEmpty() || box.volume() <= 0 ? 0.0 : shared.volume() / box.volume();
}

std::string text(const evaluation::FoundObject& found) {
  std::ostringstream out;
  out << "#" << found.id << " " << found.className << " at " << found.centroid_m.transpose();
  return out.str();
}

}  // namespace

std::vector<evaluation::TrueObject> trueObjects(const Rendering& rendering) {
  const fs::path file = rendering.labels() / "objects_seen.csv";
  writeWithVisibility(rendering.labels(), file);
  return evaluation::readTrueObjects(file);
}

std::vector<evaluation::FoundObject> foundObjects(const Rendering& rendering, const Run& run) {
  const auto alignment = evaluation::absoluteTrajectoryError(rendering.truth(), run.trajectory());
  return evaluation::transformed(evaluation::readFoundObjects(run.out / "objects.json"),
                                 alignment.T_groundtruth_estimate);
}

IdentityFaults identityFaults(const std::vector<evaluation::TrueObject>& truth,
                              const std::vector<evaluation::FoundObject>& found) {
  const auto matches = evaluation::evaluateObjects(truth, found, kSeenWell).matches;
  std::map<std::size_t, std::size_t> truthOf;
  for (const auto& [t, f] : matches) truthOf[f] = t;
  IdentityFaults faults;
  for (std::size_t f = 0; f < found.size(); ++f) {
    int whole = 0;
    for (const auto& thing : truth) {
      if (thing.classId == found[f].classId && partInside(thing.box_m, found[f].box_m) > kSamePlace) ++whole;
    }
    if (whole > 1) faults.oneRecordOfTwoThings.push_back(text(found[f]));
    if (truthOf.count(f) > 0) continue;
    for (const auto& thing : truth) {
      if (partInside(found[f].box_m, thing.box_m) < kSamePlace) continue;
      auto& list = thing.classId == found[f].classId ? faults.twoRecordsOfOneThing : faults.ofAnotherClass;
      list.push_back(text(found[f]) + " in " + thing.name);
    }
  }
  return faults;
}

}  // namespace wardslam::gates
