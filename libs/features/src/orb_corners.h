#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace wardslam::features {

/// Side of the patch around a corner that tells its direction and is described.
constexpr int kOrbPatch_px = 31;

/// The image and ever smaller copies of it, each made of the one before, of the sizes that cv::ORB describes key points
/// in. Ends early where a copy would have no room for a patch. CV_8UC1.
[[nodiscard]] std::vector<cv::Mat> orbPyramid(const cv::Mat& gray, double scaleFactor, int levels);

/// FAST corners of one copy that have room for a patch around them, in its own pixels: the `most` with the strongest
/// response, which is Harris', and such as are as strong as the last of these. Ranked by FAST's own response,
/// trajectories of a real camera that turns fast are a quarter worse.
[[nodiscard]] std::vector<cv::KeyPoint> strongestCorners(const cv::Mat& level, int fastThreshold, std::size_t most);

/// Eq. 3–5: the direction from a pixel to the centroid of the grey values in the circle around it, 31 px wide; 0 to 360
/// degrees, 90 is down. The circle must be in the image.
[[nodiscard]] float centroidAngle_deg(const cv::Mat& level, const cv::Point& centre);

}  // namespace wardslam::features
