#pragma once

#include <filesystem>
#include <functional>
#include <iomanip>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <stdexcept>
#include <string>

#include "support/temporary_folder.h"

namespace wardslam::test {

/// A tiny TUM sequence: 32x24 pixels, 30 Hz, colour stamps from 100 s, depth 4 ms later, with a camera.yaml of its own.
class TumFolder {
 public:
  static constexpr int kWidth_px = 32;
  static constexpr int kHeight_px = 24;

  explicit TumFolder(int frames, const std::string& imageType = "png") {
    folder_.write("camera.yaml",
                  "width: 32\nheight: 24\nfx: 30\nfy: 31\ncx: 15.5\ncy: 11.5\nk1: 0.1\ndepth_factor: 5000\n");
    std::string colorList = "# color images\n# timestamp filename\n";
    std::string depthList = "# depth maps\n";
    for (int i = 0; i < frames; ++i) {
      writeImage(colorFile(i, imageType), colorImage(i));
      writeImage(depthFile(i), depthImage(i));
      colorList += stamp(colorStamp_s(i)) + " " + colorFile(i, imageType) + "\n";
      depthList += stamp(depthStamp_s(i)) + " " + depthFile(i) + "\n";
    }
    folder_.write("rgb.txt", colorList);
    folder_.write("depth.txt", depthList);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    return folder_.write(name, text);
  }
  void writeImage(const std::string& name, const cv::Mat& image) const {
    std::filesystem::create_directories((path() / name).parent_path());
    if (!cv::imwrite((path() / name).string(), image)) throw std::runtime_error("cannot write " + name);
  }

  static double colorStamp_s(int i) { return 100.0 + i / 32.0; }
  static double depthStamp_s(int i) { return colorStamp_s(i) + 0.004; }
  static std::string colorFile(int i, const std::string& type = "png") {
    return "rgb/" + std::to_string(i) + "." + type;
  }
  static std::string depthFile(int i) { return "depth/" + std::to_string(i) + ".png"; }
  static std::string stamp(double stamp_s) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(6) << stamp_s;
    return text.str();
  }

  /// Every pixel of every frame has its own colour.
  static cv::Mat colorImage(int i) {
    cv::Mat image(kHeight_px, kWidth_px, CV_8UC3);
    image.forEach<cv::Vec3b>([i](cv::Vec3b& pixel, const int* at) {
      pixel = cv::Vec3b(static_cast<uchar>(10 * at[0]), static_cast<uchar>(7 * at[1]), static_cast<uchar>(40 + i));
    });
    return image;
  }

  /// 1 m + 10 units per row + 1 unit per column + 100 per frame, without depth in the top left pixel.
  static cv::Mat depthImage(int i) {
    cv::Mat image(kHeight_px, kWidth_px, CV_16UC1);
    image.forEach<std::uint16_t>([i](std::uint16_t& pixel, const int* at) {
      pixel = static_cast<std::uint16_t>(5000 + 10 * at[0] + at[1] + 100 * i);
    });
    image.at<std::uint16_t>(0, 0) = 0;
    return image;
  }

 private:
  TemporaryFolder folder_;
};

/// Keeps the first `part` (0..1) of a file.
inline void cutOff(const std::filesystem::path& file, double part) {
  const auto size = static_cast<double>(std::filesystem::file_size(file));
  std::filesystem::resize_file(file, static_cast<std::uintmax_t>(part * size));
}

}  // namespace wardslam::test
