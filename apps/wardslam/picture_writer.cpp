#include "picture_writer.h"

#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <utility>

#include "wardslam/core/errors.h"
#include "wardslam/viewer/annotated_picture.h"

namespace wardslam::apps {

PictureWriter::PictureWriter(std::filesystem::path folder, std::size_t interval, const core::LabelSpace& labels)
    : folder_(std::move(folder)), interval_(interval), labels_(labels) {}

void PictureWriter::onFrame(const core::Frame& frame, const odometry::OdometryResult& /*odometry*/) {
  if (interval_ == 0 || frame.index % interval_ != 0) return;
  std::filesystem::create_directories(folder_);
  char name[32];
  std::snprintf(name, sizeof(name), "%.6f.jpg", frame.stamp_s);
  const auto file = folder_ / name;
  if (!cv::imwrite(file.string(), viewer::drawAnnotated(frame, labels_))) {
    throw core::InputError(file.string() + ": cannot be written; is the disk full?");
  }
}

}  // namespace wardslam::apps
