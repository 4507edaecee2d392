#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/core/keypoint.h"
#include "wardslam/core/options.h"
#include "wardslam/knowledge/motion_rules.h"

namespace wardslam::filters {

struct DynamicTestOptions {
  int n = 21;
  int delta = 55;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("n", self.n, {1, 255}, "px", "side of the square around a key point that is searched for movers; odd");
    visit("delta", self.delta, {0, 255 * 255 - 1}, "px",
          "a movable thing is dynamic with more mover pixels than this in the square; best n*n/8 to n*n/2");
  }
};

/// The dynamic test (Eq. 7–9, P7). A pixel is dynamic
///  - on a class that moves by itself, and
///  - on a movable class when N_p > δ, N_p being the number of pixels in the n×n square around it whose class, by the
///    knowledge graph, can move that class.
/// The square is upright (N_p hardly depends on its rotation) and cut at the image border, so that N_p comes out of
/// an integral image: the time per key point does not depend on n.
class DynamicTest {
 public:
  /// `n` must be odd.
  DynamicTest(const knowledge::MotionRules& rules, const DynamicTestOptions& options);
  DynamicTest(const DynamicTest&) = delete;
  DynamicTest& operator=(const DynamicTest&) = delete;
  DynamicTest(DynamicTest&&) = default;
  DynamicTest& operator=(DynamicTest&&) = default;

  /// The picture all following questions are about: CV_8UC1, ClassId per raw pixel. Keeps a reference.
  void setImage(const cv::Mat& classIds);

  /// Of a raw pixel; outside the image it is that of the nearest pixel inside. Not const: counts on first demand.
  [[nodiscard]] core::Motion at(cv::Point raw_px);

  /// at() of every pixel: CV_8UC1, 255 = dynamic. 0 where `decided` (likewise; empty: nothing is) is not 0: there
  /// nobody asks.
  [[nodiscard]] cv::Mat mask(const cv::Mat& decided = {});

  /// Marks the dynamic ones; what an earlier filter marked stays marked.
  void mark(std::vector<core::Keypoint>& keypoints);

 private:
  /// The classes that share one set of movers share one integral image.
  struct Movers {
    knowledge::ClassSet classes;
    cv::Mat isMover;   ///< 1×256, 1 where the class is in `classes`.
    cv::Mat integral;  ///< CV_32SC1, of the current image; empty = not yet needed.
  };
  static constexpr int kNobody = -1;

  [[nodiscard]] int countMovers(Movers& movers, cv::Point raw_px) const;

  DynamicTestOptions options_;
  knowledge::ClassSet moving_;
  std::vector<Movers> movers_;
  std::array<int, 256> moversOf_{};  ///< Index into movers_ of each movable class, else kNobody.
  cv::Mat classIds_;
};

}  // namespace wardslam::filters
