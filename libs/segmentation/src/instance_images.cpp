#include "wardslam/segmentation/instance_images.h"

#include <array>
#include <limits>
#include <map>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace wardslam::segmentation {
namespace {

struct Extent {
  int area_px = 0;
  cv::Rect box_px;
};

// Ordered by instance, then class.
using Extents = std::map<std::pair<std::uint16_t, core::ClassId>, Extent>;

// Looks up once per run of equal pixels, not per pixel.
void addRow(Extents& extents, const core::ClassId* classes, std::uint16_t* ids, int width, int y) {
  for (int begin = 0, end = 0; begin < width; begin = end) {
    for (end = begin; end < width && classes[end] == classes[begin] && ids[end] == ids[begin];) ++end;
    if (ids[begin] == 0) continue;
    if (classes[begin] == 0) {
      std::fill(ids + begin, ids + end, std::uint16_t{0});
      continue;
    }
    Extent& extent = extents[{ids[begin], classes[begin]}];
    extent.area_px += end - begin;
    extent.box_px |= cv::Rect(begin, y, end - begin, 1);
  }
}

std::array<bool, 256> classesPresent(const cv::Mat& classIds) {
  std::array<bool, 256> present{};
  for (int y = 0; y < classIds.rows; ++y) {
    const auto* row = classIds.ptr<core::ClassId>(y);
    for (int x = 0; x < classIds.cols; ++x) present[row[x]] = true;
  }
  return present;
}

}  // namespace

std::vector<core::Instance> listInstances(const cv::Mat& classIds, cv::Mat& instanceIds) {
  Extents extents;
  for (int y = 0; y < classIds.rows; ++y) {
    addRow(extents, classIds.ptr<core::ClassId>(y), instanceIds.ptr<std::uint16_t>(y), classIds.cols, y);
  }
  std::vector<core::Instance> instances;
  int classArea_px = 0;
  for (const auto& [key, extent] : extents) {
    const auto& [id, classId] = key;
    if (instances.empty() || instances.back().id != id) {
      instances.push_back({id, classId, 1.0F, extent.box_px});
      classArea_px = extent.area_px;
      continue;
    }
    instances.back().box_px |= extent.box_px;
    if (extent.area_px > classArea_px) {
      instances.back().classId = classId;
      classArea_px = extent.area_px;
    }
  }
  return instances;
}

cv::Mat labelRegions(const cv::Mat& classIds, int minArea_px) {
  cv::Mat instanceIds(classIds.size(), CV_16UC1, cv::Scalar(0));
  const auto present = classesPresent(classIds);
  std::uint16_t lastId = 0;
  for (int classId = 1; classId < static_cast<int>(present.size()); ++classId) {
    if (!present[static_cast<std::size_t>(classId)]) continue;
    const cv::Mat mask = classIds == classId;
    const cv::Rect area = cv::boundingRect(mask);
    cv::Mat labels;
    cv::Mat statistics;
    cv::Mat centroids;
    const int count = cv::connectedComponentsWithStats(mask(area), labels, statistics, centroids, 8, CV_32S);
    for (int label = 1; label < count && lastId < std::numeric_limits<std::uint16_t>::max(); ++label) {
      const int* region = statistics.ptr<int>(label);
      if (region[cv::CC_STAT_AREA] < minArea_px) continue;
      const cv::Rect box(region[cv::CC_STAT_LEFT], region[cv::CC_STAT_TOP], region[cv::CC_STAT_WIDTH],
                         region[cv::CC_STAT_HEIGHT]);
      instanceIds(box + area.tl()).setTo(++lastId, labels(box) == label);
    }
  }
  return instanceIds;
}

}  // namespace wardslam::segmentation
