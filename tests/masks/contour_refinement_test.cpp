#include "wardslam/masks/contour_refinement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "wardslam/core/errors.h"

namespace wardslam::masks {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr bool kFromNetwork = true;
constexpr bool kRecorded = false;

ContourRefinementOptions parse(const std::string& text) {
  ContourRefinementOptions options;
  core::readOptions(core::ConfigNode::fromText(text), options);
  return options;
}

TEST(MakeContourRefiner, LeavesRecordedMasksAloneByDefault) {
  EXPECT_TRUE(makeContourRefiner({}, kFromNetwork, {}));
  EXPECT_FALSE(makeContourRefiner({}, kRecorded, {}));
}

TEST(MakeContourRefiner, DoesAsItIsTold) {
  const auto always = parse("{refine_contours: always, contours: {max_growth: 0}}");
  EXPECT_TRUE(makeContourRefiner(always, kRecorded, {}));
  EXPECT_EQ(always.contours.max_growth_px, 0);
  EXPECT_FALSE(makeContourRefiner(parse("{refine_contours: never}"), kFromNetwork, {}));
  EXPECT_THAT([] { parse("{refine_contours: sometimes}"); }, ThrowsMessage<core::InputError>(HasSubstr("sometimes")));
}

}  // namespace
}  // namespace wardslam::masks
