#include "depth_instances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "wardslam/core/segmentation.h"

namespace wardslam::segmentation {
namespace {

constexpr float kPersonStep_m = 0.25F;  ///< Between what is two people,
constexpr float kThingStep_m = 0.7F;    ///< or two things, which have frames and feet; and more farther away,
constexpr float kStepPerMetre = 0.03F;  ///< where depth is coarse.
constexpr float kInFront_m = 0.05F;     ///< What hides something is nearer by more than noise.
constexpr double kWidestGap_m = 0.5;    ///< A trunk or an arm fits into it.
constexpr int kLinesAcross = 3;         ///< Rows and columns that must say so before parts are joined.

using Pixel = std::int32_t;  ///< Index in an image; of a continuous one.

/// Which pixels belong together.
class Groups {
 public:
  explicit Groups(int pixels) : parent_(static_cast<std::size_t>(pixels)) {
    std::iota(parent_.begin(), parent_.end(), Pixel{0});
  }
  /// The first pixel of the group.
  Pixel find(Pixel pixel) {
    while (parent(pixel) != pixel) pixel = parent(pixel) = parent(parent(pixel));
    return pixel;
  }
  void join(Pixel a, Pixel b) {
    a = find(a);
    b = find(b);
    parent(std::max(a, b)) = std::min(a, b);
  }

 private:
  Pixel& parent(Pixel pixel) { return parent_[static_cast<std::size_t>(pixel)]; }

  std::vector<Pixel> parent_;
};

class Labelling {
 public:
  Labelling(const cv::Mat& classIds, const cv::Mat& depth_m, const DepthLabelling& options)
      : size_(classIds.size()),
        classes_(classIds.ptr<core::ClassId>()),
        depth_m_(depth_m.ptr<float>()),
        options_(options),
        groups_(size_.area()),
        owner_(static_cast<std::size_t>(size_.area()), kNobody) {}

  cv::Mat label() {
    joinNeighbours([&](Pixel p) { return isMeasured(p); }, [&](Pixel a, Pixel b) { return isLevel(a, b); });
    joinAcrossGaps();
    claimLarge([&](Pixel p) { return isMeasured(p); });
    spread();
    const auto isLeft = [&](Pixel p) { return owner_[index(p)] == kNobody; };
    joinNeighbours([&](Pixel p) { return isLeft(p) && !isMeasured(p); }, [](Pixel, Pixel) { return true; });
    claimLarge([&](Pixel p) { return isLeft(p) && !isMeasured(p); });
    return number();
  }

 private:
  static constexpr Pixel kNobody = -1;

  static std::size_t index(Pixel p) { return static_cast<std::size_t>(p); }
  [[nodiscard]] bool isMeasured(Pixel p) const { return depth_m_[p] > 0.0F; }
  [[nodiscard]] bool isLevel(Pixel a, Pixel b) const {
    const float step_m = classes_[a] == options_.person ? kPersonStep_m : kThingStep_m;
    return std::abs(depth_m_[a] - depth_m_[b]) < step_m + kStepPerMetre * std::min(depth_m_[a], depth_m_[b]);
  }

  /// Pixels of one class side by side, where both are eligible and fit together.
  template <class Eligible, class Fit>
  void joinNeighbours(const Eligible& isEligible, const Fit& fits) {
    const auto tryJoin = [&](Pixel a, Pixel b) {
      if (classes_[a] == classes_[b] && isEligible(b) && fits(a, b)) groups_.join(a, b);
    };
    for (int y = 0; y < size_.height; ++y) {
      for (int x = 0; x < size_.width; ++x) {
        const Pixel p = y * size_.width + x;
        if (classes_[p] == 0 || !isEligible(p)) continue;
        if (x > 0) tryJoin(p, p - 1);
        if (y == 0) continue;
        tryJoin(p, p - size_.width);
        if (x > 0) tryJoin(p, p - size_.width - 1);
        if (x + 1 < size_.width) tryJoin(p, p - size_.width + 1);
      }
    }
  }

  void joinAcrossGaps() {
    for (int y = 0; y < size_.height; ++y) lookAlong(y * size_.width, 1, size_.width);
    for (int x = 0; x < size_.width; ++x) lookAlong(x, size_.width, size_.height);
    for (const auto& [parts, lines] : across_) {
      if (lines >= kLinesAcross) groups_.join(parts.first, parts.second);
    }
  }

  /// Along a row or a column: from each pixel to the last one of its class.
  void lookAlong(Pixel start, int stride, int count) {
    std::array<int, 256> last{};
    last.fill(-1);
    for (int i = 0; i < count; ++i) {
      const Pixel p = start + i * stride;
      const core::ClassId c = classes_[p];
      if (c == 0 || !isMeasured(p)) continue;
      const int before = std::exchange(last[c], i);
      if (before < 0 || before == i - 1) continue;
      const Pixel a = start + before * stride;
      if (groups_.find(a) != groups_.find(p) && isLevel(a, p) && isHidden(a, p, stride)) {
        ++across_[std::minmax(groups_.find(a), groups_.find(p))];
      }
    }
  }

  /// Whether one thing may go on behind what lies between these pixels.
  [[nodiscard]] bool isHidden(Pixel a, Pixel b, int stride) const {
    const float nearest_m = std::min(depth_m_[a], depth_m_[b]);
    const Pixel gap_px = (b - a) / stride;
    if (static_cast<double>(gap_px) * static_cast<double>(nearest_m) > kWidestGap_m * options_.focalLength_px)
      return false;
    for (Pixel p = a + stride; p < b; p += stride) {
      const bool isNearer = isMeasured(p) && depth_m_[p] < nearest_m - kInFront_m;
      const bool isShadow = !isMeasured(p) && classes_[p] == classes_[a];
      if (!isNearer && !isShadow) return false;
    }
    return true;
  }

  template <class Eligible>
  void claimLarge(const Eligible& isEligible) {
    std::vector<int> areas_px(owner_.size(), 0);
    for (Pixel p = 0; p < size_.area(); ++p) {
      if (classes_[p] != 0 && isEligible(p)) ++areas_px[index(groups_.find(p))];
    }
    for (Pixel p = 0; p < size_.area(); ++p) {
      const Pixel group = groups_.find(p);
      if (areas_px[index(group)] >= options_.minArea_px && classes_[p] != 0 && isEligible(p)) owner_[index(p)] = group;
    }
  }

  /// Owners take what nobody owns of their class, pixel by pixel outwards.
  void spread() {
    std::vector<Pixel> front;
    for (Pixel p = 0; p < size_.area(); ++p) {
      if (owner_[index(p)] != kNobody) front.push_back(p);
    }
    for (std::size_t i = 0; i < front.size(); ++i) {
      const Pixel p = front[i];
      const int x = p % size_.width;
      const auto take = [&](Pixel q) {
        if (classes_[q] != classes_[p] || owner_[index(q)] != kNobody) return;
        owner_[index(q)] = owner_[index(p)];
        front.push_back(q);
      };
      if (x > 0) take(p - 1);
      if (x + 1 < size_.width) take(p + 1);
      if (p >= size_.width) take(p - size_.width);
      if (p + size_.width < size_.area()) take(p + size_.width);
    }
  }

  [[nodiscard]] cv::Mat number() const {
    cv::Mat ids(size_, CV_16UC1, cv::Scalar(0));
    std::map<Pixel, std::uint16_t> idOf;
    auto* id = ids.ptr<std::uint16_t>();
    for (Pixel p = 0; p < size_.area(); ++p) {
      const Pixel owner = owner_[index(p)];
      if (owner == kNobody) continue;
      auto known = idOf.find(owner);
      if (known == idOf.end()) {
        if (idOf.size() == std::numeric_limits<std::uint16_t>::max()) continue;
        known = idOf.emplace(owner, static_cast<std::uint16_t>(idOf.size() + 1)).first;
      }
      id[p] = known->second;
    }
    return ids;
  }

  cv::Size size_;
  const core::ClassId* classes_;
  const float* depth_m_;
  DepthLabelling options_;
  Groups groups_;
  std::vector<Pixel> owner_;  ///< The first pixel of the thing each pixel belongs to.
  std::map<std::pair<Pixel, Pixel>, int> across_;
};

}  // namespace

cv::Mat labelByDepth(const cv::Mat& classIds, const cv::Mat& depth_m, const DepthLabelling& options) {
  const cv::Mat classes = classIds.isContinuous() ? classIds : classIds.clone();
  const cv::Mat depths_m = depth_m.isContinuous() ? depth_m : depth_m.clone();
  return Labelling(classes, depths_m, options).label();
}

}  // namespace wardslam::segmentation
