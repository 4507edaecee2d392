#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

/// What all pictures are drawn with.
namespace wardslam::viewer {

inline const cv::Scalar kPaper(32, 30, 28);
inline const cv::Scalar kInk(245, 245, 245);
constexpr double kPaperOpacity = 0.72;
constexpr double kTextScale = 0.4;
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr int kPadding_px = 3;

/// Paints over the picture (CV_8UC3) where the mask says so; an empty mask means all of it.
void blend(cv::Mat picture, const cv::Scalar& color, double opacity, const cv::Mat& mask = {});

/// The strip of paper that a line of text needs.
[[nodiscard]] cv::Size tagSize(const std::string& text);

/// One line of text on a strip of paper; `corner` is its top left and is moved where the picture ends.
void writeTag(cv::Mat& picture, const std::string& text, cv::Point corner, const cv::Scalar& paper);

}  // namespace wardslam::viewer
