// Budget: from output tensors to masks at most 5 ms for 10 instances at 640x480.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

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

}  // namespace
}  // namespace wardslam::segmentation
