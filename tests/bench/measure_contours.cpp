// measure_contours DIR MASKS [--camera FILE] [--every N] [--pictures FOLDER]: what refined contours are worth. DIR is a
// recording in the layout of the TUM benchmark with true class ids in masks/. MASKS is a YOLO-seg network (.onnx), or a
// folder of masks. People are compared to the truth before and after: those found that are no people at all (less than
// half of the mask on one) are left out, as no contour can mend them. Prints one row of a Markdown table:
//
//   sequence | IoU | boundary F within 2 px | boundary F within 6 px (DAVIS) | background taken, px per image |
//   recall | ms
//
// each before → after; ms is the median CPU time. --pictures: before and after side by side, right pixels green, wrong
// ones red, missed ones blue.

#include <CLI/CLI.hpp>
#include <algorithm>

#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "boundary_agreement.h"
#include "wardslam/core/frame.h"
#include "wardslam/evaluation/detection_score.h"
#include "wardslam/masks/contour_refiner.h"
#include "wardslam/segmentation/recorded_masks.h"
#include "wardslam/segmentation/yolo_segmenter.h"
#include "wardslam/sources/frame_builder.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;

constexpr core::ClassId kPerson = 1;

struct Arguments {
  fs::path recording;
  fs::path masks;
  sources::SourceOptions source;
  std::size_t every = 1;
  fs::path pictures;
};

std::unique_ptr<segmentation::Segmenter> openMasks(const fs::path& path) {
  if (path.extension() == ".onnx") {
    segmentation::YoloOptions options;
    options.model = path.string();
    return std::make_unique<segmentation::YoloSegmenter>(options);
  }
  segmentation::RecordedMasksOptions options;
  options.folder = path.string();
  return std::make_unique<segmentation::RecordedMasks>(options);
}

/// Adds up over the images.
struct Score {
  evaluation::DetectionScore pixels;
  double near = 0.0;
  double davis = 0.0;

  void add(const cv::Mat& truth, const cv::Mat& estimate) {
    constexpr int kNear_px = 2;
    pixels += evaluation::comparePixels(estimate, truth);
    near += evaluation::compareBoundaries(estimate, truth, kNear_px).f;
    davis += evaluation::compareBoundaries(estimate, truth, evaluation::davisTolerance_px(truth.size())).f;
  }
};

void keepTruePeople(core::Segmentation& found, const cv::Mat& truth) {
  const auto isWrong = [&](const core::Instance& instance) {
    if (instance.classId != kPerson) return false;
    const cv::Mat mask = found.instanceIds == instance.id;
    return 2 * cv::countNonZero(mask & truth) < cv::countNonZero(mask);
  };
  auto& instances = found.instances;
  const auto end =
      std::stable_partition(instances.begin(), instances.end(), [&](const auto& i) { return !isWrong(i); });
  for (auto wrong = end; wrong != instances.end(); ++wrong) {
    const cv::Mat mask = found.instanceIds == wrong->id;
    found.classIds.setTo(0, mask);
    found.instanceIds.setTo(0, mask);
  }
  instances.erase(end, instances.end());
}

/// Right pixels green, wrong ones red, missed ones blue.
cv::Mat draw(const cv::Mat& color_bgr, const cv::Mat& truth, const cv::Mat& estimate) {
  cv::Mat paint = color_bgr.clone();
  paint.setTo(cv::Scalar(0, 160, 0), truth & estimate);
  paint.setTo(cv::Scalar(0, 0, 255), estimate & ~truth);
  paint.setTo(cv::Scalar(255, 0, 0), truth & ~estimate);
  cv::Mat picture;
  cv::addWeighted(color_bgr, 0.5, paint, 0.5, 0.0, picture);
  return picture;
}

struct Measurement {
  Score before;
  Score after;
  std::vector<double> times_ms;

  void add(const Arguments& arguments, core::Frame& frame, const cv::Mat& truth) {
    const masks::ContourRefiner refiner({}, masks::ContourRefiner::ClassSet().set(kPerson));
    const std::clock_t start = std::clock();
    const core::Segmentation refined =
        refiner.refine(frame.color_bgr, frame.depth_m, frame.camera.depthNoise, frame.segmentation);
    times_ms.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    const cv::Mat first = frame.segmentation.classIds == kPerson;
    const cv::Mat second = refined.classIds == kPerson;
    before.add(truth, first);
    after.add(truth, second);
    if (arguments.pictures.empty()) return;
    cv::Mat both;
    cv::hconcat(draw(frame.color_bgr, truth, first), draw(frame.color_bgr, truth, second), both);
    cv::imwrite((arguments.pictures / (std::to_string(frame.index) + ".jpg")).string(), both);
  }

  void print(const std::string& name) {
    if (times_ms.empty()) throw std::runtime_error(name + ": no image with people in both masks");
    const double n = static_cast<double>(times_ms.size());
    const auto middle = times_ms.begin() + static_cast<std::ptrdiff_t>(times_ms.size() / 2);
    std::nth_element(times_ms.begin(), middle, times_ms.end());
    std::printf("| %s | %.3f → %.3f | %.3f → %.3f | %.3f → %.3f | %.0f → %.0f | %.3f → %.3f | %.2f |\n", name.c_str(),
                before.pixels.iou(), after.pixels.iou(), before.near / n, after.near / n, before.davis / n,
                after.davis / n, static_cast<double>(before.pixels.falsePositives) / n,
                static_cast<double>(after.pixels.falsePositives) / n, before.pixels.recall(), after.pixels.recall(),
                *middle);
  }
};

Measurement measure(const Arguments& arguments) {
  const auto source = sources::openSource(arguments.recording, arguments.source);
  const auto truth = openMasks(arguments.recording / "masks");
  const auto masks = openMasks(arguments.masks);
  sources::FrameBuilder builder;
  Measurement measurement;
  for (std::size_t i = 0; const auto observation = source->next(); ++i) {
    if (i % arguments.every != 0) continue;
    core::Frame frame = builder.build(observation);
    const cv::Mat people = truth->segment(segmentation::inputOf(frame)).segmentation.classIds == kPerson;
    frame.segmentation = masks->segment(segmentation::inputOf(frame)).segmentation;
    if (people.empty() || frame.segmentation.empty()) continue;
    keepTruePeople(frame.segmentation, people);
    if (cv::countNonZero(frame.segmentation.classIds == kPerson) > 0) measurement.add(arguments, frame, people);
  }
  return measurement;
}

}  // namespace
}  // namespace wardslam

int main(int argc, char** argv) try {
  wardslam::Arguments arguments;
  CLI::App app("What refined contours are worth");
  app.add_option("DIR", arguments.recording)->required();
  app.add_option("MASKS", arguments.masks)->required();
  app.add_option("--camera", arguments.source.camera);
  app.add_option("--every", arguments.every)->check(CLI::PositiveNumber);
  app.add_option("--pictures", arguments.pictures)->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv)
  cv::setNumThreads(1);  // figures are for one core
  wardslam::measure(arguments).print(arguments.recording.filename().string());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "measure_contours: %s\n", error.what());
  return 1;
}
