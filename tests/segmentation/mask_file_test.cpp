#include "mask_file.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "support/temporary_folder.h"

namespace wardslam::segmentation {
namespace {

using ::testing::HasSubstr;

class MaskFileTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path write(const cv::Mat& image, const std::string& name) const {
    const auto file = folder_.path() / name;
    cv::imwrite(file.string(), image);
    return file;
  }
  test::TemporaryFolder folder_;
};

TEST_F(MaskFileTest, NumbersThatAreNotWholeAreNoClassIds) {
  for (const float value : {1.0F, 3e25F, -3e25F}) {
    const auto mask = readMaskFile(write(cv::Mat(6, 8, CV_32FC1, cv::Scalar(value)), "mask.pfm"));
    EXPECT_TRUE(mask.values.empty());
    EXPECT_THAT(mask.trouble, HasSubstr("mask.pfm: is not of whole numbers")) << value;
  }
}

TEST_F(MaskFileTest, WhatClaimsToBeHugeIsNotUnpacked) {
  const auto file = folder_.write("mask.pgm", "P5 100000 10000 255\n" + std::string(1000, '\0'));
  EXPECT_THAT(readMaskFile(file).trouble, HasSubstr("mask.pgm: claims to be larger"));
  EXPECT_TRUE(readUnchanged(file).empty());
}

}  // namespace
}  // namespace wardslam::segmentation
