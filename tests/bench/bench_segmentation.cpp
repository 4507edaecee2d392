// Budgets at 640x480: from output tensors to masks at most 5 ms for 10 instances; contour refinement at most 3 ms; from
// depth image to the channels of the depth network at most 1 ms.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "depth_decoder.h"
#include "depth_instances.h"
#include "wardslam/masks/contour_refiner.h"
#include "wardslam/segmentation/depth_channels.h"
#include "wardslam/segmentation/mask_rcnn_decoder.h"
#include "wardslam/segmentation/semantic_decoder.h"
#include "wardslam/segmentation/yolo_decoder.h"

namespace wardslam::segmentation {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kPrototypes = 32;
constexpr int kCocoClasses = 80;
constexpr int kAnchorsPerInstance = 12;  // before non-maximum suppression

/// Ten people, 120x360 pixels each, side by side with some overlap.
std::vector<cv::Rect2f> people(int count) {
  std::vector<cv::Rect2f> boxes;
  for (int i = 0; i < count; ++i) {
    boxes.emplace_back(static_cast<float>((i * 55) % 520), static_cast<float>(40 + 7 * i), 120.0F, 360.0F);
  }
  return boxes;
}

/// What YOLOv8-seg puts out for these boxes; scores elsewhere are noise below the threshold.
cv::Mat yoloDetections(const std::vector<cv::Rect2f>& boxes) {
  const int anchors = kWidth * kHeight * (64 + 16 + 4) / (64 * 64);  // strides 8, 16 and 32
  cv::Mat tensor({1, 4 + kCocoClasses + kPrototypes, anchors}, CV_32F);
  cv::RNG random(1);
  random.fill(tensor, cv::RNG::UNIFORM, 0.0, 0.1);
  for (std::size_t i = 0; i < boxes.size() * kAnchorsPerInstance; ++i) {
    const cv::Rect2f& box = boxes[i / kAnchorsPerInstance];
    const float jitter = random.uniform(-4.0F, 4.0F);
    const int anchor = static_cast<int>(i * 37) % anchors;
    const float values[] = {box.x + box.width / 2 + jitter, box.y + box.height / 2, box.width, box.height,
                            random.uniform(0.4F, 0.9F)};
    for (int value = 0; value < 5; ++value) tensor.at<float>(0, value, anchor) = values[value];
    for (int p = 0; p < kPrototypes; ++p) {
      tensor.at<float>(0, 4 + kCocoClasses + p, anchor) = random.uniform(-1.0F, 1.0F);
    }
  }
  return tensor;
}

void decodeYoloV8(benchmark::State& state) {
  const cv::Mat detections = yoloDetections(people(static_cast<int>(state.range(0))));
  cv::Mat prototypes({1, kPrototypes, kHeight / 4, kWidth / 4}, CV_32F);
  cv::RNG(2).fill(prototypes, cv::RNG::UNIFORM, -1.0, 1.5);
  const auto layout =
      YoloLayout::fromShapes({1, detections.size[1], detections.size[2]}, {1, kPrototypes, kHeight / 4, kWidth / 4});
  const Letterbox letterbox({kWidth, kHeight}, {kWidth, kHeight});
  const auto labels = LabelMap::consecutive(core::LabelSpace::coco());
  std::size_t instances = 0;
  for (auto _ : state) {
    const auto segmentation = decodeYolo(detections, prototypes, *layout, letterbox, labels, {});
    instances = segmentation.instances.size();
  }
  state.counters["instances"] = static_cast<double>(instances);
}
BENCHMARK(decodeYoloV8)->Arg(0)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);

void decodeMaskRcnnInceptionV2(benchmark::State& state) {
  const auto boxes = people(static_cast<int>(state.range(0)));
  cv::Mat detections({1, 1, 100, 7}, CV_32F, cv::Scalar(0));
  cv::Mat masks({100, 90, 15, 15}, CV_32F);
  cv::RNG(3).fill(masks, cv::RNG::UNIFORM, 0.0, 1.2);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const cv::Rect2f& box = boxes[i];
    const float values[] = {0.0F,
                            0.0F,
                            0.9F,
                            box.x / kWidth,
                            box.y / kHeight,
                            (box.x + box.width) / kWidth,
                            (box.y + box.height) / kHeight};
    std::copy(values, values + 7, detections.ptr<float>() + 7 * i);
  }
  const auto labels = LabelMap::fromFile("labels/coco90.yaml");
  std::size_t instances = 0;
  for (auto _ : state) {
    const auto segmentation = decodeMaskRcnn(detections, masks, labels, {kWidth, kHeight}, {});
    instances = segmentation.instances.size();
  }
  state.counters["instances"] = static_cast<double>(instances);
}
BENCHMARK(decodeMaskRcnnInceptionV2)->Arg(0)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);

/// Pascal VOC's 21 classes, of which five are in the picture.
void decodeSemanticScores(benchmark::State& state) {
  const cv::Size size(kWidth / static_cast<int>(state.range(0)), kHeight / static_cast<int>(state.range(0)));
  cv::Mat scores({1, 21, size.height, size.width}, CV_32F, cv::Scalar(0));
  const auto plane = [&](int c) { return cv::Mat(size, CV_32F, scores.ptr<float>(0, c)); };
  plane(0).setTo(1.0F);
  for (const int c : {5, 9, 15, 20}) {
    plane(c)(cv::Rect(c * size.width / 25, size.height / 3, size.width / 6, size.height / 2)).setTo(2.0F);
  }
  const cv::Size input_px(kWidth, kHeight);
  const auto layout = SemanticLayout::fromShape({1, 21, size.height, size.width}, input_px);
  const auto labels = LabelMap::fromFile("labels/voc21.yaml");
  for (auto _ : state) {
    benchmark::DoNotOptimize(decodeSemantic(scores, *layout, Letterbox(input_px, input_px), labels, 100).instances);
  }
}
BENCHMARK(decodeSemanticScores)->Arg(1)->Arg(8)->Unit(benchmark::kMillisecond);

/// A room of 640x480 as a depth camera sees it: floor, wall, boxes, a tenth not measured.
cv::Mat depthOfARoom() {
  cv::Mat depth_m(kHeight, kWidth, CV_32FC1, cv::Scalar(4.0));
  for (int y = kHeight / 2; y < kHeight; ++y) depth_m.row(y).setTo(4.0 * kHeight / 2 / y);
  for (int i = 0; i < 5; ++i) depth_m(cv::Rect(20 + 120 * i, 100 + 30 * i, 80, 200)).setTo(1.5 + 0.3 * i);
  cv::Mat chance(depth_m.size(), CV_32F);
  cv::RNG(5).fill(chance, cv::RNG::UNIFORM, 0.0, 1.0);
  depth_m.setTo(0.0, chance < 0.1);
  return depth_m;
}

DepthPicture depthPicture(const cv::Mat& depth_m) {
  return fitDepth(depth_m, core::CameraModel(), Letterbox(depth_m.size(), {320, 240}));
}

void makeDepthChannels(benchmark::State& state) {
  const cv::Mat depth_m = depthOfARoom();
  for (auto _ : state) benchmark::DoNotOptimize(depthChannels(depthPicture(depth_m)).data);
}
BENCHMARK(makeDepthChannels)->Unit(benchmark::kMillisecond);

/// From the scores of the depth network to instances.
void decodeDepth(benchmark::State& state) {
  constexpr int kClasses = 18;
  cv::Mat scores({1, kClasses, 120, 160}, CV_32F);
  cv::RNG(6).fill(scores, cv::RNG::NORMAL, 0.0, 0.5);
  for (int c = 0; c < kClasses; ++c) {
    cv::Mat plane(120, 160, CV_32F, scores.ptr<float>(0, c));
    plane(cv::Rect(c * 8, c * 5, 20, 30)) += 5.0F;
  }
  const DepthPicture picture = depthPicture(depthOfARoom());
  for (auto _ : state) {
    const PixelClasses seen = decodeDepthScores(scores, picture.depth_m, 1, {});
    benchmark::DoNotOptimize(labelByDepth(seen.indices, picture.depth_m, {picture.fx_px, 25, 1}).data);
  }
}
BENCHMARK(decodeDepth)->Unit(benchmark::kMillisecond);

/// People before a wall, with a Kinect's noise and shadows, found 8 pixels too wide.
void refineContours(benchmark::State& state) {
  constexpr core::ClassId kPerson = 1;
  cv::setNumThreads(1);
  const cv::Size size(kWidth, kHeight);
  cv::Mat color_bgr(size, CV_8UC3, cv::Scalar(170, 180, 190));
  cv::Mat depth_m(size, CV_32FC1, cv::Scalar(4.0));
  core::Segmentation found = {cv::Mat::zeros(size, CV_8UC1), cv::Mat::zeros(size, CV_16UC1), {}};
  for (int i = 0; i < static_cast<int>(state.range(0)); ++i) {
    const cv::Rect box(10 + 200 * i, 60, 120, 380);
    const cv::Rect wide(box.x - 8, box.y - 8, box.width + 16, box.height + 16);
    color_bgr(box).setTo(cv::Scalar(90 + 40 * i, 60, 40));
    depth_m(box).setTo(2.0 + 0.3 * i);
    depth_m(cv::Rect(box.x - 10, box.y, 10, box.height)).setTo(0.0);
    found.classIds(wide).setTo(kPerson);
    found.instanceIds(wide).setTo(i + 1);
    found.instances.push_back({static_cast<std::uint16_t>(i + 1), kPerson, 0.9F, wide});
  }
  cv::Mat noise(size, CV_32FC1);
  cv::RNG(4).fill(noise, cv::RNG::NORMAL, 0.0, 0.0019);
  depth_m += noise.mul(depth_m).mul(depth_m);
  const masks::ContourRefiner refiner({}, masks::ContourRefiner::ClassSet().set(kPerson));
  for (auto _ : state) benchmark::DoNotOptimize(refiner.refine(color_bgr, depth_m, {}, found).instances);
}
BENCHMARK(refineContours)->Arg(0)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wardslam::segmentation
