#include "wardslam/odometry/depth_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wardslam/core/nearest_pixel.h"

namespace wardslam::odometry {
namespace {

constexpr int kColumns = 64;
constexpr double kMinDepth_m = 0.1;
constexpr double kSigmas = 3.0;
constexpr double kPoseError_m = 0.05;          // what a pose may be off by, and half a cell of a slanted wall,
constexpr double kPoseErrorPerMetre_m = 0.03;  // the more the farther away

double tolerance_m(const core::DepthNoise& noise, double depth_m) {
  return kPoseError_m + kPoseErrorPerMetre_m * depth_m + kSigmas * noise.sigma_m(depth_m);
}

std::uint16_t toMillimetres(float depth_m) {
  return static_cast<std::uint16_t>(std::lround(std::min(65.0F, depth_m) * 1000.0F));
}

/// Nearest and farthest of the pixels of one cell; nothing where something may move.
std::pair<float, float> rangeOf(const DepthImage& image, const cv::Rect& cell) {
  std::pair<float, float> range{0.0F, 0.0F};
  for (int y = cell.y; y < cell.y + cell.height; ++y) {
    for (int x = cell.x; x < cell.x + cell.width; ++x) {
      if (image.mayMove.size() == image.depth_m.size() && image.mayMove.at<std::uint8_t>(y, x) != 0)
        return {0.0F, 0.0F};
      const float depth_m = image.depth_m.at<float>(y, x);
      if (!(depth_m > 0.0F)) continue;
      range.first = range.first > 0.0F ? std::min(range.first, depth_m) : depth_m;
      range.second = std::max(range.second, depth_m);
    }
  }
  return range;
}

}  // namespace

DepthView makeDepthView(const DepthImage& image) {
  DepthView view;
  if (image.depth_m.empty()) return view;
  view.cell_px = std::max(1, image.depth_m.cols / kColumns);
  view.columns = image.depth_m.cols / view.cell_px;
  view.rows = image.depth_m.rows / view.cell_px;
  for (int row = 0; row < view.rows; ++row) {
    for (int column = 0; column < view.columns; ++column) {
      const cv::Rect cell(column * view.cell_px, row * view.cell_px, view.cell_px, view.cell_px);
      const auto [nearest_m, farthest_m] = rangeOf(image, cell);
      view.nearest_mm.push_back(toMillimetres(nearest_m));
      view.farthest_mm.push_back(toMillimetres(farthest_m));
    }
  }
  return view;
}

InDepth lookUp(const DepthView& view, const core::CameraModel& camera, const Eigen::Vector3d& p_cam_m) {
  if (view.cell_px == 0 || p_cam_m.z() < kMinDepth_m) return InDepth::Unknown;
  const auto raw_px = camera.seenAt(p_cam_m);
  if (!raw_px) return InDepth::Unknown;
  const int column = static_cast<int>(std::floor(raw_px->x() / view.cell_px));
  const int row = static_cast<int>(std::floor(raw_px->y() / view.cell_px));
  if (column < 0 || row < 0 || column >= view.columns || row >= view.rows) return InDepth::Unknown;
  const auto indexOf = [&](int c, int r) { return static_cast<std::size_t>(r * view.columns + c); };
  if (view.nearest_mm[indexOf(column, row)] == 0) return InDepth::Unknown;
  // A cell around, for where an edge lies is known no better.
  int nearest_mm = view.nearest_mm[indexOf(column, row)];
  int farthest_mm = 0;
  for (int r = std::max(0, row - 1); r <= std::min(view.rows - 1, row + 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(view.columns - 1, column + 1); ++c) {
      if (view.nearest_mm[indexOf(c, r)] == 0) continue;
      nearest_mm = std::min<int>(nearest_mm, view.nearest_mm[indexOf(c, r)]);
      farthest_mm = std::max<int>(farthest_mm, view.farthest_mm[indexOf(c, r)]);
    }
  }
  const double allowed_m = tolerance_m(camera.depthNoise, p_cam_m.z());
  if (p_cam_m.z() < 1e-3 * nearest_mm - allowed_m) return InDepth::SeenThrough;
  if (p_cam_m.z() > 1e-3 * farthest_mm + allowed_m) return InDepth::Hidden;
  return InDepth::Agrees;
}

bool maySee(const DepthImage& image, const Eigen::Vector2d& raw_px, double depth_m, const core::DepthNoise& noise) {
  if (image.depth_m.empty()) return true;
  const cv::Point at =
      core::nearestPixel({static_cast<float>(raw_px.x()), static_cast<float>(raw_px.y())}, image.depth_m.size());
  if (image.mayMove.size() == image.depth_m.size() && image.mayMove.at<std::uint8_t>(at) != 0) return false;
  const cv::Rect around = cv::Rect(at.x - 1, at.y - 1, 3, 3) & cv::Rect({}, image.depth_m.size());
  double farthest_m = 0.0;
  cv::minMaxLoc(image.depth_m(around), nullptr, &farthest_m);
  return farthest_m <= 0.0 || depth_m <= farthest_m + tolerance_m(noise, depth_m);
}

void DepthAgreement::count(InDepth found) {
  switch (found) {
    case InDepth::Unknown:
      ++unknown;
      break;
    case InDepth::Agrees:
      ++agreeing;
      break;
    case InDepth::SeenThrough:
      ++seenThrough;
      break;
    case InDepth::Hidden:
      ++hidden;
      break;
  }
}

DepthAgreement& DepthAgreement::operator+=(const DepthAgreement& other) {
  agreeing += other.agreeing;
  seenThrough += other.seenThrough;
  hidden += other.hidden;
  unknown += other.unknown;
  return *this;
}

double DepthAgreement::contradiction() const {
  const int visible = agreeing + seenThrough;
  return visible > 0 ? static_cast<double>(seenThrough) / visible : 0.0;
}

double DepthAgreement::overlap() const {
  const int all = compared() + unknown;
  return all > 0 ? static_cast<double>(agreeing) / all : 0.0;
}

DepthAgreement compareDepth(const DepthView& view, const core::CameraModel& camera, const DepthView& other,
                            const core::CameraModel& otherCamera, const Eigen::Isometry3d& T_cam_other) {
  std::vector<cv::Point2f> centres_px;
  std::vector<double> depths_m;
  for (int row = 0; row < other.rows; ++row) {
    for (int column = 0; column < other.columns; ++column) {
      const auto cell = static_cast<std::size_t>(row * other.columns + column);
      const double nearest_m = 1e-3 * other.nearest_mm[cell];
      const double farthest_m = 1e-3 * other.farthest_mm[cell];
      if (nearest_m <= 0 || farthest_m - nearest_m > tolerance_m(otherCamera.depthNoise, nearest_m))
        continue;  // an edge
      const auto half_px = 0.5F * static_cast<float>(other.cell_px - 1);
      centres_px.emplace_back(static_cast<float>(column * other.cell_px) + half_px,
                              static_cast<float>(row * other.cell_px) + half_px);
      depths_m.push_back(0.5 * (nearest_m + farthest_m));
    }
  }
  const auto undistorted_px = otherCamera.undistort(centres_px);
  DepthAgreement agreement;
  for (std::size_t i = 0; i < depths_m.size(); ++i) {
    const Eigen::Vector3d p_other_m = otherCamera.unproject({undistorted_px[i].x, undistorted_px[i].y}, depths_m[i]);
    agreement.count(lookUp(view, camera, T_cam_other * p_other_m));
  }
  return agreement;
}

}  // namespace wardslam::odometry
