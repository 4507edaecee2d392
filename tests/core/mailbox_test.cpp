#include "wardslam/core/mailbox.h"

#include <gmock/gmock.h>

#include <memory>
#include <thread>

namespace wardslam::core {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Mailbox, HandsOutEachValueOnceAndInOrder) {
  Mailbox<int> mailbox;
  EXPECT_THAT(mailbox.takeAll(), IsEmpty());
  mailbox.put(1);
  mailbox.put(2);
  EXPECT_THAT(mailbox.takeAll(), ElementsAre(1, 2));
  EXPECT_THAT(mailbox.takeAll(), IsEmpty());
  mailbox.put(3);
  EXPECT_THAT(mailbox.takeAll(), ElementsAre(3));
}

TEST(Mailbox, LosesNothingBetweenThreads) {
  Mailbox<std::unique_ptr<int>> mailbox;
  constexpr int kValues = 1000;
  std::thread sender([&] {
    for (int i = 0; i < kValues; ++i) mailbox.put(std::make_unique<int>(i));
  });
  int next = 0;
  while (next < kValues) {
    for (const auto& value : mailbox.takeAll()) EXPECT_EQ(*value, next++);
  }
  sender.join();
  EXPECT_EQ(next, kValues);
}

}  // namespace
}  // namespace wardslam::core
