#include "folder_camera.h"

#include <fstream>
#include <optional>
#include <regex>
#include <string>

#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;

std::string leadingComments(const fs::path& list) {
  std::ifstream in(list);
  std::string comments;
  for (std::string line; std::getline(in, line) && !line.empty() && line.front() == '#';) comments += line + "\n";
  return comments;
}

/// '1', '2' or '3' where the text names a recording of the benchmark.
std::optional<std::string> tumCameraNumber(const std::string& text, const std::regex& name) {
  std::smatch match;
  if (!std::regex_search(text, match, name)) return std::nullopt;
  return match[1].str();
}

struct TumCamera {
  std::string number;
  std::string reason;
};

std::optional<TumCamera> tumCameraOf(const fs::path& folder) {
  static const std::regex kFolderName("^rgbd_dataset_freiburg([123])(?![0-9])");
  static const std::regex kRemark("rgbd_dataset_freiburg([123])(?![0-9])");
  const std::string name = fs::canonical(folder).filename().string();
  if (const auto number = tumCameraNumber(name, kFolderName)) return TumCamera{*number, "the folder's name"};
  for (const char* list : {"rgb.txt", "depth.txt", "groundtruth.txt"}) {
    const auto number = tumCameraNumber(leadingComments(folder / list), kRemark);
    if (number) return TumCamera{*number, std::string("the comment in ") + list};
  }
  return std::nullopt;
}

}  // namespace

FolderCamera chooseFolderCamera(const fs::path& folder, const SourceOptions& options) {
  FolderCamera chosen;
  if (options.camera) {
    chosen.file = *options.camera;
  } else if (fs::exists(folder / "camera.yaml")) {
    chosen.file = folder / "camera.yaml";
  } else if (fs::exists(folder / "calibration.txt")) {
    chosen.file = folder / "calibration.txt";  // of ETH3D
  } else if (const auto tum = tumCameraOf(folder)) {
    chosen.file = core::findDataFile("cameras/tum_freiburg" + tum->number + ".yaml");
    options.note(folder.string() + ": the camera is taken to be TUM's freiburg" + tum->number + ", as " + tum->reason +
                 " says");
  } else {
    throw core::InputError(
        folder.string() +
        ": the camera is not known: there is neither camera.yaml nor calibration.txt, and neither is the " +
        "folder called rgbd_dataset_freiburgN nor does a comment in its lists name such a " +
        "recording; give --camera with one of " + listCameraFiles() + " or a file like these");
  }
  chosen.camera = readRgbdCamera(chosen.file, options.note);
  if (options.depth_units_per_m) chosen.camera.depth_units_per_m = *options.depth_units_per_m;
  return chosen;
}

}  // namespace wardslam::sources
