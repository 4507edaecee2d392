#include "quiet_pcl.h"

#include <gtest/gtest.h>
#include <pcl/console/print.h>

#include <optional>

namespace wardslam::mapping {
namespace {

using pcl::console::getVerbosityLevel;
using pcl::console::L_ALWAYS;
using pcl::console::L_WARN;

TEST(QuietPcl, LastsUntilTheLastEndsInWhateverOrder) {
  const auto usual = getVerbosityLevel();
  pcl::console::setVerbosityLevel(L_WARN);
  std::optional<QuietPcl> first(std::in_place);
  std::optional<QuietPcl> second(std::in_place);
  EXPECT_EQ(getVerbosityLevel(), L_ALWAYS);
  first.reset();
  EXPECT_EQ(getVerbosityLevel(), L_ALWAYS) << "that of another thread is not over";
  second.reset();
  EXPECT_EQ(getVerbosityLevel(), L_WARN) << "as before";
  pcl::console::setVerbosityLevel(usual);
}

}  // namespace
}  // namespace wardslam::mapping
