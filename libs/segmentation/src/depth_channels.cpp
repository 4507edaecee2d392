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

constexpr float kNothing_m = 1e9F;  ///< Farther than anything.

/// Takes over what of a row is nearer than what was in the rows before.
void keepNearest(const float* row_m, int width, float* nearest_m) {
  for (int x = 0; x < width; ++x) {
    const float here_m = row_m[x] > 0.0F ? row_m[x] : kNothing_m;
    nearest_m[x] = here_m < nearest_m[x] ? here_m : nearest_m[x];
  }
}

/// The loops of what follows are kept to few arrays each, so that compilers make them work on several pixels at once.

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
    const std::size_t width = left.size();
    for (std::size_t u = 0; u < width; ++u) left[u] = twoOfAll(u);
    for (std::size_t u = 0; u < width; ++u) right[u] = twoOfAll(u + 3);
    for (std::size_t u = 0; u < width; ++u) above[u] = allOfTwo(row[0], row[1], u);
    for (std::size_t u = 0; u < width; ++u) below[u] = allOfTwo(row[3], row[4], u);
  }
};

/// Slopes of the inverse depth times the focal length, from its sums on both sides and how many pixels those are of.
void findSlopes(const std::vector<float>& sumBefore, const std::vector<float>& countBefore,
                const std::vector<float>& sumBehind, const std::vector<float>& countBehind, float focalLength_px,
                cv::Mat& slopes) {
  auto* out = slopes.ptr<float>();
  for (std::size_t u = 0; u < sumBefore.size(); ++u) {
    const float nBefore = countBefore[u] > 1.0F ? countBefore[u] : 1.0F;
    const float nBehind = countBehind[u] > 1.0F ? countBehind[u] : 1.0F;
    const float least = nBefore < nBehind ? nBefore : nBehind;
    const float slope = (sumBehind[u] / nBehind - sumBefore[u] / nBefore) / kSidesApart_px * focalLength_px;
    out[u] = least > kMinMeasured ? slope : 0.0F;
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

/// The normals of a row of the picture. `right`, `down`: slopes of the inverse depth `w`, times the focal lengths; `x`,
/// `y`: of the rays at depth 1. Writes the first two components, 0 where nothing was measured.
void writeNormals(const float* w, const float* is, const cv::Mat& right, const cv::Mat& down, const cv::Mat& x, float y,
                  cv::Mat& norm, float* nx, float* ny) {
  const auto* a = right.ptr<float>();
  const auto* b = down.ptr<float>();
  const auto* xs = x.ptr<float>();
  auto* n = norm.ptr<float>();
  const int width = x.cols;
  for (int u = 0; u < width; ++u) {
    const float c = w[u] - xs[u] * a[u] - y * b[u];
    n[u] = a[u] * a[u] + b[u] * b[u] + c * c;
  }
  cv::sqrt(norm, norm);
  for (int u = 0; u < width; ++u) n[u] = is[u] / (n[u] > 1e-6F ? n[u] : 1e-6F);
  for (int u = 0; u < width; ++u) nx[u] = a[u] * n[u];
  for (int u = 0; u < width; ++u) ny[u] = b[u] * n[u];
}

float cut(float place) {
  const float below = place < kFarthestPlace ? place : kFarthestPlace;
  return below > -kFarthestPlace ? below : -kFarthestPlace;
}

/// Where the points of a row are, sideways and down.
void writePlaces(const float* z, const float* is, const cv::Mat& x, float y, float* right, float* down) {
  const auto* xs = x.ptr<float>();
  const int width = x.cols;
  for (int u = 0; u < width; ++u) right[u] = cut(xs[u] * (z[u] * is[u] / kHalfRoom_m));
  for (int u = 0; u < width; ++u) down[u] = cut(y * (z[u] * is[u] / kHalfRoom_m));
}

}  // namespace

DepthPicture fitDepth(const cv::Mat& depth_m, const core::CameraModel& camera, const Letterbox& letterbox) {
  const cv::Rect& content = letterbox.content_px();
  const double scaleX = letterbox.scaleX();
  const double scaleY = letterbox.scaleY();
  DepthPicture picture{cv::Mat(letterbox.input_px(), CV_32FC1, cv::Scalar(0)), camera.fx_px * scaleX,
                       camera.fy_px * scaleY, (camera.cx_px + 0.5) * scaleX - 0.5 + content.x,
                       (camera.cy_px + 0.5) * scaleY - 0.5 + content.y};
  std::vector<float> nearest_m(static_cast<std::size_t>(depth_m.cols));
  for (int v = 0; v < content.height; ++v) {
    const int y0 = v * depth_m.rows / content.height;
    const int y1 = std::max(y0 + 1, (v + 1) * depth_m.rows / content.height);
    std::fill(nearest_m.begin(), nearest_m.end(), kNothing_m);
    for (int y = y0; y < y1; ++y) keepNearest(depth_m.ptr<float>(y), depth_m.cols, nearest_m.data());
    auto* row = picture.depth_m.ptr<float>(content.y + v) + content.x;
    for (int u = 0; u < content.width; ++u) {
      const int x0 = u * depth_m.cols / content.width;
      const int x1 = std::max(x0 + 1, (u + 1) * depth_m.cols / content.width);
      const float here_m = *std::min_element(nearest_m.begin() + x0, nearest_m.begin() + x1);
      row[u] = here_m < kNothing_m ? here_m : 0.0F;
    }
  }
  return picture;
}

cv::Mat depthChannels(const DepthPicture& picture) {
  const cv::Size size = picture.depth_m.size();
  const auto fx = static_cast<float>(picture.fx_px);
  const auto fy = static_cast<float>(picture.fy_px);
  const Measured measured(picture.depth_m);
  SideSums inverse(size.width);
  SideSums count(size.width);
  cv::Mat x(1, size.width, CV_32F);
  for (int u = 0; u < size.width; ++u)
    x.at<float>(u) = (static_cast<float>(u) - static_cast<float>(picture.cx_px)) / fx;
  cv::Mat right(1, size.width, CV_32F);
  cv::Mat down(1, size.width, CV_32F);
  cv::Mat norm(1, size.width, CV_32F);
  cv::Mat channels({1, kDepthChannels, size.height, size.width}, CV_32F);
  const auto rowOf = [&](int channel, int v) {
    return channels.ptr<float>(0, channel) + static_cast<std::ptrdiff_t>(v) * size.width;
  };
  for (int v = 0; v < size.height; ++v) {
    const auto* w = measured.inverse.ptr<float>(v + kReach) + kReach;
    const auto* is = measured.is.ptr<float>(v + kReach) + kReach;
    const float y = (static_cast<float>(v) - static_cast<float>(picture.cy_px)) / fy;
    inverse.set(measured.inverse, v);
    count.set(measured.is, v);
    findSlopes(inverse.left, count.left, inverse.right, count.right, fx, right);
    findSlopes(inverse.above, count.above, inverse.below, count.below, fy, down);
    std::copy(w, w + size.width, rowOf(0, v));
    std::copy(is, is + size.width, rowOf(1, v));
    writeNormals(w, is, right, down, x, y, norm, rowOf(2, v), rowOf(3, v));
    writePlaces(picture.depth_m.ptr<float>(v), is, x, y, rowOf(4, v), rowOf(5, v));
  }
  return channels;
}

}  // namespace wardslam::segmentation
