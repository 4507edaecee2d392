#include "wardslam/segmentation/recorded_masks.h"

#include <cstdio>
#include <sstream>

#include "mask_file.h"
#include "mask_survey.h"
#include "wardslam/core/errors.h"
#include "wardslam/segmentation/instance_images.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;

// Absolute and without a trailing slash, so that it has a parent where the siblings are.
fs::path normalised(const std::string& folder) {
  if (folder.empty()) throw core::InputError("recorded masks need the folder that holds them (recorded_masks.folder)");
  const fs::path path = fs::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

LabelMap readLabels(const fs::path& masksFolder, const fs::path& classesFile) {
  constexpr int kFirstId = 0;  // without a mapping, grey values are class ids
  if (!classesFile.empty()) return LabelMap::fromFile(classesFile, kFirstId);
  const fs::path sibling = masksFolder.parent_path() / "classes.txt";
  return fs::exists(sibling) ? LabelMap::fromFile(sibling, kFirstId)
                             : LabelMap::consecutive(core::LabelSpace::coco(), kFirstId);
}

std::string sizeText(const cv::Mat& image) { return std::to_string(image.cols) + "x" + std::to_string(image.rows); }

std::string stampText(double stamp_s) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6f", stamp_s);
  return text;
}

std::string onlyNameless(const fs::path& file, core::ClassId id) {
  return file.string() + ": holds grey value " + std::to_string(id) +
         ", and no class has that number; save class ids as grey values (1 is person), or say what it means with "
         "--classes FILE or in classes.txt";
}

// Takes out what has no name. The first such id; 0 when there is none.
core::ClassId removeNameless(cv::Mat& classIds, const core::LabelSpace& labels) {
  cv::Mat table(1, 256, CV_8UC1);
  for (int c = 0; c < table.cols; ++c) {
    const auto id = static_cast<core::ClassId>(c);
    table.at<core::ClassId>(0, c) = labels.name(id).empty() ? core::ClassId{0} : id;
  }
  cv::Mat named;
  cv::LUT(classIds, table, named);
  cv::Mat nameless;
  cv::findNonZero(named != classIds, nameless);
  const core::ClassId first =
      nameless.empty() ? core::ClassId{0} : classIds.at<core::ClassId>(nameless.at<cv::Point>(0));
  classIds = named;
  return first;
}

}  // namespace

RecordedMasks::RecordedMasks(const RecordedMasksOptions& options, const fs::path& classesFile)
    : folder_(normalised(options.folder)),
      options_(options),
      masks_(folder_, ".png", options.rate_hz),
      labels_(readLabels(folder_, classesFile)) {
  const fs::path instances = folder_.parent_path() / "instances";
  if (fs::is_directory(instances)) instancesFolder_ = instances;

  notes_ = surveyMasks(folder_, masks_, labels_);
}

Segmenter::Result RecordedMasks::segment(const SegmenterInput& input) {
  const auto file = masks_.nearest(input.stamp_s, options_.tolerance_ms * 1e-3);
  if (!file) return miss("segmentation.mask_missing", describeNoMatch(input.stamp_s));

  constexpr const char* kUnreadable = "segmentation.mask_unreadable";
  MaskFile mask = readMaskFile(*file);
  if (mask.values.empty()) return miss(kUnreadable, mask.trouble);
  cv::Mat classIds = mask.values;
  if (classIds.size() != input.color_bgr.size()) {
    return miss(kUnreadable, file->string() + ": is " + sizeText(classIds) + ", but the image it belongs to is " +
                                 sizeText(input.color_bgr) + "; give masks made from images of that size");
  }
  classIds = labels_.apply(classIds);
  Result result;
  if (const core::ClassId nameless = removeNameless(classIds, labels_.labels())) {
    constexpr const char* kNameless = "segmentation.class_without_name";
    if (cv::countNonZero(classIds) == 0) return miss(kNameless, onlyNameless(*file, nameless));
    ++result.events[kNameless];
  }
  usedAny_ = true;
  result.segmentation.classIds = classIds;
  result.segmentation.instanceIds = readInstanceIds(*file, classIds, result.events);
  result.segmentation.instances = listInstances(classIds, result.segmentation.instanceIds);
  return result;
}

void RecordedMasks::finish() {
  if (!usedAny_ && missesFromStart_ > 0) throw core::InputError(firstMiss_);
}

cv::Mat RecordedMasks::readInstanceIds(const fs::path& maskFile, const cv::Mat& classIds,
                                       core::EventCounts& events) const {
  if (!instancesFolder_.empty()) {
    cv::Mat ids = readUnchanged(instancesFolder_ / maskFile.filename());
    if (ids.type() == CV_8UC1) ids.convertTo(ids, CV_16U);
    if (ids.type() == CV_16UC1 && ids.size() == classIds.size()) return ids;
    ++events["segmentation.instances_unreadable"];
  }
  return labelRegions(classIds, options_.min_region_px);
}

Segmenter::Result RecordedMasks::miss(const char* event, const std::string& reason) {
  if (!usedAny_) {
    if (missesFromStart_++ == 0) firstMiss_ = reason;
    if (missesFromStart_ >= kPatience) throw core::InputError(firstMiss_);
  }
  return {{}, {{event, 1}}};
}

std::string RecordedMasks::describeNoMatch(double stamp_s) const {
  std::ostringstream sentence;
  const bool isNumbered = masks_.clock().unit() == core::StampUnit::Frames;
  sentence << folder_.string() << ": no mask within " << options_.tolerance_ms << " ms of the first image ("
           << stampText(stamp_s) << ") nor of those after it, as the masks run from "
           << stampText(masks_.firstStamp_s()) << " to " << stampText(masks_.lastStamp_s())
           << (isNumbered ? "; they are numbered: name them by the stamps of their colour images"
                          : "; give the masks folder of this recording");
  return sentence.str();
}

}  // namespace wardslam::segmentation
