#include "tum_folder_writer.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <utility>

#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/options.h"

namespace wardslam::rawlog2tum {
namespace {

namespace fs = std::filesystem;
using recording::TumNotes;

/// What the largest number of an image stands for: nothing measured, or farther than it can say.
constexpr double kTooFar = 65535.0;

std::int64_t ticksOf(double stamp_s) { return core::toMrptTime(stamp_s).time_since_epoch().count(); }

std::string textOf(double stamp_s) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(6) << stamp_s;
  return text.str();
}

/// Images are written without loss, whatever they were read from.
std::string pngIn(const std::string& folder, const std::string& file) {
  return folder + "/" + fs::path(file).stem().string() + ".png";
}

/// Units per metre; the number meant where the one stored is rounded.
double unitsPerMetre(double rangeUnits_m) {
  const double units = 1.0 / rangeUnits_m;
  return std::abs(units - std::round(units)) < 1e-6 * units ? std::round(units) : units;
}

void writeImage(const fs::path& file, const cv::Mat& image) {
  if (!cv::imwrite(file.string(), image))
    throw core::InputError(file.string() + ": cannot be written; is the disk full?");
}

void writeText(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  if (!(out << text).flush()) throw core::InputError(file.string() + ": cannot be written; is the disk full?");
}

}  // namespace

TumFolderWriter::TumFolderWriter(fs::path folder, TumNotes notes)
    : folder_(std::move(folder)), partial_(folder_.string() + ".partial"), notes_(std::move(notes)) {
  if (fs::exists(folder_) && !(fs::is_directory(folder_) && fs::is_empty(folder_))) {
    throw core::InputError(folder_.string() + ": is there already; give another -o or remove it");
  }
  for (std::size_t i = 0; i < notes_.pairs.size(); ++i) noteAt_[ticksOf(std::stod(notes_.pairs[i].colorStamp))] = i;
  std::error_code error;
  fs::remove_all(partial_, error);
  for (const char* images : {"rgb", "depth"}) {
    fs::create_directories(partial_ / images, error);
    if (error) throw core::InputError(partial_.string() + ": cannot be made: " + error.message());
  }
}

TumFolderWriter::~TumFolderWriter() {
  std::error_code ignored;
  fs::remove_all(partial_, ignored);
}

void TumFolderWriter::write(const core::Frame& frame, double rangeUnits_m) {
  if (!camera_) {
    camera_.emplace();
    camera_->color = frame.camera;
    camera_->depth_units_per_m = unitsPerMetre(rangeUnits_m);
  }
  const TumNotes::Pair names = namesOf(frame);
  writeImage(partial_ / names.colorFile, frame.color_bgr);
  cv::Mat depth;
  frame.depth_m.convertTo(depth, CV_16U, camera_->depth_units_per_m);  // rounds, which undoes what floats cut off
  depth.setTo(0, depth == kTooFar);                                    // where it had to be cut off
  writeImage(partial_ / names.depthFile, depth);
  written_.push_back(names);
}

TumNotes::Pair TumFolderWriter::namesOf(const core::Frame& frame) const {
  const auto noted = noteAt_.find(ticksOf(frame.stamp_s));
  if (noted == noteAt_.end()) {
    const std::string stamp = textOf(frame.stamp_s);
    return {stamp, "rgb/" + stamp + ".png", stamp, "depth/" + stamp + ".png"};
  }
  const TumNotes::Pair& pair = notes_.pairs[noted->second];
  return {pair.colorStamp, pngIn("rgb", pair.colorFile), pair.depthStamp, pngIn("depth", pair.depthFile)};
}

void TumFolderWriter::commit() {
  writeLists();
  if (camera_) writeText(partial_ / "camera.yaml", core::writeOptions(*camera_));
  for (const auto& [name, text] : notes_.files) writeText(partial_ / name, text);
  std::error_code error;
  fs::remove(folder_, error);  // an empty one
  fs::rename(partial_, folder_, error);
  if (error) throw core::InputError(folder_.string() + ": cannot be made: " + error.message());
}

void TumFolderWriter::writeLists() const {
  std::string color = "# color images\n# timestamp filename\n";
  std::string depth = "# depth maps\n# timestamp filename\n";
  std::string both;
  for (const TumNotes::Pair& pair : written_) {
    color += pair.colorStamp + " " + pair.colorFile + "\n";
    depth += pair.depthStamp + " " + pair.depthFile + "\n";
    both += pair.colorStamp + " " + pair.colorFile + " " + pair.depthStamp + " " + pair.depthFile + "\n";
  }
  writeText(partial_ / "rgb.txt", color);
  writeText(partial_ / "depth.txt", depth);
  writeText(partial_ / "associations.txt", both);
}

}  // namespace wardslam::rawlog2tum
