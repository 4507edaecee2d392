#include "wardslam/fleet/watch.h"

#include "fleet/fleet_test.h"

namespace wardslam::fleet {
namespace {

using WatchTest = FleetTest;

TEST_F(WatchTest, TellsWhatAPushChanges) {
  (void)pushWard();
  drive(1000.0);
  ward_.objects[3].state = mapping::ObjectState::Gone;
  std::vector<ToldChange> told;
  int looks = 0;
  Watcher watcher;
  watcher.isReady = [&] { (void)pushWard(); };
  watcher.hear = [&](const ToldChange& change) { told.push_back(change); };
  watcher.isInterrupted = [&] { return !told.empty() || ++looks > 100; };
  watch(url_, {"north", "", "", ""}, watcher);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].kind, "gone");
  EXPECT_EQ(told[0].object, 3U);
  EXPECT_EQ(told[0].className, "backpack");
  EXPECT_EQ(told[0].at_s, 2000.0);
  EXPECT_EQ(told[0].robot, "robot 1");
  EXPECT_EQ(told[0].zoneBefore, "clean zone");
}

TEST_F(WatchTest, LeavesOtherStoreysOut) {
  int looks = 0;
  Watcher watcher;
  watcher.isReady = [&] { (void)pushWard(); };
  watcher.hear = [](const ToldChange& change) { ADD_FAILURE() << change.storey; };
  watcher.isInterrupted = [&] { return ++looks > 4; };
  watch(url_, {"north", "7", "", ""}, watcher);
}

}  // namespace
}  // namespace wardslam::fleet
