#include "wardslam/masks/mask_feed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <future>
#include <utility>
#include <vector>

#include "masks/textured_scene.h"
#include "wardslam/masks/async_segmenter.h"

namespace wardslam::masks {
namespace {

using namespace scene;
using segmentation::Segmenter;
using Mode = MaskFeedOptions::Mode;

constexpr double kFrame_s = 1.0 / 30;

/// A man who walks along a wall, seven pixels a frame.
Picture walkAt(int frame) {
  Picture picture = wall(4.0);
  put(picture, 5, kPerson, {20 + 7 * frame, 60, 60, 110}, 2.0);
  return picture;
}

core::Frame frameOf(const Picture& picture, int index) {
  core::Frame frame;
  frame.index = static_cast<std::uint64_t>(index);
  frame.stamp_s = index * kFrame_s;
  frame.gray = picture.gray;
  cv::cvtColor(picture.gray, frame.color_bgr, cv::COLOR_GRAY2BGR);
  frame.depth_m = picture.depth_m;
  return frame;
}

/// Tells what is seen at the time of an image, by the number of its frame.
class Oracle : public segmentation::Segmenter {
 public:
  using Answer = std::function<Result(int frame)>;

  explicit Oracle(Answer answer) : answer_(std::move(answer)) {}
  Result segment(const segmentation::SegmenterInput& input) override {
    return answer_(static_cast<int>(std::lround(input.stamp_s / kFrame_s)));
  }
  const core::LabelSpace& labelSpace() const override { return labels_; }

 private:
  Answer answer_;
  core::LabelSpace labels_ = core::LabelSpace::coco();
};

class MaskFeedTest : public testing::Test {
 protected:
  void start(Mode mode, int latency_frames, Oracle::Answer answer) {
    MaskFeedOptions options;
    options.mode = mode;
    options.latency_frames = latency_frames;
    options.tracker.bridge_s = bridge_s_;
    options.keepsIds = keepsIds_;
    feed_ = makeMaskFeed(options, std::make_shared<masks::AsyncSegmenter>(
                                      std::make_unique<Oracle>([this, answer = std::move(answer)](int frame) {
                                        asked_.push_back(frame);
                                        return answer(frame);
                                      })));
  }

  core::Frame show(const Picture& picture, int index) {
    core::Frame frame = frameOf(picture, index);
    feed_->begin(frame);
    feed_->fill(frame);
    return frame;
  }

  static segmentation::Segmenter::Result truth(int frame) { return {walkAt(frame).masks, {}}; }

  static double iouOfPerson(const core::Frame& frame) {
    const cv::Mat expected = walkAt(static_cast<int>(frame.index)).masks.classIds == kPerson;
    return iou(frame.segmentation.classIds == kPerson, expected);
  }

  double bridge_s_ = 0.5;
  bool keepsIds_ = true;
  std::vector<int> asked_;  ///< By the segmenter's thread; read when that has nothing to do.
  std::unique_ptr<MaskFeed> feed_;
};

TEST_F(MaskFeedTest, WaitingGivesTheMasksOfEachFrame) {
  start(Mode::Wait, 0, truth);
  std::uint16_t id = 0;
  for (int i = 0; i < 6; ++i) {
    const core::Frame frame = show(walkAt(i), i);
    EXPECT_EQ(iouOfPerson(frame), 1.0);
    EXPECT_EQ(frame.segmentationAge_s, 0.0);
    EXPECT_EQ(frame.segmentationAge_frames, 0);
    ASSERT_EQ(frame.segmentation.instances.size(), 1U);
    if (i == 0) id = frame.segmentation.instances[0].id;
    EXPECT_EQ(frame.segmentation.instances[0].id, id);
  }
}

TEST_F(MaskFeedTest, WaitingBridgesWhatIsMissed) {
  start(Mode::Wait, 0, [](int i) {
    return i == 6 || i == 7 ? segmentation::Segmenter::Result{wall(4.0).masks, {}} : truth(i);
  });
  for (int i = 0; i < 10; ++i) EXPECT_GT(iouOfPerson(show(walkAt(i), i)), 0.9) << i;
}

TEST_F(MaskFeedTest, WaitingWithoutABridgeKeepsIdsWhereTheyCount) {
  bridge_s_ = 0.0;
  start(Mode::Wait, 0, [](int i) {
    auto result = truth(i);
    const auto id = static_cast<std::uint16_t>(20 + i);  // a network numbers the instances of each image anew
    result.segmentation.instanceIds.setTo(id, result.segmentation.instanceIds != 0);
    for (core::Instance& instance : result.segmentation.instances) instance.id = id;
    if (i == 3) result.segmentation = wall(4.0).masks;
    return result;
  });
  const auto id = show(walkAt(0), 0).segmentation.instances.at(0).id;
  for (int i = 1; i < 3; ++i) EXPECT_EQ(show(walkAt(i), i).segmentation.instances.at(0).id, id) << i;
  EXPECT_EQ(iouOfPerson(show(walkAt(3), 3)), 0.0) << "nothing is bridged";
}

TEST_F(MaskFeedTest, WaitingWithoutABridgeHandsOnWhatTheSegmenterGives) {
  bridge_s_ = 0.0;
  keepsIds_ = false;
  start(Mode::Wait, 0, [](int i) { return i == 3 ? segmentation::Segmenter::Result{wall(4.0).masks, {}} : truth(i); });
  for (int i = 0; i < 3; ++i) EXPECT_EQ(show(walkAt(i), i).segmentation.instances.at(0).id, 5);
  EXPECT_EQ(iouOfPerson(show(walkAt(3), 3)), 0.0);
}

TEST_F(MaskFeedTest, PropagationCarriesTheMasksOfOlderImages) {
  start(Mode::Propagate, 3, truth);
  const std::vector<int> ages = {0, 1, 2, 3, 3, 4, 5, 3, 4, 5, 3};  // image 0 is waited for, then comes 1, 4, 7 …
  std::uint16_t id = 0;
  for (int i = 0; i < 11; ++i) {
    const core::Frame frame = show(walkAt(i), i);
    EXPECT_GT(iouOfPerson(frame), 0.9) << i;
    EXPECT_EQ(frame.segmentationAge_frames, ages[static_cast<std::size_t>(i)]) << i;
    EXPECT_NEAR(frame.segmentationAge_s, ages[static_cast<std::size_t>(i)] * kFrame_s, 1e-9) << i;
    ASSERT_EQ(frame.segmentation.instances.size(), 1U);
    if (i == 0) id = frame.segmentation.instances[0].id;
    EXPECT_EQ(frame.segmentation.instances[0].id, id);
  }
  feed_.reset();
  // The last image may be dropped before the segmenter begins it: nobody waits for it any more.
  EXPECT_THAT(asked_, testing::AnyOf(testing::ElementsAre(0, 1, 4, 7), testing::ElementsAre(0, 1, 4, 7, 10)));
}

TEST_F(MaskFeedTest, PropagationBridgesWhatIsMissed) {
  start(Mode::Propagate, 3, [](int i) {
    return i == 7 ? segmentation::Segmenter::Result{wall(4.0).masks, {}} : truth(i);
  });
  for (int i = 0; i < 15; ++i) EXPECT_GT(iouOfPerson(show(walkAt(i), i)), 0.85) << i;
}

TEST_F(MaskFeedTest, PropagationBringsSomebodyNewToThePresent) {
  // The segmenter sees the man in image 4 for the first time; its masks come three frames later.
  start(Mode::Propagate, 3, [](int i) {
    return i < 4 ? segmentation::Segmenter::Result{wall(4.0).masks, {}} : truth(i);
  });
  for (int i = 0; i < 9; ++i) {
    const core::Frame frame = show(walkAt(i), i);
    if (i < 7) {
      EXPECT_EQ(iouOfPerson(frame), 0.0) << i;
    } else {
      EXPECT_GT(iouOfPerson(frame), 0.9) << i;
    }
  }
}

TEST_F(MaskFeedTest, PropagationRepeats) {
  std::vector<cv::Mat> first;
  for (int run = 0; run < 2; ++run) {
    start(Mode::Propagate, 2, truth);
    for (int i = 0; i < 8; ++i) {
      const cv::Mat ids = show(walkAt(i), i).segmentation.instanceIds;
      if (run == 0) first.push_back(ids);
      EXPECT_EQ(cv::countNonZero(ids != first[static_cast<std::size_t>(i)]), 0);
    }
  }
}

TEST_F(MaskFeedTest, PropagationNeverWaitsButForTheFirst) {
  const int stop = 15;
  const auto lastStep = [stop](int frame) { return std::min(frame, stop); };  // there he stands
  std::promise<void> gate;
  const auto opened = gate.get_future().share();
  start(Mode::Propagate, 0, [opened, lastStep](int i) {
    if (i > 0) opened.wait();
    return truth(lastStep(i));
  });
  for (int i = 0; i < stop; ++i) {  // would not end if it waited for image 1
    const core::Frame frame = show(walkAt(i), i);
    EXPECT_EQ(frame.segmentationAge_frames, i);
    EXPECT_GT(iouOfPerson(frame), 0.8) << i;
  }
  gate.set_value();
  int index = stop;
  core::Frame frame = show(walkAt(stop), index);
  while (static_cast<int>(frame.index) - frame.segmentationAge_frames < stop) {  // masks of before he stood
    frame = show(walkAt(stop), ++index);
  }
  EXPECT_GT(iou(frame.segmentation.classIds == kPerson, walkAt(stop).masks.classIds == kPerson), 0.95);
}

TEST_F(MaskFeedTest, MasksOfAnotherSizeCountAsNone) {
  for (const Mode mode : {Mode::Wait, Mode::Propagate}) {
    start(mode, 1, [](int) {
      return segmentation::Segmenter::Result{{cv::Mat(10, 10, CV_8UC1, cv::Scalar(kPerson)), {}, {}},
                                             {{"fake.event", 2}}};
    });
    const core::Frame frame = show(walkAt(0), 0);
    EXPECT_TRUE(frame.segmentation.empty());
    EXPECT_EQ(frame.events, (core::EventCounts{{"fake.event", 2}, {"filters.segmentation_size", 1}}));
  }
}

TEST_F(MaskFeedTest, ImagesOfAnotherSizeStartAnew) {
  for (const Mode mode : {Mode::Wait, Mode::Propagate}) {
    const auto small = [](int i) {
      Picture picture = walkAt(i);
      for (cv::Mat* image : {&picture.gray, &picture.depth_m, &picture.masks.classIds, &picture.masks.instanceIds}) {
        cv::resize(*image, *image, {160, 120}, 0, 0, cv::INTER_NEAREST);
      }
      return picture;
    };
    start(mode, 3, [small](int i) { return i < 6 ? truth(i) : segmentation::Segmenter::Result{small(i).masks, {}}; });
    for (int i = 0; i < 12; ++i) {
      const Picture picture = i < 6 ? walkAt(i) : small(i);
      const core::Frame frame = show(picture, i);
      ASSERT_EQ(frame.segmentation.classIds.size(), picture.gray.size()) << i;
      EXPECT_GT(iou(frame.segmentation.classIds == kPerson, picture.masks.classIds == kPerson), 0.85) << i;
    }
  }
}

TEST_F(MaskFeedTest, WhatTheSegmenterThrowsReachesTheCaller) {
  for (const Mode mode : {Mode::Wait, Mode::Propagate}) {
    start(mode, 2, [](int i) { return i < 3 ? truth(i) : throw std::runtime_error("no more masks"); });
    EXPECT_THROW(for (int i = 0; i < 9; ++i)(void) show(walkAt(i), i), std::runtime_error);
  }
}

TEST_F(MaskFeedTest, MasksMayBeChangedByTheReceiver) {
  for (const Mode mode : {Mode::Wait, Mode::Propagate}) {
    start(mode, 3, truth);
    for (int i = 0; i < 6; ++i) {
      const core::Frame frame = show(walkAt(i), i);
      EXPECT_GT(iouOfPerson(frame), 0.9) << i;
      cv::Mat(frame.segmentation.classIds).setTo(0);
      cv::Mat(frame.segmentation.instanceIds).setTo(0);
    }
  }
}

}  // namespace
}  // namespace wardslam::masks
