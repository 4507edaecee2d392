#include "tum_folder_source.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <fstream>
#include <regex>

#include "image_file.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/sources/input_damage.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservation3DRangeScan;

std::string leadingComments(const fs::path& list) {
  std::ifstream in(list);
  std::string comments;
  for (std::string line; std::getline(in, line) && !line.empty() && line.front() == '#';) comments += line + "\n";
  return comments;
}

/// '1', '2' or '3' where the text names one of the benchmark's cameras.
std::optional<std::string> tumCameraNumber(const std::string& text) {
  static const std::regex kName("(^|[^a-z])(freiburg|fr)([123])", std::regex::icase);
  std::smatch match;
  if (!std::regex_search(text, match, kName)) return std::nullopt;
  return match[3].str();
}

RgbdCamera chooseCamera(const fs::path& folder, const SourceOptions& options) {
  if (options.camera) return readRgbdCamera(*options.camera);
  if (fs::exists(folder / "camera.yaml")) return readRgbdCamera(folder / "camera.yaml");
  const std::string folderName = fs::canonical(folder).filename().string();
  auto number = tumCameraNumber(folderName);
  if (!number) number = tumCameraNumber(leadingComments(folder / "rgb.txt"));
  if (number) return readRgbdCamera(core::findDataFile("cameras/tum_freiburg" + *number + ".yaml"));
  throw core::InputError(
      folder.string() + ": the camera is not known: there is no camera.yaml, and the name does not " +
      "tell which TUM camera it was; give --camera with one of " + listCameraFiles() + " or a file like these");
}

std::string sizeOf(int width_px, int height_px) { return std::to_string(width_px) + "x" + std::to_string(height_px); }

void requireSizes(const cv::Mat& color, const cv::Mat& depth, const core::CameraModel& camera, const ImagePair& pair) {
  if (color.cols != camera.width_px || color.rows != camera.height_px) {
    throw InputDamage("sources.image_size", pair.color.file.string() + " has " + sizeOf(color.cols, color.rows) +
                                                " pixels but the camera " + sizeOf(camera.width_px, camera.height_px));
  }
  if (depth.size() != color.size()) {
    throw InputDamage("sources.depth_size", pair.depth.file.string() + " has " + sizeOf(depth.cols, depth.rows) +
                                                " pixels but its colour image " + sizeOf(color.cols, color.rows));
  }
}

}  // namespace

TumFolderSource::TumFolderSource(const fs::path& folder, const SourceOptions& options)
    : folder_(folder),
      pairs_(listImagePairs(folder)),
      camera_(chooseCamera(folder, options)),
      damage_(std::make_unique<DamageLog>(options.warn)) {}

TumFolderSource::~TumFolderSource() = default;

std::shared_ptr<CObservation3DRangeScan> TumFolderSource::next() {
  while (nextPair_ < pairs_.size()) {
    const ImagePair& pair = pairs_[nextPair_++];
    try {
      return read(pair);
    } catch (const InputDamage& damage) {
      damage_->add(damage.event(), pair.list.string() + ":" + std::to_string(pair.line) + ": " + damage.what() +
                                       "; the pair is left out, as are others like it: fetch the sequence again or " +
                                       "take them off the list");
    }
  }
  return nullptr;
}

const core::EventCounts& TumFolderSource::damage() const { return damage_->counts(); }

std::shared_ptr<CObservation3DRangeScan> TumFolderSource::read(const ImagePair& pair) const {
  const cv::Mat color = readColorImage(folder_ / pair.color.file);
  const cv::Mat depth = readDepthImage(folder_ / pair.depth.file);
  requireSizes(color, depth, camera_.color, pair);

  auto observation = CObservation3DRangeScan::Create();
  observation->timestamp = core::toMrptTime(pair.color.stamp_s);
  observation->sensorLabel = "RGBD";
  // One view point for both images is what relativePoseIntensityWRTDepth says by default.
  observation->cameraParams = observation->cameraParamsIntensity = core::toMrpt(camera_.color);

  observation->hasIntensityImage = true;
  observation->intensityImage = mrpt::img::CImage(color, mrpt::img::SHALLOW_COPY);

  observation->hasRangeImage = true;
  observation->range_is_depth = true;
  observation->rangeUnits = static_cast<float>(1.0 / camera_.depth_units_per_m);
  observation->rangeImage_setSize(depth.rows, depth.cols);
  depth.copyTo(cv::Mat(depth.size(), CV_16UC1, observation->rangeImage.data()));
  return observation;
}

}  // namespace wardslam::sources
