#include "wardslam/sources/external_images.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationStereoImages.h>

#include <string>

#include "image_file.h"
#include "wardslam/sources/gzip_file.h"
#include "wardslam/sources/input_damage.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservation3DRangeScan;

/// MRPT writes little more than the matrix itself: its size and a few bytes of header.
constexpr std::uint64_t kMaxMatrixHeader_bytes = 64;

/// MRPT fills up a matrix from a file that was cut off without a word.
bool isCutOff(const fs::path& file, std::uint64_t matrix_bytes) {
  const std::uint64_t content_bytes = gzipContentSize(file).value_or(0);
  const auto holds = [&](std::uint64_t bytes) {
    return content_bytes >= bytes && content_bytes <= bytes + kMaxMatrixHeader_bytes;
  };
  return !holds(matrix_bytes) && !holds(2 * matrix_bytes);  // before version 2.0 MRPT wrote floating-point numbers
}

void load(const mrpt::obs::CObservation& observation) {
  try {
    observation.load();
  } catch (const std::exception&) {
    throw InputDamage("sources.image_unreadable", "an externally stored image cannot be read");
  }
}

void requireComplete(const mrpt::img::CImage& image) {
  if (image.isExternallyStored()) requireCompleteImage(image.getExternalStorageFileAbsolutePath());
}

}  // namespace

// CRawlog::detectImagesDirectory() of MRPT 2.5 loses the separator behind the folder's name and so finds none.
std::optional<fs::path> findImageFolder(const fs::path& rawlog) {
  const std::string stem = rawlog.stem().string();
  for (const std::string& name : {stem + "_Images", stem + "_images", stem + "_IMAGES", std::string("Images")}) {
    if (fs::is_directory(rawlog.parent_path() / name)) return fs::absolute(rawlog.parent_path() / name);
  }
  return std::nullopt;
}

void loadImages(const mrpt::obs::CObservationStereoImages& pair) {
  requireComplete(pair.imageLeft);
  if (pair.hasImageRight) requireComplete(pair.imageRight);
  load(pair);
}

void loadImages(const CObservation3DRangeScan& scan) {
  requireComplete(scan.intensityImage);
  const bool isRangeExternal = scan.rangeImage_isExternallyStored();
  const fs::path rangeFile = isRangeExternal ? scan.rangeImage_getExternalStorageFileAbsolutePath("") : "";
  if (isRangeExternal && !fs::exists(rangeFile)) {
    throw InputDamage("sources.image_missing", rangeFile.string() + " is missing");
  }
  load(scan);
  const std::uint64_t matrix_bytes = static_cast<std::uint64_t>(scan.rangeImage.size()) * sizeof(std::uint16_t);
  if (isRangeExternal && rangeFile.extension() == ".bin" && isCutOff(rangeFile, matrix_bytes)) {
    throw InputDamage("sources.image_truncated", rangeFile.string() + " is cut off before the end of the image");
  }
}

}  // namespace wardslam::sources
