#include "wardslam/core/event_counts.h"

#include <gtest/gtest.h>

namespace wardslam::core {
namespace {

TEST(EventCounts, AddUpByName) {
  EventCounts sum{{"a.x", 1}, {"a.y", 2}};
  accumulate(sum, {{"a.y", 3}, {"b.z", 4}});
  EXPECT_EQ(sum, (EventCounts{{"a.x", 1}, {"a.y", 5}, {"b.z", 4}}));
}

TEST(EventCounts, NothingChangesNothing) {
  EventCounts sum{{"a.x", 1}};
  accumulate(sum, {});
  EXPECT_EQ(sum, (EventCounts{{"a.x", 1}}));
}

}  // namespace
}  // namespace wardslam::core
