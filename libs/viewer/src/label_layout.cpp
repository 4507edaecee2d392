#include "wardslam/viewer/label_layout.h"

#include <algorithm>

namespace wardslam::viewer {
namespace {

constexpr int kRows = 8;      ///< So many lines of text up and down a label may go,
constexpr int kQuarters = 4;  ///< and so many quarters of its length to either side.
constexpr int kGap_px = 1;

/// Shifts of a label, nearest first.
std::vector<cv::Point> shiftsOf(const cv::Size& label) {
  std::vector<cv::Point> shifts;
  for (int row = -kRows; row <= kRows; ++row) {
    for (int quarter = -kQuarters; quarter <= kQuarters; ++quarter) {
      shifts.emplace_back(quarter * label.width / kQuarters, row * (label.height + kGap_px));
    }
  }
  std::stable_sort(shifts.begin(), shifts.end(),
                   [](const cv::Point& a, const cv::Point& b) { return a.dot(a) < b.dot(b); });
  return shifts;
}

/// Moved into the picture, or to its upper left corner where it is larger.
cv::Rect within(cv::Rect label, const cv::Size& picture) {
  label.x = std::clamp(label.x, 0, std::max(0, picture.width - label.width));
  label.y = std::clamp(label.y, 0, std::max(0, picture.height - label.height));
  return label;
}

}  // namespace

std::vector<cv::Rect> movedApart(const std::vector<cv::Rect>& wanted, const cv::Size& picture) {
  std::vector<cv::Rect> placed;
  for (const cv::Rect& wish : wanted) {
    const auto isFree = [&](const cv::Rect& place) {
      return std::none_of(placed.begin(), placed.end(),
                          [&](const cv::Rect& other) { return !(other & place).empty(); });
    };
    cv::Rect place = within(wish, picture);
    for (const cv::Point& shift : shiftsOf(wish.size())) {
      const cv::Rect candidate = within(wish + shift, picture);
      if (!isFree(candidate)) continue;
      place = candidate;
      break;
    }
    placed.push_back(place);
  }
  return placed;
}

}  // namespace wardslam::viewer
