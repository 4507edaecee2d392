#include "wardslam/bags/image_decoding.h"

#include <gmock/gmock.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "bag_writing.h"

namespace wardslam::bags {
namespace {

using ::testing::HasSubstr;

Image imageOf(const std::string& encoding, std::uint32_t width, std::uint32_t height, std::uint32_t step,
              const Bytes& data) {
  Image image;
  image.encoding = encoding;
  image.width_px = width;
  image.height_px = height;
  image.step_bytes = step;
  image.data = data;
  return image;
}

TEST(ImageDecoding, ColorsComeOutBlueGreenRed) {
  const Bytes rgb = {1, 2, 3};
  const Bytes rgba = {1, 2, 3, 9};
  EXPECT_EQ(decodeColor(imageOf("rgb8", 1, 1, 3, rgb)).at<cv::Vec3b>(0), cv::Vec3b(3, 2, 1));
  EXPECT_EQ(decodeColor(imageOf("bgr8", 1, 1, 3, rgb)).at<cv::Vec3b>(0), cv::Vec3b(1, 2, 3));
  EXPECT_EQ(decodeColor(imageOf("8UC3", 1, 1, 3, rgb)).at<cv::Vec3b>(0), cv::Vec3b(1, 2, 3));
  EXPECT_EQ(decodeColor(imageOf("rgba8", 1, 1, 4, rgba)).at<cv::Vec3b>(0), cv::Vec3b(3, 2, 1));
  EXPECT_EQ(decodeColor(imageOf("bgra8", 1, 1, 4, rgba)).at<cv::Vec3b>(0), cv::Vec3b(1, 2, 3));
  EXPECT_EQ(decodeColor(imageOf("mono8", 3, 1, 3, rgb)).at<std::uint8_t>(2), 3);
}

TEST(ImageDecoding, RowsMayBeLongerThanTheirPixels) {
  const Bytes data = {1, 2, 0xEE, 0xEE, 3, 4};  // the last row need not be filled up
  const cv::Mat image = decodeColor(imageOf("mono8", 2, 2, 4, data));
  EXPECT_EQ(image.at<std::uint8_t>(1, 0), 3);
  EXPECT_EQ(image.at<std::uint8_t>(1, 1), 4);
}

TEST(ImageDecoding, DepthMayHaveTheOtherByteOrder) {
  const Bytes data = {0x03, 0xE8};
  Image image = imageOf("16UC1", 1, 1, 2, data);
  EXPECT_EQ(decodeDepth(image).units.at<std::uint16_t>(0), 0xE803);
  image.isBigEndian = true;
  EXPECT_EQ(decodeDepth(image).units.at<std::uint16_t>(0), 1000);
  EXPECT_EQ(decodeDepth(image).unit_m, 0.001);
}

TEST(ImageDecoding, MetresNeverWrap) {
  test::BytesMaker data;
  for (const float z_m : {1.0F, NAN, 13.107F, 13.2F, -1.0F, 0.0F, INFINITY}) data.number(z_m);
  const DepthImage depth = decodeDepth(imageOf("32FC1", 7, 1, 28, data.bytes()));
  const auto units = [&](int column) { return depth.units.at<std::uint16_t>(column); };
  EXPECT_EQ(depth.unit_m, 0.0002);
  EXPECT_EQ(units(0), 5000);
  EXPECT_EQ(units(1), 0);
  EXPECT_EQ(units(2), 65535);
  EXPECT_EQ(units(3), 0);
  EXPECT_EQ(units(4), 0);
  EXPECT_EQ(units(5), 0);
  EXPECT_EQ(units(6), 0);
  EXPECT_EQ(depth.tooFar, 1U);
}

TEST(ImageDecoding, BelievesNoSizeThatTheDataDoNotHold) {
  const Bytes data(12);
  EXPECT_THROW(decodeColor(imageOf("rgb8", 2, 3, 6, data)), BagDamage);
  EXPECT_THROW(decodeColor(imageOf("rgb8", 4, 1, 11, data)), BagDamage);
  EXPECT_THROW(decodeColor(imageOf("rgb8", 0, 1, 12, data)), BagDamage);
  EXPECT_THROW(decodeColor(imageOf("rgb8", 0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF, data)), BagDamage);
}

TEST(ImageDecoding, NamesAnEncodingThatIsNotRead) {
  try {
    static_cast<void>(decodeColor(imageOf("bayer_rggb8", 2, 2, 2, Bytes(4))));
    FAIL();
  } catch (const BagDamage& damage) {
    EXPECT_THAT(damage.what(), HasSubstr("bayer_rggb8"));
    EXPECT_THAT(damage.what(), HasSubstr("image_proc"));
  }
}

Bytes pngOf(const cv::Mat& image) {
  Bytes png;
  cv::imencode(".png", image, png);
  return png;
}

CompressedImage compressed(const std::string& format, const Bytes& data) {
  CompressedImage image;
  image.format = format;
  image.data = data;
  return image;
}

TEST(ImageDecoding, UnpacksCompressedDepthOfMillimetres) {
  const cv::Mat mm = (cv::Mat_<std::uint16_t>(1, 2) << 0, 1234);
  const Bytes data = test::BytesMaker().raw(Bytes(12)).raw(pngOf(mm)).bytes();
  for (const char* format : {"16UC1; compressedDepth", "16UC1; compressedDepth png"}) {
    const DepthImage depth = decodeDepth(compressed(format, data));
    EXPECT_EQ(depth.units.at<std::uint16_t>(1), 1234);
    EXPECT_EQ(depth.unit_m, 0.001);
  }
}

TEST(ImageDecoding, UnpacksCompressedDepthOfMetres) {
  const cv::Mat inverse = (cv::Mat_<std::uint16_t>(1, 2) << 0, 201);
  const Bytes header = test::BytesMaker().number<std::uint32_t>(1).number(400.0F).number(1.0F).bytes();
  const Bytes data = test::BytesMaker().raw(header).raw(pngOf(inverse)).bytes();
  const DepthImage depth = decodeDepth(compressed("32FC1; compressedDepth png", data));
  EXPECT_EQ(depth.units.at<std::uint16_t>(0), 0);
  EXPECT_EQ(depth.units.at<std::uint16_t>(1), 10000);  // 400 / (201 - 1) = 2 m in steps of 0.2 mm
}

TEST(ImageDecoding, UnpacksCompressedColors) {
  const cv::Mat bgr(2, 2, CV_8UC3, cv::Scalar(10, 20, 30));
  const Bytes png = pngOf(bgr);
  EXPECT_EQ(decodeColor(compressed("rgb8; png compressed bgr8", png)).at<cv::Vec3b>(0), cv::Vec3b(10, 20, 30));
}

TEST(ImageDecoding, RefusesDepthInEightBits) {
  const Bytes png = pngOf(cv::Mat(2, 2, CV_8UC1, cv::Scalar(3)));
  EXPECT_THROW(decodeDepth(compressed("png", png)), BagDamage);
}

TEST(ImageDecoding, BelievesNoSizeOfACompressedImage) {
  Bytes png = pngOf(cv::Mat(2, 2, CV_8UC3, cv::Scalar(3)));
  png[16] = 0x7F;  // width: 2 billion pixels
  EXPECT_THROW(decodeColor(compressed("png", png)), BagDamage);
  EXPECT_THROW(decodeColor(compressed("jpeg", Bytes{0xFF, 0xD8, 0xFF, 0xC0, 0, 17, 8, 0xFF, 0xFF, 0xFF, 0xFF, 3, 1})),
               BagDamage);
  EXPECT_THROW(decodeColor(compressed("jpeg", Bytes{})), BagDamage);
}

}  // namespace
}  // namespace wardslam::bags
