// measure_people DIR NETWORK... [--camera FILE] [--every N] [--also NETWORK] [--refine] [--pictures FOLDER]: how well
// networks find people, side by side on the same images. DIR is a recording in the layout of the TUM benchmark with
// true class ids in masks/ (and instances/), if any. A NETWORK is "depth" (the one that comes with the program) or a
// YOLO-seg network
// (.onnx). --also: what this network calls a person is one, too, labelled or not. --refine: with contours refined as in
// a run. Prints a row of a Markdown table for each:
//
//   sequence | network | IoU | recall | precision | false, % of all pixels | people found of those with 300 px | ms
//
// Found: more than half of the pixels. ms is the median CPU time, on one core.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <string>
#include <vector>

#include "wardslam/core/frame.h"
#include "wardslam/masks/contour_refiner.h"
#include "wardslam/segmentation/depth_segmenter.h"
#include "wardslam/segmentation/recorded_masks.h"
#include "wardslam/segmentation/yolo_segmenter.h"
#include "wardslam/sources/frame_builder.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;

constexpr core::ClassId kPerson = 1;
constexpr int kMinPerson_px = 300;
constexpr double kSureOfPerson = 0.3;  ///< From which --also adds to the truth.

struct Arguments {
  fs::path recording;
  std::vector<std::string> networks;
  std::string also;
  sources::SourceOptions source;
  std::size_t every = 1;
  bool refine = false;
  fs::path pictures;
};

std::unique_ptr<segmentation::Segmenter> open(const std::string& network, double confidence = 0.15) {
  if (network == "depth") return std::make_unique<segmentation::DepthSegmenter>(segmentation::DepthOptions{});
  segmentation::YoloOptions options;
  options.model = network;
  options.decoder.confidence = confidence;
  return std::make_unique<segmentation::YoloSegmenter>(options);
}

/// Null where nobody is labelled.
std::unique_ptr<segmentation::Segmenter> openTruth(const fs::path& folder) {
  if (!fs::is_directory(folder)) return nullptr;
  segmentation::RecordedMasksOptions options;
  options.folder = folder.string();
  return std::make_unique<segmentation::RecordedMasks>(options);
}

struct Tally {
  std::string name;
  std::unique_ptr<segmentation::Segmenter> network;
  double hits = 0.0;
  double missed = 0.0;
  double wrong = 0.0;
  double pixels = 0.0;
  int found = 0;
  int people = 0;
  std::vector<double> times_ms;

  void add(const cv::Mat& seen, const cv::Mat& truth, const cv::Mat& instanceIds) {
    hits += cv::countNonZero(seen & truth);
    missed += cv::countNonZero(truth & ~seen);
    wrong += cv::countNonZero(seen & ~truth);
    pixels += static_cast<double>(truth.total());
    std::set<int> ids;
    for (int y = 0; y < instanceIds.rows; ++y) {
      for (int x = 0; x < instanceIds.cols; ++x) ids.insert(instanceIds.at<std::uint16_t>(y, x));
    }
    for (const int id : ids) {
      const cv::Mat person = (instanceIds == id) & truth;
      const int size_px = cv::countNonZero(person);
      if (id == 0 || size_px < kMinPerson_px) continue;
      ++people;
      if (2 * cv::countNonZero(person & seen) > size_px) ++found;
    }
  }

  void print(const std::string& sequence) {
    const auto middle = times_ms.begin() + static_cast<std::ptrdiff_t>(times_ms.size() / 2);
    std::nth_element(times_ms.begin(), middle, times_ms.end());
    std::printf("| %s | %s | %.3f | %.3f | %.3f | %.2f | %d of %d | %.1f |\n", sequence.c_str(), name.c_str(),
                hits / std::max(1.0, hits + missed + wrong), hits / std::max(1.0, hits + missed),
                hits / std::max(1.0, hits + wrong), 100.0 * wrong / pixels, found, people, *middle);
  }
};

/// Seen pixels: right ones green, wrong ones red, missed ones blue.
cv::Mat draw(const cv::Mat& color_bgr, const cv::Mat& truth, const cv::Mat& seen) {
  cv::Mat paint = color_bgr.clone();
  paint.setTo(cv::Scalar(0, 160, 0), truth & seen);
  paint.setTo(cv::Scalar(0, 0, 255), seen & ~truth);
  paint.setTo(cv::Scalar(255, 0, 0), truth & ~seen);
  cv::Mat picture;
  cv::addWeighted(color_bgr, 0.5, paint, 0.5, 0.0, picture);
  return picture;
}

void measure(const Arguments& arguments) {
  const auto source = sources::openSource(arguments.recording, arguments.source);
  const auto labelled = openTruth(arguments.recording / "masks");
  const auto also = arguments.also.empty() ? nullptr : open(arguments.also, kSureOfPerson);
  const masks::ContourRefiner refiner({}, masks::ContourRefiner::ClassSet().set(kPerson));
  std::vector<Tally> tallies;
  for (const auto& network : arguments.networks) {
    tallies.emplace_back();
    tallies.back().name = fs::path(network).stem().string();
    tallies.back().network = open(network);
  }
  sources::FrameBuilder builder;
  for (std::size_t i = 0; const auto observation = source->next(); ++i) {
    if (i % arguments.every != 0) continue;
    const core::Frame frame = builder.build(observation);
    const auto input = segmentation::inputOf(frame);
    const auto truth = labelled ? labelled->segment(input).segmentation : core::Segmentation{};
    cv::Mat people = truth.empty() ? cv::Mat::zeros(frame.gray.size(), CV_8UC1) : cv::Mat(truth.classIds == kPerson);
    const cv::Mat ids = truth.empty() ? cv::Mat::zeros(frame.gray.size(), CV_16UC1) : truth.instanceIds;
    if (also) people |= also->segment(input).segmentation.classIds == kPerson;
    for (Tally& tally : tallies) {
      const std::clock_t start = std::clock();
      auto seen = tally.network->segment(input).segmentation;
      if (arguments.refine) seen = refiner.refine(frame.color_bgr, frame.depth_m, frame.camera.depthNoise, seen);
      tally.times_ms.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
      const cv::Mat person = seen.empty() ? cv::Mat::zeros(people.size(), CV_8UC1) : cv::Mat(seen.classIds == kPerson);
      tally.add(person, people, ids);
      if (arguments.pictures.empty()) continue;
      const auto file = arguments.pictures / (tally.name + "_" + std::to_string(i) + ".jpg");
      cv::imwrite(file.string(), draw(frame.color_bgr, people, person));
    }
  }
  for (Tally& tally : tallies) tally.print(fs::absolute(arguments.recording).lexically_normal().filename().string());
}

}  // namespace
}  // namespace wardslam

int main(int argc, char** argv) try {
  wardslam::Arguments arguments;
  CLI::App app("How well networks find people");
  app.add_option("DIR", arguments.recording)->required();
  app.add_option("NETWORK", arguments.networks)->required();
  app.add_option("--camera", arguments.source.camera);
  app.add_option("--every", arguments.every)->check(CLI::PositiveNumber);
  app.add_option("--also", arguments.also);
  app.add_flag("--refine", arguments.refine);
  app.add_option("--pictures", arguments.pictures)->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv)
  cv::setNumThreads(1);  // figures are for one core
  wardslam::measure(arguments);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "measure_people: %s\n", error.what());
  return 1;
}
