#include "wardslam/segmentation/semantic_decoder.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "wardslam/segmentation/instance_images.h"

namespace wardslam::segmentation {
namespace {

using Kind = SemanticLayout::Kind;

bool hasProportions(int width, int height, const cv::Size& input_px) {
  const auto difference = std::abs(std::int64_t{width} * input_px.height - std::int64_t{height} * input_px.width);
  return difference <= std::max(input_px.width, input_px.height);  // one pixel of rounding
}

/// Where image pixels lie in the output; pixel centres are whole numbers, as warpAffine wants it.
cv::Matx23d outputFromImage(const SemanticLayout& layout, const Letterbox& letterbox) {
  const double outputPerInputX = static_cast<double>(layout.size.width) / letterbox.input_px().width;
  const double outputPerInputY = static_cast<double>(layout.size.height) / letterbox.input_px().height;
  const double scaleX = letterbox.scaleX() * outputPerInputX;
  const double scaleY = letterbox.scaleY() * outputPerInputY;
  return {scaleX, 0.0,    0.5 * scaleX + letterbox.content_px().x * outputPerInputX - 0.5,
          0.0,    scaleY, 0.5 * scaleY + letterbox.content_px().y * outputPerInputY - 0.5};
}

/// One picture of scores per class.
std::vector<cv::Mat> scorePlanes(const cv::Mat& output, const SemanticLayout& layout) {
  std::vector<cv::Mat> planes;
  if (layout.kind == Kind::ScoresLast) {
    cv::split(output.reshape(layout.classes, {layout.size.height, layout.size.width}), planes);
    return planes;
  }
  for (int c = 0; c < layout.classes; ++c) {
    planes.emplace_back(layout.size, CV_32F, const_cast<float*>(output.ptr<float>(0, c)));
  }
  return planes;
}

/// Index of the largest of several pictures, per pixel; CV_32F. Where all are NaN: 0.
class BestOf {
 public:
  explicit BestOf(const cv::Size& size)
      : score_(size, CV_32F, cv::Scalar(-std::numeric_limits<double>::infinity())),
        index_(size, CV_32F, cv::Scalar(0)) {}

  void add(const cv::Mat& scores, int index) {
    const cv::Mat isBetter = scores > score_;
    scores.copyTo(score_, isBetter);
    index_.setTo(index, isBetter);
  }
  [[nodiscard]] const cv::Mat& index() const { return index_; }

 private:
  cv::Mat score_;
  cv::Mat index_;
};

cv::Mat bestClasses(const std::vector<cv::Mat>& planes, const cv::Matx23d& fromImage, const cv::Size& image_px) {
  BestOf coarse(planes.front().size());
  for (std::size_t c = 0; c < planes.size(); ++c) coarse.add(planes[c], static_cast<int>(c));

  BestOf fine(image_px);
  cv::Mat resampled;
  for (std::size_t c = 0; c < planes.size(); ++c) {
    if (cv::countNonZero(coarse.index() == static_cast<double>(c)) == 0) continue;
    cv::warpAffine(planes[c], resampled, fromImage, image_px, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                   cv::BORDER_REPLICATE);
    fine.add(resampled, static_cast<int>(c));
  }
  return fine.index();
}

}  // namespace

std::optional<SemanticLayout> SemanticLayout::fromShape(const std::vector<int>& shape, const cv::Size& input_px) {
  const bool isSound = (shape.size() == 3 || shape.size() == 4) && shape[0] == 1 &&
                       std::all_of(shape.begin(), shape.end(), [](int extent) { return extent > 0; });
  if (!isSound) return std::nullopt;
  if (shape.size() == 3) return SemanticLayout{Kind::ClassMap, 0, {shape[2], shape[1]}};
  if (shape[1] == 1) return SemanticLayout{Kind::ClassMap, 0, {shape[3], shape[2]}};
  if (shape[3] == 1) return SemanticLayout{Kind::ClassMap, 0, {shape[2], shape[1]}};
  const bool fitsFirst = hasProportions(shape[3], shape[2], input_px);
  const bool fitsLast = hasProportions(shape[2], shape[1], input_px);
  if (fitsLast && !fitsFirst) return SemanticLayout{Kind::ScoresLast, shape[3], {shape[2], shape[1]}};
  return SemanticLayout{Kind::ScoresFirst, shape[1], {shape[3], shape[2]}};
}

core::Segmentation decodeSemantic(const cv::Mat& output, const SemanticLayout& layout, const Letterbox& letterbox,
                                  const LabelMap& labels, int minRegion_px) {
  const cv::Matx23d fromImage = outputFromImage(layout, letterbox);
  core::Segmentation segmentation;
  if (layout.kind == Kind::ClassMap) {
    const cv::Mat indices(layout.size, CV_32F, const_cast<float*>(output.ptr<float>()));
    cv::warpAffine(labels.apply(indices), segmentation.classIds, fromImage, letterbox.image_px(),
                   cv::INTER_NEAREST | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  } else {
    segmentation.classIds = labels.apply(bestClasses(scorePlanes(output, layout), fromImage, letterbox.image_px()));
  }
  segmentation.instanceIds = labelRegions(segmentation.classIds, minRegion_px);
  segmentation.instances = listInstances(segmentation.classIds, segmentation.instanceIds);
  return segmentation;
}

}  // namespace wardslam::segmentation
