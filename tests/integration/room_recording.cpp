#include "room_recording.h"

#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "support/textured_room.h"

namespace wardslam::test {
namespace {

namespace fs = std::filesystem;

std::string stampText(double start_s, int listing) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6f", start_s + listing / 32.0);
  return text;
}

std::string colorName(int image) { return "rgb/" + std::to_string(image) + ".png"; }
std::string depthName(int image) { return "depth/" + std::to_string(image) + ".png"; }

/// 0 1 2 … last … 2 1 0 1 …
int backAndForth(int listing, int images) {
  const int period = 2 * (images - 1);
  const int phase = listing % period;
  return phase < images ? phase : period - phase;
}

void writeImage(const fs::path& file, const cv::Mat& image) {
  fs::create_directories(file.parent_path());
  if (!cv::imwrite(file.string(), image)) throw std::runtime_error("cannot write " + file.string());
}

std::string poseLine(const std::string& stampText, const Eigen::Isometry3d& T) {
  const Eigen::Quaterniond q(T.linear());
  char text[256];
  std::snprintf(text, sizeof text, "%s %.9f %.9f %.9f %.9f %.9f %.9f %.9f\n", stampText.c_str(), T.translation().x(),
                T.translation().y(), T.translation().z(), q.x(), q.y(), q.z(), q.w());
  return text;
}

}  // namespace

RoomRecording::RoomRecording(int images, int listed, double start_s, std::uint64_t seed) {
  const auto stamp = [start_s](int listing) { return stampText(start_s, listing); };
  const TexturedRoom room(seed);
  for (int image = 0; image < images; ++image) {
    const auto view = room.look(TexturedRoom::T_room_cam(image));
    cv::Mat units;
    view.depth_m.convertTo(units, CV_16U, 5000.0);
    writeImage(color(image), view.color_bgr);
    writeImage(depth(image), units);
  }
  cv::Mat mask = cv::Mat::zeros(240, 320, CV_8UC1);
  mask(cv::Rect(0, 0, 80, 240)) = 1;

  std::string colorList;
  std::string depthList;
  std::string groundTruth;
  for (int i = 0; i < std::max(images, listed); ++i) {
    const int image = backAndForth(i, images);
    colorList += stamp(i) + " " + colorName(image) + "\n";
    depthList += stamp(i) + " " + depthName(image) + "\n";
    groundTruth += poseLine(stamp(i), TexturedRoom::T_room_cam(image));
    if (i < images) writeImage(masks() / (stamp(i) + ".png"), mask);
  }
  write("rgb.txt", colorList);
  write("depth.txt", depthList);
  write("groundtruth.txt", groundTruth);
  write("camera.yaml", "width: 320\nheight: 240\nfx: 262.5\nfy: 262.5\ncx: 159.5\ncy: 119.5\ndepth_factor: 5000\n");
}

fs::path RoomRecording::color(int image) const { return path() / colorName(image); }
fs::path RoomRecording::depth(int image) const { return path() / depthName(image); }

void cutOff(const fs::path& file, double part) {
  const auto size = static_cast<double>(fs::file_size(file));
  fs::resize_file(file, static_cast<std::uintmax_t>(part * size));
}

void shrinkImage(const fs::path& file) {
  cv::Mat image = cv::imread(file.string(), cv::IMREAD_UNCHANGED);
  cv::resize(image, image, {}, 0.5, 0.5, cv::INTER_NEAREST);
  writeImage(file, image);
}

}  // namespace wardslam::test
