#include "wardslam/masks/async_segmenter.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <vector>

#include "wardslam/core/errors.h"

namespace wardslam::masks {
namespace {

/// What a FakeSegmenter was asked for; outlives it.
struct Log {
  std::vector<double> stamps_s;  ///< Written by the worker; read after wait() or destruction only.
  std::atomic<int> finished{0};
  std::atomic<bool> begun{false};
};

/// Class id = first blue value of the image. Negative stamps throw. Where a gate is given, every image waits for it.
class FakeSegmenter : public segmentation::Segmenter {
 public:
  explicit FakeSegmenter(Log& log, std::shared_future<void> gate = {}) : log_(log), gate_(std::move(gate)) {}

  Result segment(const segmentation::SegmenterInput& input) override {
    log_.begun = true;
    if (gate_.valid()) gate_.wait();
    log_.stamps_s.push_back(input.stamp_s);
    if (input.stamp_s < 0.0) throw core::InputError("no such time");
    Result result;
    result.segmentation.classIds =
        cv::Mat(input.color_bgr.size(), CV_8UC1, cv::Scalar(input.color_bgr.at<cv::Vec3b>(0, 0)[0]));
    return result;
  }
  void finish() override { ++log_.finished; }
  const core::LabelSpace& labelSpace() const override { return labelSpace_; }

 private:
  Log& log_;
  std::shared_future<void> gate_;
  core::LabelSpace labelSpace_ = core::LabelSpace::coco();
};

cv::Mat imageOf(int value) { return {4, 4, CV_8UC3, cv::Scalar::all(value)}; }

int classOf(const segmentation::Segmenter::Result& result) {
  return result.segmentation.classIds.at<core::ClassId>(0, 0);
}

void waitUntil(const std::atomic<bool>& condition) {
  while (!condition) std::this_thread::yield();
}

TEST(AsyncSegmenter, GivesTheResultOfEachImage) {
  Log log;
  AsyncSegmenter async(std::make_unique<FakeSegmenter>(log));
  EXPECT_EQ(async.labelSpace().name(1), "person");
  for (int i = 1; i <= 50; ++i) {
    async.submit({imageOf(i), static_cast<double>(i)});
    EXPECT_EQ(classOf(async.wait()), i);
  }
  EXPECT_EQ(log.stamps_s.size(), 50U);
}

TEST(AsyncSegmenter, SubmitDoesNotWait) {
  Log log;
  std::promise<void> gate;
  AsyncSegmenter async(std::make_unique<FakeSegmenter>(log, gate.get_future().share()));
  async.submit({imageOf(3), 1.0});  // would never return if it waited
  gate.set_value();
  EXPECT_EQ(classOf(async.wait()), 3);
}

TEST(AsyncSegmenter, KeepsOnlyTheNewestOfTheImagesThatWait) {
  Log log;
  std::promise<void> gate;
  AsyncSegmenter async(std::make_unique<FakeSegmenter>(log, gate.get_future().share()));
  async.submit({imageOf(1), 1.0});
  waitUntil(log.begun);
  for (int i = 2; i <= 9; ++i) async.submit({imageOf(i), static_cast<double>(i)});
  gate.set_value();
  EXPECT_EQ(classOf(async.wait()), 9);
  EXPECT_EQ(log.stamps_s, (std::vector<double>{1.0, 9.0}));
}

TEST(AsyncSegmenter, SharesThePixels) {
  Log log;
  std::promise<void> gate;
  AsyncSegmenter async(std::make_unique<FakeSegmenter>(log, gate.get_future().share()));
  cv::Mat image = imageOf(1);
  async.submit({image, 1.0});
  image.setTo(8);
  gate.set_value();
  EXPECT_EQ(classOf(async.wait()), 8);
}

TEST(AsyncSegmenter, RethrowsInTheCallerAndGoesOn) {
  Log log;
  AsyncSegmenter async(std::make_unique<FakeSegmenter>(log));
  async.submit({imageOf(1), -1.0});
  EXPECT_THROW((void)async.wait(), core::InputError);
  async.submit({imageOf(2), 2.0});
  EXPECT_EQ(classOf(async.wait()), 2);
}

TEST(AsyncSegmenter, HasNoResultWithoutAnImage) {
  Log log;
  AsyncSegmenter async(std::make_unique<FakeSegmenter>(log));
  EXPECT_THROW((void)async.wait(), std::logic_error);
  async.submit({imageOf(1), 1.0});
  (void)async.wait();
  EXPECT_THROW((void)async.wait(), std::logic_error);
}

TEST(AsyncSegmenter, TakesWhatIsThereWithoutWaiting) {
  Log log;
  std::promise<void> gate;
  AsyncSegmenter async(std::make_unique<FakeSegmenter>(log, gate.get_future().share()));
  EXPECT_FALSE(async.isExpected());
  EXPECT_FALSE(async.tryTake()) << "nothing was submitted";

  async.submit({imageOf(5), 1.0});
  EXPECT_TRUE(async.isExpected());
  EXPECT_FALSE(async.tryTake()) << "the gate is shut";
  EXPECT_TRUE(async.isExpected());

  gate.set_value();
  auto result = async.tryTake();
  while (!result) result = async.tryTake();
  EXPECT_EQ(classOf(*result), 5);
  EXPECT_FALSE(async.isExpected());
  EXPECT_FALSE(async.tryTake()) << "each result is given once";
}

TEST(AsyncSegmenter, TakingRethrowsToo) {
  Log log;
  AsyncSegmenter async(std::make_unique<FakeSegmenter>(log));
  async.submit({imageOf(1), -1.0});
  EXPECT_THROW(while (!async.tryTake()) std::this_thread::yield(), core::InputError);
  EXPECT_FALSE(async.isExpected());
}

TEST(AsyncSegmenter, FinishesAfterTheLastImage) {
  Log log;
  std::promise<void> gate;
  AsyncSegmenter async(std::make_unique<FakeSegmenter>(log, gate.get_future().share()));
  async.submit({imageOf(1), 1.0});
  auto opened = std::async(std::launch::async, [&] {
    EXPECT_EQ(log.finished, 0);
    gate.set_value();
  });
  async.finish();
  EXPECT_EQ(log.finished, 1);
  EXPECT_EQ(log.stamps_s.size(), 1U);
  EXPECT_EQ(classOf(async.wait()), 1);
}

TEST(AsyncSegmenter, EndsWithWorkPending) {
  Log log;
  std::promise<void> gate;
  {
    AsyncSegmenter async(std::make_unique<FakeSegmenter>(log, gate.get_future().share()));
    async.submit({imageOf(1), 1.0});
    waitUntil(log.begun);
    async.submit({imageOf(2), 2.0});
    gate.set_value();
  }
  // The image in work was done; whether the worker took the second before it was told to stop is left open.
  ASSERT_GE(log.stamps_s.size(), 1U);
  EXPECT_EQ(log.stamps_s.front(), 1.0);
  EXPECT_EQ(log.finished, 0);
}

/// Finds the same person in every image.
class FindsAPerson : public segmentation::Segmenter {
 public:
  explicit FindsAPerson(core::Segmentation found) : found_(std::move(found)) {}
  Result segment(const segmentation::SegmenterInput& /*input*/) override { return {found_, {}}; }
  const core::LabelSpace& labelSpace() const override { return labelSpace_; }

 private:
  core::Segmentation found_;
  core::LabelSpace labelSpace_ = core::LabelSpace::coco();
};

TEST(AsyncSegmenter, RefinesContoursWhereItCan) {
  const cv::Rect person(40, 30, 30, 60);
  cv::Mat color_bgr(120, 160, CV_8UC3, cv::Scalar::all(200));
  cv::Mat depth_m(120, 160, CV_32FC1, cv::Scalar(4.0));
  color_bgr(person).setTo(cv::Scalar(90, 40, 20));
  depth_m(person).setTo(2.0);
  const cv::Rect wide(35, 25, 40, 70);
  core::Segmentation found = {
      cv::Mat::zeros(120, 160, CV_8UC1), cv::Mat::zeros(120, 160, CV_16UC1), {{3, 1, 1.0F, wide}}};
  found.classIds(wide).setTo(1);
  found.instanceIds(wide).setTo(3);

  const ContourRefiner refiner({}, ContourRefiner::ClassSet().set(1));
  AsyncSegmenter async(std::make_unique<FindsAPerson>(found), refiner);
  async.submit({color_bgr, 1.0, depth_m});
  const core::Segmentation refined = async.wait().segmentation;
  EXPECT_EQ(cv::norm(refined.classIds, refiner.refine(color_bgr, depth_m, {}, found).classIds, cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(refined.classIds, found.classIds, cv::NORM_INF), 0.0);

  async.submit({color_bgr, 2.0});
  EXPECT_EQ(cv::norm(async.wait().segmentation.classIds, found.classIds, cv::NORM_INF), 0.0) << "no depth";
}

TEST(AsyncSegmenter, EndsWithoutWork) {
  for (int i = 0; i < 100; ++i) {
    Log log;
    const AsyncSegmenter async(std::make_unique<FakeSegmenter>(log));
  }
}

}  // namespace
}  // namespace wardslam::masks
