#include "wardslam/viewer/rooms_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>
#include <string>

namespace wardslam::viewer {
namespace {

constexpr double kPixelsPerMetre = 30.0;
constexpr int kLongestSide_px = 3000;
constexpr int kMargin_px = 20;
constexpr double kLetter = 0.45;
const std::array<cv::Scalar, 8> kColours = {
    cv::Scalar(205, 230, 255), cv::Scalar(255, 225, 200), cv::Scalar(205, 245, 205), cv::Scalar(235, 210, 245),
    cv::Scalar(190, 240, 245), cv::Scalar(225, 225, 225), cv::Scalar(215, 205, 250), cv::Scalar(240, 245, 200)};

/// The part of the raster that has rooms, in cells.
cv::Rect usedPart(const building::Rooms& rooms) {
  std::vector<cv::Point> cells;
  if (!rooms.ids.empty()) cv::findNonZero(rooms.ids != 0, cells);
  return cells.empty() ? cv::Rect() : cv::boundingRect(cells);
}

/// From places of the map to pixels.
class Sheet {
 public:
  Sheet(const building::Rooms& rooms, const cv::Rect& part) : part_(part), cell_m_(rooms.resolution_m) {
    const double longest_m = std::max(part.width, part.height) * cell_m_;
    pixelsPerMetre_ = std::min(kPixelsPerMetre, kLongestSide_px / longest_m);
    corner_m_ = rooms.origin_m + cell_m_ * Eigen::Vector2d(part.x, part.y + part.height);
    const double scale = cell_m_ * pixelsPerMetre_;
    size_ = {static_cast<int>(std::ceil(part.width * scale)), static_cast<int>(std::ceil(part.height * scale))};
  }

  [[nodiscard]] cv::Size size() const { return size_; }
  [[nodiscard]] cv::Point pixel(const Eigen::Vector2d& p_map_m) const {
    return {static_cast<int>(std::lround((p_map_m.x() - corner_m_.x()) * pixelsPerMetre_)),
            static_cast<int>(std::lround((corner_m_.y() - p_map_m.y()) * pixelsPerMetre_))};
  }
  [[nodiscard]] int idAt(const building::Rooms& rooms, int row, int column) const {
    const double scale = cell_m_ * pixelsPerMetre_;
    const int y = part_.y + part_.height - 1 - std::min(part_.height - 1, static_cast<int>(row / scale));
    const int x = part_.x + std::min(part_.width - 1, static_cast<int>(column / scale));
    return rooms.ids.at<int>(y, x);
  }

 private:
  cv::Rect part_;
  double cell_m_;
  double pixelsPerMetre_ = kPixelsPerMetre;
  Eigen::Vector2d corner_m_;  ///< The picture's upper left one.
  cv::Size size_;
};

void paintRooms(const building::Rooms& rooms, const Sheet& sheet, cv::Mat& picture) {
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 0; column < picture.cols; ++column) {
      const int id = sheet.idAt(rooms, row, column);
      if (id == 0) continue;
      const auto& colour = kColours[static_cast<std::size_t>(id) % kColours.size()];
      picture.at<cv::Vec3b>(row, column) =
          cv::Vec3b(static_cast<uchar>(colour[0]), static_cast<uchar>(colour[1]), static_cast<uchar>(colour[2]));
    }
  }
}

void write(const std::string& text, const cv::Point& middle, cv::Mat& picture) {
  const cv::Size size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, kLetter, 1, nullptr);
  const cv::Point at(std::clamp(middle.x - size.width / 2, 0, std::max(0, picture.cols - size.width)),
                     std::clamp(middle.y + size.height / 2, size.height, std::max(size.height, picture.rows - 1)));
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, kLetter, cv::Scalar::all(0), 1, cv::LINE_AA);
}

std::string withUnit(double value, const char* unit) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f %s", value, unit);
  return text.data();
}

}  // namespace

cv::Mat drawRooms(const building::Rooms& rooms) {
  const cv::Rect part = usedPart(rooms);
  if (part.empty()) return {cv::Size(2 * kMargin_px, 2 * kMargin_px), CV_8UC3, cv::Scalar::all(255)};
  const Sheet sheet(rooms, part);
  cv::Mat picture(sheet.size(), CV_8UC3, cv::Scalar::all(255));
  paintRooms(rooms, sheet, picture);
  for (const auto& door : rooms.doors) {
    cv::line(picture, sheet.pixel(door.from_m), sheet.pixel(door.to_m), cv::Scalar::all(0), 2, cv::LINE_AA);
  }
  for (const auto& room : rooms.all) {
    const cv::Point middle = sheet.pixel(room.middle_m);
    write(room.name, middle - cv::Point(0, 8), picture);
    write(withUnit(room.area_m2, "m2"), middle + cv::Point(0, 8), picture);
  }
  cv::copyMakeBorder(picture, picture, kMargin_px, kMargin_px, kMargin_px, kMargin_px, cv::BORDER_CONSTANT,
                     cv::Scalar::all(255));
  return picture;
}

}  // namespace wardslam::viewer
