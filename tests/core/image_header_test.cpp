#include "wardslam/core/image_header.h"

#include <gtest/gtest.h>

#include <string>

namespace wardslam::core {
namespace {

using namespace std::string_literals;
using Kind = ImageHeader::Kind;

ImageHeader headerOf(const std::string& bytes) {
  return imageHeader(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

void expectSize(const std::string& bytes, Kind kind, std::uint32_t width_px, std::uint32_t height_px) {
  const auto header = headerOf(bytes);
  EXPECT_EQ(header.kind, kind);
  EXPECT_EQ(header.width_px, width_px);
  EXPECT_EQ(header.height_px, height_px);
}

const std::string kPng = "\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\x02\x80\0\0\x01\xE0"s;
const std::string kJpeg = "\xFF\xD8\xFF\xE0\0\x04xx\xFF\xC2\0\x11\x08\x01\xE0\x02\x80\x03"s;
const std::string kBmp = "BM"s + std::string(12, '\0') + "\x28\0\0\0\x80\x02\0\0\x20\xFE\xFF\xFF"s;  // height -480
const std::string kOldBmp = "BM"s + std::string(12, '\0') + "\x0C\0\0\0\x80\x02\xE0\x01"s;

TEST(ImageHeader, TellsTheSizeBeforeAnythingIsUnpacked) {
  expectSize(kPng, Kind::Png, 640, 480);
  expectSize(kJpeg, Kind::Jpeg, 640, 480);
  expectSize(kBmp, Kind::Bmp, 640, 480);
  expectSize(kOldBmp, Kind::Bmp, 640, 480);
  expectSize("P5\n# a remark\n640 480\n255\n", Kind::Netpbm, 640, 480);
  expectSize("Pf 640 480 -1.0\n", Kind::Netpbm, 640, 480);
}

TEST(ImageHeader, OfWhatIsNotKnownSaysNothing) {
  for (const std::string& bytes : {""s, "P"s, "GIF89a"s, "II*\0"s}) {
    expectSize(bytes, Kind::Other, 0, 0);
    EXPECT_FALSE(headerOf(bytes).isTooLarge());
  }
  expectSize("\xFF\xD8\xFF\xD9"s, Kind::Jpeg, 0, 0);
}

TEST(ImageHeader, ReadsNothingBehindTheEnd) {
  for (const std::string& bytes : {kPng, kJpeg, kBmp, kOldBmp, "P5\n640 480"s}) {
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
      const std::vector<std::uint8_t> cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_FALSE(imageHeader(cut.data(), cut.size()).isTooLarge()) << size;
    }
  }
}

TEST(ImageHeader, KnowsWhatNoCameraTakes) {
  EXPECT_FALSE(headerOf("P5 16384 16384 255\n").isTooLarge());
  EXPECT_TRUE(headerOf("P5 16385 1 255\n").isTooLarge());
  EXPECT_TRUE(headerOf("P5 1 99999999999999999999999 255\n").isTooLarge()) << "more than any number holds";
}

}  // namespace
}  // namespace wardslam::core
