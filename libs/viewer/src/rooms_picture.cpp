#include "wardslam/viewer/rooms_picture.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

namespace wardslam::viewer {
namespace {

constexpr double kPixelsPerMetre = 30.0;
constexpr int kLongestSide_px = 3000;
constexpr int kMargin_px = 20;
constexpr double kLetter = 0.45;
const std::array<cv::Vec3b, 8> kColours = {cv::Vec3b(205, 230, 255), {255, 225, 200}, {205, 245, 205}, {235, 210, 245},
                                           {190, 240, 245},          {225, 225, 225}, {215, 205, 250}, {240, 245, 200}};

/// The part of the raster that has rooms, in cells.
cv::Rect usedPart(const building::Rooms& rooms) {
  std::vector<cv::Point> cells;
  if (!rooms.ids.empty()) cv::findNonZero(rooms.ids != 0, cells);
  return cells.empty() ? cv::Rect() : cv::boundingRect(cells);
}

/// From places of the map to pixels.
struct Sheet {
  Sheet(const building::Rooms& rooms, const cv::Rect& part) {
    const double longest_m = std::max(part.width, part.height) * rooms.resolution_m;
    pixelsPerMetre = std::min(kPixelsPerMetre, kLongestSide_px / longest_m);
    corner_m = rooms.origin_m + rooms.resolution_m * Eigen::Vector2d(part.x, part.y + part.height);
    const double pixelsPerCell = rooms.resolution_m * pixelsPerMetre;
    size = {cvCeil(part.width * pixelsPerCell), cvCeil(part.height * pixelsPerCell)};
  }

  [[nodiscard]] cv::Point pixel(const Eigen::Vector2d& p_map_m) const {
    return {cvRound((p_map_m.x() - corner_m.x()) * pixelsPerMetre),
            cvRound((corner_m.y() - p_map_m.y()) * pixelsPerMetre)};
  }

  double pixelsPerMetre = kPixelsPerMetre;
  Eigen::Vector2d corner_m = Eigen::Vector2d::Zero();  ///< The picture's upper left one.
  cv::Size size;
};

/// These cells in the colours of their rooms, a pixel each.
cv::Mat coloured(const cv::Mat& ids) {
  cv::Mat colours(ids.size(), CV_8UC3, cv::Scalar::all(255));
  for (int row = 0; row < ids.rows; ++row) {
    for (int column = 0; column < ids.cols; ++column) {
      const int id = ids.at<int>(row, column);
      if (id != 0) colours.at<cv::Vec3b>(row, column) = kColours[static_cast<std::size_t>(id) % kColours.size()];
    }
  }
  return colours;
}

void write(const std::string& text, const cv::Point& middle, cv::Mat& picture) {
  const cv::Size size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, kLetter, 1, nullptr);
  const cv::Point at(std::clamp(middle.x - size.width / 2, 0, std::max(0, picture.cols - size.width)),
                     std::clamp(middle.y + size.height / 2, size.height, std::max(size.height, picture.rows - 1)));
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, kLetter, cv::Scalar::all(0), 1, cv::LINE_AA);
}

std::string areaText(const building::Room& room) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f m2", room.area_m2);
  return text.data();
}

}  // namespace

cv::Mat drawRooms(const building::Rooms& rooms) {
  const cv::Rect part = usedPart(rooms);
  if (part.empty()) return {cv::Size(2 * kMargin_px, 2 * kMargin_px), CV_8UC3, cv::Scalar::all(255)};
  const Sheet sheet(rooms, part);
  cv::Mat picture = coloured(rooms.ids(part));
  cv::flip(picture, picture, 0);  // north up
  cv::resize(picture, picture, sheet.size, 0.0, 0.0, cv::INTER_NEAREST);
  for (const auto& door : rooms.doors) {
    cv::line(picture, sheet.pixel(door.from_m), sheet.pixel(door.to_m), cv::Scalar::all(0), 2, cv::LINE_AA);
  }
  for (const auto& room : rooms.all) {
    const cv::Point middle = sheet.pixel(room.middle_m);
    write(room.name, middle - cv::Point(0, 8), picture);
    write(areaText(room), middle + cv::Point(0, 8), picture);
  }
  cv::copyMakeBorder(picture, picture, kMargin_px, kMargin_px, kMargin_px, kMargin_px, cv::BORDER_CONSTANT,
                     cv::Scalar::all(255));
  return picture;
}

}  // namespace wardslam::viewer
