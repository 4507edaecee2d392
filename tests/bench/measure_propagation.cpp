// measure_propagation DIR [CAMERA.yaml]: how well masks are carried over time. DIR is a recording in the layout of the
// TUM benchmark with true class ids in masks/ and instance ids in instances/. The true masks of every third frame are
// carried 1, 3, 5, 8 and 15 frames on and compared to the true masks there, for people, beside masks that are not
// carried at all.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <vector>

#include "mask_propagator.h"
#include "wardslam/core/frame.h"
#include "wardslam/masks/image_motion.h"
#include "wardslam/segmentation/recorded_masks.h"
#include "wardslam/sources/frame_builder.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam {
namespace {

constexpr core::ClassId kPerson = 1;

struct Moment {
  masks::SmallPicture picture;
  cv::Mat step;
  core::Segmentation truth;
};

struct Overlap {
  double both = 0;
  double truthOnly = 0;
  double carriedOnly = 0;

  void add(const core::Segmentation& carried, const core::Segmentation& truth) {
    const cv::Mat a = carried.classIds == kPerson;
    const cv::Mat b = truth.classIds == kPerson;
    const double common = cv::countNonZero(a & b);
    both += common;
    truthOnly += cv::countNonZero(b) - common;
    carriedOnly += cv::countNonZero(a) - common;
  }
  void print(const char* name) const {
    const double truth = both + truthOnly;
    std::printf("  %s: IoU %.3f, missed %.3f, too much %.3f", name, both / (truth + carriedOnly), truthOnly / truth,
                carriedOnly / truth);
  }
};

std::vector<Moment> read(const std::filesystem::path& folder, const sources::SourceOptions& sourceOptions) {
  const auto source = sources::openSource(folder, sourceOptions);
  segmentation::RecordedMasksOptions options;
  options.folder = (folder / "masks").string();
  segmentation::RecordedMasks masks(options, {});
  sources::FrameBuilder builder;
  masks::ImageMotion motion;
  std::vector<Moment> moments;
  while (const auto observation = source->next()) {
    const core::Frame frame = builder.build(observation);
    motion.advance(masks::shrink(frame.gray, frame.depth_m, frame.stamp_s));
    moments.push_back(
        {motion.picture(), motion.step().clone(), masks.segment(segmentation::inputOf(frame)).segmentation});
  }
  return moments;
}

void measure(const std::vector<Moment>& moments) {
  const std::vector<std::size_t> ages = {1, 3, 5, 8, 15};
  std::map<std::size_t, Overlap> carried;
  std::map<std::size_t, Overlap> left;
  for (std::size_t start = 0; start + ages.back() < moments.size(); start += 3) {
    if (moments[start].truth.empty()) continue;
    masks::Trail trail(moments[start].picture);
    for (std::size_t age = 1; age <= ages.back(); ++age) {
      const Moment& now = moments[start + age];
      trail.follow(now.step);
      if (now.truth.empty() || std::find(ages.begin(), ages.end(), age) == ages.end()) continue;
      carried[age].add(masks::carryMasks(moments[start].truth, trail, now.picture), now.truth);
      left[age].add(moments[start].truth, now.truth);
    }
  }
  for (const std::size_t age : ages) {
    std::printf("%2zu frames on:", age);
    carried[age].print("carried");
    left[age].print("left as they were");
    std::printf("\n");
  }
}

}  // namespace
}  // namespace wardslam

int main(int argc, char** argv) try {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: measure_propagation DIR [CAMERA.yaml]\n");
    return 2;
  }
  wardslam::sources::SourceOptions options;
  if (argc == 3) options.camera = argv[2];
  wardslam::measure(wardslam::read(argv[1], options));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "measure_propagation: %s\n", error.what());
  return 1;
}
