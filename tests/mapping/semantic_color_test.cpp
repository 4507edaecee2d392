#include "wardslam/mapping/semantic_color.h"

#include <gtest/gtest.h>

#include <set>

namespace wardslam::mapping {
namespace {

TEST(SemanticColorTest, IsThatOfThePascalPalette) {
  using Color = std::array<std::uint8_t, 3>;
  EXPECT_EQ(semanticColor(0), (Color{0, 0, 0}));
  EXPECT_EQ(semanticColor(1), (Color{128, 0, 0}));
  EXPECT_EQ(semanticColor(15), (Color{192, 128, 128}));
  EXPECT_EQ(semanticColor(20), (Color{0, 64, 128}));
}

TEST(SemanticColorTest, NoTwoClassesShareOne) {
  std::set<std::array<std::uint8_t, 3>> colors;
  for (int id = 0; id < 256; ++id) colors.insert(semanticColor(static_cast<core::ClassId>(id)));
  EXPECT_EQ(colors.size(), 256U);
}

}  // namespace
}  // namespace wardslam::mapping
