#include "image_file.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "wardslam/sources/input_damage.h"

namespace wardslam::sources {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(ImageFile, WhatClaimsToBeHugeIsNotUnpacked) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("depth.pgm", "P5 20000 20000 65535\n" + std::string(1000, '\0'));
  const auto matcher = ThrowsMessage<InputDamage>(HasSubstr("claims to be an image of 20000x20000 pixels"));
  EXPECT_THAT([&] { (void)readDepthImage(file); }, matcher);
  EXPECT_THAT([&] { (void)readColorImage(file); }, matcher);
}

}  // namespace
}  // namespace wardslam::sources
