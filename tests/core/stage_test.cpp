#include "wardslam/core/stage.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

namespace wardslam::core {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// What a plain worker is told to do, as it hears of it.
struct Worker {
  std::vector<int> done;
};

std::unique_ptr<Worker> worker() { return std::make_unique<Worker>(); }

Stage<Worker>::Task number(int n) {
  return [n](Worker& w) { w.done.push_back(n); };
}

/// Keeps a stage at work until it is let go.
class Gate {
 public:
  void close(Stage<Worker>& stage, Necessity necessity = Necessity::Required) {
    stage.post(
        [this](Worker&) {
          reached_.set_value();
          open_.get_future().wait();
        },
        necessity);
    reached_.get_future().wait();
  }
  void open() { open_.set_value(); }

 private:
  std::promise<void> reached_;
  std::promise<void> open_;
};

class StageInBothThreads : public testing::TestWithParam<StageThread> {};
INSTANTIATE_TEST_SUITE_P(Stage, StageInBothThreads,
                         testing::Values(StageThread::Caller, StageThread::Own, StageThread::GivesWay));

TEST_P(StageInBothThreads, WorksInOrderAndGivesTheWorkerBack) {
  Stage<Worker> stage(worker(), GetParam());
  stage.post(number(1));
  stage.post(number(2), Necessity::Optional);
  stage.post(number(3));
  const auto finished = stage.finish();
  ASSERT_NE(finished, nullptr);
  EXPECT_THAT(finished->done, ElementsAre(1, 2, 3));
  EXPECT_EQ(stage.leftOut(), 0U);
  EXPECT_EQ(stage.finish(), nullptr) << "asking twice does no harm";
}

TEST_P(StageInBothThreads, ThatIsFinishedTakesNoMore) {
  Stage<Worker> stage(worker(), GetParam());
  const auto finished = stage.finish();
  EXPECT_THROW(stage.post(number(1)), std::logic_error);
  EXPECT_THAT(finished->done, IsEmpty());
}

TEST_P(StageInBothThreads, NeedsRoomForRequiredTasks) {
  EXPECT_THROW(Stage<Worker>(worker(), GetParam(), {0, 5}), std::invalid_argument);
}

TEST(StageInTheCallingThread, WorksAtOnceAndLeavesNothingOut) {
  auto given = worker();
  const Worker& w = *given;
  Stage<Worker> stage(std::move(given), StageThread::Caller, {1, 0});
  const auto caller = std::this_thread::get_id();
  for (int i = 0; i < 3; ++i) {
    stage.post(
        [&, i](Worker& inStage) {
          EXPECT_EQ(std::this_thread::get_id(), caller);
          EXPECT_FALSE(stage.isWaitedFor());
          inStage.done.push_back(i);
        },
        Necessity::Optional);
    EXPECT_EQ(w.done.back(), i);
  }
  EXPECT_EQ(stage.leftOut(), 0U);
}

TEST(StageInTheCallingThread, ThrowsWhereItIsPostedAndGoesOn) {
  Stage<Worker> stage(worker(), StageThread::Caller);
  EXPECT_THROW(stage.post([](Worker&) { throw std::runtime_error("no space left"); }), std::runtime_error);
  EXPECT_NO_THROW(stage.rethrowFailure());
  stage.post(number(2));
  EXPECT_THAT(stage.finish()->done, ElementsAre(2));
}

TEST(StageInItsOwnThread, GivesWayToOthersWhereItIsToldTo) {
  const auto niceness = [] { return getpriority(PRIO_PROCESS, 0); };
  const int before = niceness();
  const auto nicenessIn = [&](StageThread thread) {
    Stage<Worker> stage(worker(), thread);
    stage.post([&](Worker& w) { w.done.push_back(niceness()); });
    return stage.finish()->done.at(0);
  };
  EXPECT_GT(nicenessIn(StageThread::GivesWay), before);
  EXPECT_EQ(nicenessIn(StageThread::Own), before);
  EXPECT_EQ(niceness(), before);
}

TEST(StageInItsOwnThread, LeavesOutOldOptionalTasksButNoRequiredOnes) {
  Stage<Worker> stage(worker(), StageThread::Own, {64, 12});
  Gate gate;
  gate.close(stage, Necessity::Optional);  // in work: it does not count
  stage.post(number(-1));
  stage.post(number(0));
  for (int i = 1; i < 15; ++i) stage.post(number(i), Necessity::Optional);
  EXPECT_EQ(stage.leftOut(), 2U);
  gate.open();
  EXPECT_THAT(stage.finish()->done, ElementsAre(-1, 0, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14));
  EXPECT_EQ(stage.leftOut(), 2U);
}

TEST(StageInItsOwnThread, RequiredTasksWaitForRoom) {
  Stage<Worker> stage(worker(), StageThread::Own, {3, 12});
  Gate gate;
  gate.close(stage);
  stage.post(number(1));
  stage.post(number(2));
  stage.post(number(3), Necessity::Optional);  // takes none of their room, and waits for none
  std::promise<void> aboutToPost;
  auto third = std::async(std::launch::async, [&] {
    aboutToPost.set_value();
    stage.post(number(4));
  });
  aboutToPost.get_future().wait();
  EXPECT_EQ(third.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  gate.open();
  third.get();
  EXPECT_THAT(stage.finish()->done, ElementsAre(1, 2, 3, 4));
}

TEST(StageInItsOwnThread, ARequiredTaskTakesRoomUntilItIsDone) {
  Stage<Worker> stage(worker(), StageThread::Own, {1, 12});
  Gate gate;
  gate.close(stage);
  auto second = std::async(std::launch::async, [&] { stage.post(number(1)); });
  EXPECT_EQ(second.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  EXPECT_TRUE(stage.isWaitedFor());
  gate.open();
  second.get();
  EXPECT_THAT(stage.finish()->done, ElementsAre(1));
}

TEST(StageInItsOwnThread, WhoWaitsForRoomHearsOfTheFailure) {
  Stage<Worker> stage(worker(), StageThread::Own, {2, 12});
  std::promise<void> fail;
  std::promise<void> reached;
  stage.post([&](Worker&) {
    reached.set_value();
    fail.get_future().wait();
    throw std::runtime_error("no space left");
  });
  reached.get_future().wait();
  stage.post(number(1));
  auto second = std::async(std::launch::async, [&] { stage.post(number(2)); });
  EXPECT_EQ(second.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout);
  fail.set_value();
  EXPECT_THROW(second.get(), std::runtime_error);
}

TEST(StageInItsOwnThread, PassesFailuresOnAndDoesNothingAfterThem) {
  auto given = worker();
  const Worker& w = *given;
  Stage<Worker> stage(std::move(given), StageThread::Own);
  Gate gate;
  gate.close(stage);
  stage.post(number(1));
  stage.post([](Worker&) { throw std::runtime_error("no space left"); });
  stage.post(number(2));
  gate.open();
  EXPECT_THROW((void)stage.finish(), std::runtime_error);
  EXPECT_THROW((void)stage.finish(), std::runtime_error);
  EXPECT_THROW(stage.rethrowFailure(), std::runtime_error);
  EXPECT_THAT(w.done, ElementsAre(1));
}

TEST_P(StageInBothThreads, GivesTheWorkerBackThoughATaskHasThrown) {
  Stage<Worker> stage(worker(), GetParam());
  stage.post(number(1));
  try {
    stage.post([](Worker&) { throw std::runtime_error("no space left"); });
    (void)stage.finish();
  } catch (const std::runtime_error&) {
  }
  const auto given = stage.giveUp();
  ASSERT_NE(given, nullptr);
  EXPECT_THAT(given->done, ElementsAre(1));
  EXPECT_EQ(stage.giveUp(), nullptr) << "asking twice does no harm";
  EXPECT_THROW(stage.post(number(2)), std::logic_error);
}

TEST(StageInItsOwnThread, PassesFailuresOnToTheNextTask) {
  Stage<Worker> stage(worker(), StageThread::Own, {1, 0});
  stage.post([](Worker&) { throw std::runtime_error("no space left"); });
  const auto postUntilItThrows = [&] {
    while (true) stage.post(number(1));
  };
  EXPECT_THROW(postUntilItThrows(), std::runtime_error);
  EXPECT_THROW(stage.post(number(1), Necessity::Optional), std::runtime_error);
}

TEST(StageInItsOwnThread, CanBeGivenUpWithWorkPending) {
  std::promise<void> reached;
  std::promise<void> dropped;
  std::vector<int> done;
  {
    Stage<Worker> stage(worker(), StageThread::Own);
    stage.post([&](Worker&) {
      reached.set_value();
      dropped.get_future().wait();
      done.push_back(1);
    });
    reached.get_future().wait();
    const std::shared_ptr<void> held(nullptr, [&](void*) { dropped.set_value(); });
    for (int i = 0; i < 10; ++i) stage.post([&done, held](Worker&) { done.push_back(2); });
  }
  EXPECT_THAT(done, ElementsAre(1)) << "what is in work is done to its end, what waits is dropped";
}

TEST(StageInItsOwnThread, ThatIsGivenUpTellsTheTaskInWork) {
  std::promise<void> reached;
  {
    Stage<Worker> stage(worker(), StageThread::Own);
    stage.post([&](Worker&) {
      reached.set_value();
      while (!stage.isWaitedFor()) std::this_thread::yield();  // or the stage would never end
    });
    reached.get_future().wait();
  }
}

TEST(StageInItsOwnThread, CountsWhatWaits) {
  Stage<Worker> stage(worker(), StageThread::Own);
  Gate gate;
  gate.close(stage);
  EXPECT_EQ(stage.waiting(), 0U) << "what is in work does not wait";
  stage.post(number(1));
  stage.post(number(2), Necessity::Optional);
  EXPECT_EQ(stage.waiting(), 2U);
  gate.open();
  static_cast<void>(stage.finish());
  EXPECT_EQ(stage.waiting(), 0U);
}

TEST(StageInItsOwnThread, SaysWhetherSomethingWaits) {
  Stage<Worker> stage(worker(), StageThread::Own);
  Gate first;
  first.close(stage);
  EXPECT_FALSE(stage.isWaitedFor()) << "what is in work does not wait";
  Gate second;
  std::thread poster([&] { second.close(stage); });
  while (!stage.isWaitedFor()) std::this_thread::yield();
  first.open();
  poster.join();
  EXPECT_FALSE(stage.isWaitedFor());
  stage.post(number(1), Necessity::Optional);
  EXPECT_TRUE(stage.isWaitedFor());
  second.open();
  EXPECT_THAT(stage.finish()->done, ElementsAre(1));
  EXPECT_FALSE(stage.isWaitedFor());
}

}  // namespace
}  // namespace wardslam::core
