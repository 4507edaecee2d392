#include "picture_writer.h"

#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <utility>
#include <vector>

#include "wardslam/core/errors.h"
#include "wardslam/core/people.h"
#include "wardslam/viewer/annotated_picture.h"

namespace wardslam::apps {
namespace {

/// What a run calls a picture: "1305031102.175304.jpg".
bool isNameOfPicture(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  return file.extension() == ".jpg" && stem.find_first_not_of("-.0123456789") == std::string::npos;
}

void makeWithoutPictures(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::vector<std::filesystem::path> old;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (isNameOfPicture(entry.path())) old.push_back(entry.path());
  }
  for (const auto& file : old) std::filesystem::remove(file);
}

}  // namespace

PictureWriter::PictureWriter(std::filesystem::path folder, const PictureOptions& options,
                             const core::LabelSpace& labels)
    : folder_(std::move(folder)), options_(options), labels_(labels) {}

void PictureWriter::onFrame(const core::Frame& frame, const odometry::OdometryResult& /*odometry*/) {
  if (options_.interval == 0 || frame.index % options_.interval != 0) return;
  if (!std::exchange(hasFolder_, true)) makeWithoutPictures(folder_);
  char name[32];
  std::snprintf(name, sizeof(name), "%.6f.jpg", frame.stamp_s - stampOrigin_s_);
  const auto file = folder_ / name;
  core::Frame shown = frame;
  if (!options_.keepsPeople) shown.color_bgr = core::blanked(frame.color_bgr, core::peoplePixels(frame));
  if (!cv::imwrite(file.string(), viewer::drawAnnotated(shown, labels_))) {
    throw core::InputError(file.string() + ": cannot be written; is the disk full?");
  }
}

}  // namespace wardslam::apps
