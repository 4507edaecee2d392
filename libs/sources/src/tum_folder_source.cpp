#include "tum_folder_source.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cstdlib>
#include <limits>

#include "image_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/sources/input_damage.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservation3DRangeScan;

/// Half a millimetre: up to 32.7 m fit into the 16 bits of an observation.
constexpr double kUnitsOfFloatDepth_per_m = 2000.0;
constexpr double kLargestUnit = std::numeric_limits<std::uint16_t>::max();

std::string sizeOf(int width_px, int height_px) { return std::to_string(width_px) + "x" + std::to_string(height_px); }

void requireSizes(const cv::Mat& color, const cv::Mat& depth, const FolderCamera& camera, const ImagePair& pair) {
  const core::CameraModel& model = camera.camera.color;
  if (color.cols != model.width_px || color.rows != model.height_px) {
    throw InputDamage("sources.image_size", pair.color.file.string() + " has " + sizeOf(color.cols, color.rows) +
                                                " pixels but the camera " + sizeOf(model.width_px, model.height_px) +
                                                " (" + camera.file.string() + "); give --camera with the calibration " +
                                                "of images of " + sizeOf(color.cols, color.rows));
  }
  if (depth.size() != color.size()) {
    throw InputDamage("sources.depth_size", pair.depth.file.string() + " has " + sizeOf(depth.cols, depth.rows) +
                                                " pixels but its colour image " + sizeOf(color.cols, color.rows) +
                                                "; register the depth images to the colour images, or scale one to " +
                                                "the size of the other (depth by the nearest pixel)");
  }
}

/// OpenCV reads EXR only where this is set before the first such image.
void allowOpenExr(const std::vector<ImagePair>& pairs) {
  if (pairs.front().depth.file.extension() == ".exr") setenv("OPENCV_IO_ENABLE_OPENEXR", "1", 0);
}

/// A floating-point image tells metres, whatever is said of the unit of whole numbers.
void requireMetres(const cv::Mat& depth, const fs::path& file, bool isFactorGiven) {
  if (isFactorGiven) {
    throw InputDamage("sources.depth_format",
                      file.string() + " is of floating-point numbers, which are taken in metres and not in " +
                          "units of --depth-factor; leave that out, or save 16-bit images");
  }
  constexpr double kNothing_m = 1e30;  // what writers put where nothing was measured
  constexpr double kFarthest_m = kLargestUnit / kUnitsOfFloatDepth_per_m;
  const int measured = cv::countNonZero((depth > 0.0) & (depth < kNothing_m));
  if (2 * cv::countNonZero((depth > kFarthest_m) & (depth < kNothing_m)) <= measured) return;
  throw InputDamage("sources.depth_format",
                    file.string() +
                        " is of floating-point numbers, which are taken in metres, and most are above 32; " +
                        "where they are millimetres, divide them by 1000, or save 16-bit images of millimetres");
}

/// 16 bits of what was measured, 0 where nothing was; never wraps.
cv::Mat inUnits(const cv::Mat& depth, double unitsPerMetre) {
  cv::Mat units;
  if (depth.type() == CV_32FC1) {
    cv::Mat measured = depth > 0.0;
    measured.setTo(0, depth * unitsPerMetre >= kLargestUnit);  // also infinity; NaN is not above 0
    cv::Mat known(depth.size(), CV_32FC1, cv::Scalar(0));
    depth.copyTo(known, measured);
    known.convertTo(units, CV_16U, unitsPerMetre);
    return units;
  }
  units = depth;
  units.setTo(0, depth == kLargestUnit);
  return units;
}

/// Without images nobody need look for a camera.
FolderCamera cameraOf(const fs::path& folder, const SourceOptions& options) {
  requireImages(folder);
  return chooseFolderCamera(folder, options);
}

}  // namespace

TumFolderSource::TumFolderSource(const fs::path& folder, const SourceOptions& options)
    : folder_(folder),
      note_(options.note),
      camera_(cameraOf(folder, options)),
      isFactorGiven_(options.depth_units_per_m.has_value()),
      pairs_(listImagePairs(folder, {camera_.camera.rate_hz, options.note})),
      damage_(std::make_unique<DamageLog>(options.warn)) {
  allowOpenExr(pairs_);
  requireDepthUnit();
  takeSizeFromImages();
}

TumFolderSource::~TumFolderSource() = default;

void TumFolderSource::requireDepthUnit() const {
  if (camera_.camera.depth_units_per_m > 0.0 || isFloatImageName(pairs_.front().depth.file)) return;
  throw core::InputError(camera_.file.string() + ": does not say how many units of the depth images are a metre; add " +
                         "'depth_factor: 1000' for millimetres (RealSense, Azure Kinect, Orbbec) or " +
                         "'depth_factor: 5000' for the TUM benchmark's, or give --depth-factor N");
}

void TumFolderSource::takeSizeFromImages() {
  core::CameraModel& model = camera_.camera.color;
  if (model.width_px > 0) return;
  for (const ImagePair& pair : pairs_) {
    try {
      const cv::Mat image = readColorImage(folder_ / pair.color.file);
      model.width_px = image.cols;
      model.height_px = image.rows;
      break;
    } catch (const InputDamage&) {
      continue;  // met again, and told of, by next()
    }
  }
  note_(camera_.file.string() + ": does not tell the size of the images it is for; it is taken to be theirs, " +
        sizeOf(model.width_px, model.height_px));
  if (model.cx_px < model.width_px && model.cy_px < model.height_px) return;
  throw core::InputError(camera_.file.string() +
                         ": the principal point lies outside the images; give the calibration " + "of images of " +
                         sizeOf(model.width_px, model.height_px) + " pixels");
}

std::shared_ptr<CObservation3DRangeScan> TumFolderSource::next() {
  while (nextPair_ < pairs_.size()) {
    const ImagePair& pair = pairs_[nextPair_++];
    try {
      auto scan = read(pair);
      mayStop_ = false;
      if (const auto sentence = scaleCheck_.add(*scan)) note_(folder_.string() + ": " + *sentence);
      return scan;
    } catch (const InputDamage& damage) {
      const std::string where = pair.line > 0 ? pair.list.string() + ":" + std::to_string(pair.line) : folder_.string();
      damage_->add(damage.event(), where + ": " + damage.what() +
                                       "; the pair is left out, as are others like it: fetch the sequence again or " +
                                       "take them off the list");
      stopIfAllFail(damage, where);
    }
  }
  return nullptr;
}

void TumFolderSource::stopIfAllFail(const InputDamage& damage, const std::string& where) {
  if (nextPair_ == 1) failingAlike_ = damage.event();
  mayStop_ = mayStop_ && failingAlike_ == damage.event();
  if (!mayStop_ || nextPair_ < kPatience) return;
  nextPair_ = pairs_.size();
  throw core::InputError(where + ": " + damage.what() + "; so it is with all of the first " +
                         std::to_string(kPatience) + " pairs, and nothing was tracked");
}

const core::EventCounts& TumFolderSource::damage() const { return damage_->counts(); }

std::shared_ptr<CObservation3DRangeScan> TumFolderSource::read(const ImagePair& pair) const {
  const cv::Mat color = readColorImage(folder_ / pair.color.file);
  const cv::Mat depth = readDepthImage(folder_ / pair.depth.file);
  requireSizes(color, depth, camera_, pair);
  const RgbdCamera& camera = camera_.camera;
  if (depth.type() == CV_32FC1) requireMetres(depth, pair.depth.file, isFactorGiven_);
  const double unitsPerMetre = depth.type() == CV_32FC1 ? kUnitsOfFloatDepth_per_m : camera.depth_units_per_m;
  if (!(unitsPerMetre > 0.0)) {
    throw InputDamage("sources.depth_format",
                      pair.depth.file.string() + " holds whole numbers, and nothing says how many are a metre; give " +
                          "--depth-factor 1000 for millimetres, 5000 for the TUM benchmark's unit");
  }

  auto observation = CObservation3DRangeScan::Create();
  observation->timestamp = core::toMrptTime(pair.color.stamp_s);
  observation->sensorLabel = "RGBD";
  // One view point for both images is what relativePoseIntensityWRTDepth says by default.
  observation->cameraParams = observation->cameraParamsIntensity = core::toMrpt(camera.color);

  observation->hasIntensityImage = true;
  observation->intensityImage = mrpt::img::CImage(color, mrpt::img::SHALLOW_COPY);

  observation->hasRangeImage = true;
  observation->range_is_depth = true;
  observation->rangeUnits = static_cast<float>(1.0 / unitsPerMetre);
  observation->rangeImage_setSize(depth.rows, depth.cols);
  inUnits(depth, unitsPerMetre).copyTo(cv::Mat(depth.size(), CV_16UC1, observation->rangeImage.data()));
  return observation;
}

}  // namespace wardslam::sources
