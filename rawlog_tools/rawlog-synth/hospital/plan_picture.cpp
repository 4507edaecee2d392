#include <cmath>
#include <opencv2/imgproc.hpp>

#include "hospital/hospital_truth.h"

namespace wardslam::synth {
namespace {

constexpr double kPixels_per_m = 40.0;
constexpr int kMargin_px = 30;
constexpr int kShift = 4;  ///< OpenCV draws with sixteenths of a pixel.

cv::Scalar colourOf(RoomKind kind) {
  switch (kind) {
    case RoomKind::Corridor:
      return {240, 240, 240};
    case RoomKind::Ward:
      return {240, 226, 205};
    case RoomKind::NurseStation:
      return {200, 235, 240};
    case RoomKind::Lobby:
      return {205, 240, 215};
    case RoomKind::DayRoom:
      return {215, 225, 250};
    case RoomKind::Toilet:
    case RoomKind::Bath:
      return {245, 240, 195};
    default:
      return {225, 225, 215};
  }
}

cv::Scalar colourOf(const Item& item) {
  switch (item.kind) {
    case ItemKind::Bed:
      return item.occupied ? cv::Scalar(90, 90, 220) : cv::Scalar(220, 160, 90);
    case ItemKind::Chair:
      return {60, 140, 60};
    case ItemKind::Wheelchair:
      return {200, 60, 170};
    case ItemKind::Trolley:
      return {20, 130, 230};
    case ItemKind::IvStand:
      return {200, 200, 40};
    case ItemKind::Screen:
    case ItemKind::Curtain:
      return {150, 110, 40};
    case ItemKind::Plant:
      return {40, 110, 30};
    default:
      return {140, 140, 140};
  }
}

class Drawing {
 public:
  explicit Drawing(const Eigen::Vector2d& size_m)
      : height_px_(cvRound(size_m.y() * kPixels_per_m) + 2 * kMargin_px),
        image_(height_px_, cvRound(size_m.x() * kPixels_per_m) + 2 * kMargin_px, CV_8UC3, cv::Scalar::all(255)) {}

  void room(const Room& room);
  void door(const Door& door, bool throughout);
  void item(const Item& item);
  void name(const Room& room);
  void way(const HospitalRoute& route, double until_s);
  [[nodiscard]] cv::Mat take() { return image_; }

 private:
  [[nodiscard]] cv::Point at(const Eigen::Vector2d& p_m) const {
    const double scale = kPixels_per_m * (1 << kShift);
    return {cvRound(p_m.x() * scale) + (kMargin_px << kShift),
            ((height_px_ - kMargin_px) << kShift) - cvRound(p_m.y() * scale)};
  }
  void line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const cv::Scalar& colour, int width_px) {
    cv::line(image_, at(a), at(b), colour, width_px, cv::LINE_AA, kShift);
  }

  int height_px_;
  cv::Mat image_;
};

void Drawing::room(const Room& room) {
  cv::rectangle(image_, at(room.area_m.min()), at(room.area_m.max()), colourOf(room.kind), cv::FILLED, cv::LINE_8,
                kShift);
  cv::rectangle(image_, at(room.area_m.min()), at(room.area_m.max()), {60, 60, 60}, 5, cv::LINE_8, kShift);
}

void Drawing::door(const Door& door, bool throughout) {
  line(door.from_m, door.to_m, throughout ? cv::Scalar(240, 240, 240) : cv::Scalar(255, 255, 255), 7);
}

void Drawing::item(const Item& item) {
  if (item.footprint_m.isEmpty()) return;
  const Eigen::Isometry3d T = item.T_world_item.cast<double>();
  const Eigen::Vector2d low = item.footprint_m.min();
  const Eigen::Vector2d high = item.footprint_m.max();
  std::vector<cv::Point> corners;
  for (const Eigen::Vector2d& p : {low, Eigen::Vector2d(high.x(), low.y()), high, Eigen::Vector2d(low.x(), high.y())})
    corners.push_back(at((T * Eigen::Vector3d(p.x(), p.y(), 0)).head<2>()));
  const bool leaf = item.kind == ItemKind::DoorLeaf;
  cv::fillPoly(image_, std::vector<std::vector<cv::Point>>{corners}, leaf ? cv::Scalar(30, 70, 150) : colourOf(item),
               cv::LINE_AA, kShift);
  cv::polylines(image_, corners, true, {50, 50, 50}, 1, cv::LINE_AA, kShift);
}

void Drawing::name(const Room& room) {
  const cv::Point middle = at(room.area_m.center());
  const double scale = room.kind == RoomKind::Corridor || room.area_m.sizes().x() > 6 ? 0.8 : 0.5;
  const cv::Size size = cv::getTextSize(room.name, cv::FONT_HERSHEY_SIMPLEX, scale, 2, nullptr);
  const cv::Point origin((middle.x >> kShift) - size.width / 2, (middle.y >> kShift) + size.height / 2);
  cv::putText(image_, room.name, origin, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar::all(255), 5, cv::LINE_AA);
  cv::putText(image_, room.name, origin, cv::FONT_HERSHEY_SIMPLEX, scale, {40, 40, 40}, 2, cv::LINE_AA);
}

void Drawing::way(const HospitalRoute& route, double until_s) {
  constexpr double kStep_s = 0.2;
  for (double t = 0; t + kStep_s < until_s; t += kStep_s)
    line(route.at(t).p_m, route.at(t + kStep_s).p_m, {60, 60, 235}, 2);
  const auto start = route.at(0.0);
  const Eigen::Vector2d ahead(std::cos(start.heading_rad), std::sin(start.heading_rad));
  cv::arrowedLine(image_, at(start.p_m), at(start.p_m + 1.2 * ahead), {20, 20, 160}, 6, cv::LINE_AA, kShift, 0.4);
}

}  // namespace

cv::Mat planPicture(const HospitalPlan& plan, const HospitalDay& today, const HospitalRoute& route, double until_s) {
  Drawing drawing(plan.size_m);
  for (const Room& room : plan.rooms) drawing.room(room);
  for (const Door& door : plan.doors) drawing.door(door, door.height_m >= plan.height_m);
  for (const Item& item : today.items) drawing.item(item);
  drawing.way(route, until_s);
  for (const Room& room : plan.rooms) drawing.name(room);
  return drawing.take();
}

}  // namespace wardslam::synth
