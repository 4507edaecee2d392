#include "moment_window.h"

#include <gmock/gmock.h>

namespace wardslam::change {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Instant {
  double stamp_s;
};

/// Of one second, holding these instants.
MomentWindow<Instant> windowOf(const std::vector<double>& stamps_s, double shortest_s = 0.0) {
  MomentWindow<Instant> window(1.0, shortest_s);
  for (const double stamp_s : stamps_s) window.add({stamp_s});
  return window;
}

std::vector<double> referencesOf(const MomentWindow<Instant>& window, double stamp_s) {
  std::vector<double> stamps_s;
  for (const Instant* instant : window.references(stamp_s)) stamps_s.push_back(instant->stamp_s);
  return stamps_s;
}

TEST(MomentWindow, DropsWhatIsOlderThanItself) {
  auto window = windowOf({1.0, 1.5, 2.0});
  window.advanceTo(2.5);
  EXPECT_EQ(window.oldest().stamp_s, 1.5) << "just as old as the window is long";
  EXPECT_EQ(window.newest().stamp_s, 2.0);
  window.advanceTo(9.0);
  EXPECT_TRUE(window.empty());
}

TEST(MomentWindow, StartsAnewAfterAStepBackInTime) {
  auto window = windowOf({1.0, 1.5});
  window.advanceTo(1.5);
  EXPECT_TRUE(window.empty()) << "the same instant again is one";
  EXPECT_THAT(referencesOf(window, 1.5), IsEmpty());
}

TEST(MomentWindow, RefersToOldMiddleAndYoungMoments) {
  const auto window = windowOf({1.0, 1.25, 1.5, 1.625, 1.75, 1.875});
  EXPECT_THAT(referencesOf(window, 2.0), ElementsAre(1.0, 1.625, 1.875)) << "within 1, 0.4 and 0.2 s";
}

TEST(MomentWindow, RefersToEachMomentOnce) {
  EXPECT_THAT(referencesOf(windowOf({1.75}), 2.0), ElementsAre(1.75)) << "the oldest of the last 1 and 0.4 s";
  EXPECT_THAT(referencesOf(windowOf({1.0}), 2.0), ElementsAre(1.0));
}

TEST(MomentWindow, LeavesOutWhatIsTooYoung) {
  EXPECT_THAT(referencesOf(windowOf({1.0, 1.9375}, 0.125), 2.0), ElementsAre(1.0));
  EXPECT_THAT(referencesOf(windowOf({1.0, 1.9375}, 0.0625), 2.0), ElementsAre(1.0, 1.9375));
}

TEST(MomentWindow, TellsAgesAsSharesOfItself) {
  const MomentWindow<Instant> window(0.5);
  EXPECT_DOUBLE_EQ(window.baseline({1.75}, 2.0), 0.5);
}

}  // namespace
}  // namespace wardslam::change
