#include "wardslam/segmentation/depth_channels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace wardslam::segmentation {
namespace {

constexpr int kReach = 2;               ///< Pixels that a slope looks to either side.
constexpr float kNearest_m = 0.05F;     ///< Nothing counts as nearer.
constexpr float kHalfRoom_m = 3.0F;     ///< Unit of places,
constexpr float kFarthestPlace = 1.5F;  ///< and how far off they count.
constexpr float kMinMeasured = 2.5F;    ///< Measured pixels a side needs: more than this,
constexpr float kSidesApart_px = 3.0F;  ///< and how far the middles of both sides are apart.

/// The nearest of what is measured in the rows [y0, y1) and columns [x0, x1); 0 = none.
float nearestIn(const cv::Mat& depth_m, int y0, int y1, int x0, int x1) {
  constexpr float kNone = 1e9F;
  float nearest_m = kNone;
  for (int y = y0; y < y1; ++y) {
    const auto* row = depth_m.ptr<float>(y);
    for (int x = x0; x < x1; ++x) nearest_m = row[x] > 0.0F && row[x] < nearest_m ? row[x] : nearest_m;
  }
  return nearest_m < kNone ? nearest_m : 0.0F;
}

/// Sums over what lies on each side of the pixels of a row: 5 pixels long, 2 wide.
struct SideSums {
  std::vector<float> left;
  std::vector<float> right;
  std::vector<float> above;
  std::vector<float> below;

  explicit SideSums(int width)
      : left(static_cast<std::size_t>(width)), right(left.size()), above(left.size()), below(left.size()) {}

  /// For row `v` of a picture with two more rows and columns on each side. Pixels are added in the order in which
  /// the reference adds them, line by line, as rounding shows in the slopes.
  void set(const cv::Mat& padded, int v) {
    const std::array<const float*, 5> row = {padded.ptr<float>(v), padded.ptr<float>(v + 1), padded.ptr<float>(v + 2),
                                             padded.ptr<float>(v + 3), padded.ptr<float>(v + 4)};
    const auto twoOfAll = [&row](std::size_t u) {
      return row[0][u] + row[0][u + 1] + row[1][u] + row[1][u + 1] + row[2][u] + row[2][u + 1] + row[3][u] +
             row[3][u + 1] + row[4][u] + row[4][u + 1];
    };
    const auto allOfTwo = [](const float* a, const float* b, std::size_t u) {
      return a[u] + a[u + 1] + a[u + 2] + a[u + 3] + a[u + 4] + b[u] + b[u + 1] + b[u + 2] + b[u + 3] + b[u + 4];
    };
    for (std::size_t u = 0; u < left.size(); ++u) {
      left[u] = twoOfAll(u);
      right[u] = twoOfAll(u + 3);
      above[u] = allOfTwo(row[0], row[1], u);
      below[u] = allOfTwo(row[3], row[4], u);
    }
  }
};

/// Slopes of the inverse depth, from its sums on both sides and how many pixels those are of.
void findSlopes(const std::vector<float>& sumBefore, const std::vector<float>& countBefore,
                const std::vector<float>& sumBehind, const std::vector<float>& countBehind,
                std::vector<float>& slopes) {
  for (std::size_t u = 0; u < slopes.size(); ++u) {
    const float before = sumBefore[u] / std::max(countBefore[u], 1.0F);
    const float behind = sumBehind[u] / std::max(countBehind[u], 1.0F);
    const bool isKnown = std::min(countBefore[u], countBehind[u]) > kMinMeasured;
    slopes[u] = isKnown ? (behind - before) / kSidesApart_px : 0.0F;
  }
}

/// Inverse depth, and 1 where it was measured, with two rows and columns of nothing around.
struct Measured {
  cv::Mat inverse;
  cv::Mat is;

  explicit Measured(const cv::Mat& depth_m)
      : inverse(depth_m.rows + 2 * kReach, depth_m.cols + 2 * kReach, CV_32F, cv::Scalar(0)), is(inverse.clone()) {
    for (int v = 0; v < depth_m.rows; ++v) {
      const auto* z = depth_m.ptr<float>(v);
      auto* one = is.ptr<float>(v + kReach) + kReach;
      auto* w = inverse.ptr<float>(v + kReach) + kReach;
      for (int u = 0; u < depth_m.cols; ++u) {
        one[u] = z[u] > 0.0F ? 1.0F : 0.0F;
        w[u] = one[u] / std::max(z[u], kNearest_m);
      }
    }
  }
};

/// One row of the picture and what is known about it.
struct Row {
  const float* z;
  const float* w;
  const float* is;
  const float* x;      ///< Of the ray, at depth 1,
  float y;             ///< and all of the row have the same.
  const float* right;  ///< Slopes of w.
  const float* down;
};

void writeRow(const Row& row, float fx, float fy, int width, const std::array<float*, kDepthChannels>& out) {
  for (int u = 0; u < width; ++u) {
    const float a = row.right[u] * fx;
    const float b = row.down[u] * fy;
    const float c = row.w[u] - row.x[u] * a - row.y * b;
    const float perNorm = row.is[u] / std::max(std::sqrt(a * a + b * b + c * c), 1e-6F);
    const float scaled = row.z[u] * row.is[u] / kHalfRoom_m;
    out[0][u] = row.w[u];
    out[1][u] = row.is[u];
    out[2][u] = a * perNorm;
    out[3][u] = b * perNorm;
    out[4][u] = std::clamp(row.x[u] * scaled, -kFarthestPlace, kFarthestPlace);
    out[5][u] = std::clamp(row.y * scaled, -kFarthestPlace, kFarthestPlace);
  }
}

}  // namespace

DepthPicture fitDepth(const cv::Mat& depth_m, const core::CameraModel& camera, const Letterbox& letterbox) {
  const cv::Rect& content = letterbox.content_px();
  const double scaleX = letterbox.scaleX();
  const double scaleY = letterbox.scaleY();
  DepthPicture picture{cv::Mat(letterbox.input_px(), CV_32FC1, cv::Scalar(0)), camera.fx_px * scaleX,
                       camera.fy_px * scaleY, (camera.cx_px + 0.5) * scaleX - 0.5 + content.x,
                       (camera.cy_px + 0.5) * scaleY - 0.5 + content.y};
  for (int v = 0; v < content.height; ++v) {
    const int y0 = v * depth_m.rows / content.height;
    const int y1 = std::max(y0 + 1, (v + 1) * depth_m.rows / content.height);
    auto* row = picture.depth_m.ptr<float>(content.y + v) + content.x;
    for (int u = 0; u < content.width; ++u) {
      const int x0 = u * depth_m.cols / content.width;
      row[u] = nearestIn(depth_m, y0, y1, x0, std::max(x0 + 1, (u + 1) * depth_m.cols / content.width));
    }
  }
  return picture;
}

cv::Mat depthChannels(const DepthPicture& picture) {
  const cv::Size size = picture.depth_m.size();
  const auto width = static_cast<std::size_t>(size.width);
  const Measured measured(picture.depth_m);
  SideSums inverse(size.width);
  SideSums count(size.width);
  std::vector<float> x(width);
  for (std::size_t u = 0; u < width; ++u) {
    x[u] = (static_cast<float>(u) - static_cast<float>(picture.cx_px)) / static_cast<float>(picture.fx_px);
  }
  std::vector<float> right(width);
  std::vector<float> down(width);
  cv::Mat channels({1, kDepthChannels, size.height, size.width}, CV_32F);
  for (int v = 0; v < size.height; ++v) {
    inverse.set(measured.inverse, v);
    count.set(measured.is, v);
    findSlopes(inverse.left, count.left, inverse.right, count.right, right);
    findSlopes(inverse.above, count.above, inverse.below, count.below, down);
    const Row row{picture.depth_m.ptr<float>(v),
                  measured.inverse.ptr<float>(v + kReach) + kReach,
                  measured.is.ptr<float>(v + kReach) + kReach,
                  x.data(),
                  (static_cast<float>(v) - static_cast<float>(picture.cy_px)) / static_cast<float>(picture.fy_px),
                  right.data(),
                  down.data()};
    std::array<float*, kDepthChannels> out{};
    for (int c = 0; c < kDepthChannels; ++c) {
      out[static_cast<std::size_t>(c)] = channels.ptr<float>(0, c) + static_cast<std::size_t>(v) * width;
    }
    writeRow(row, static_cast<float>(picture.fx_px), static_cast<float>(picture.fy_px), size.width, out);
  }
  return channels;
}

}  // namespace wardslam::segmentation
