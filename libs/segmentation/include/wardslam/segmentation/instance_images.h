#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/core/segmentation.h"

namespace wardslam::segmentation {

/// The instances in a pair of images (CV_8UC1 class ids, CV_16UC1 instance ids, same size), in order of id, confidence
/// 1. Where pixels of one instance differ in class, the class of most of them counts. Instance ids on pixels without a
/// class are set to 0, so that every id left in the image is in the list.
[[nodiscard]] std::vector<core::Instance> listInstances(const cv::Mat& classIds, cv::Mat& instanceIds);

/// Instance ids (CV_16UC1) for an image of class ids (CV_8UC1): each 8-connected region of one class is an instance,
/// numbered from 1. Regions smaller than `minArea_px` get none.
[[nodiscard]] cv::Mat labelRegions(const cv::Mat& classIds, int minArea_px);

}  // namespace wardslam::segmentation
