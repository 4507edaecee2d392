#include "wardslam/sources/sensor_link.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <thread>

#include "scan_maker.h"

namespace wardslam::sources {
namespace {

using namespace std::chrono_literals;
using Kind = SensorMessage::Kind;
using Status = SensorMessageReader::Status;

class SensorLink : public ::testing::Test {
 protected:
  SensorLink() { EXPECT_EQ(pipe(ends.data()), 0); }
  ~SensorLink() override {
    closeWriter();
    close(ends[0]);
  }
  void closeWriter() {
    if (ends[1] >= 0) close(ends[1]);
    ends[1] = -1;
  }

  std::array<int, 2> ends{};
};

TEST_F(SensorLink, CarriesMessagesOfAnySize) {
  const std::string image(3'000'000, 'x');  // more than a pipe holds
  std::thread sensor([&] {
    EXPECT_TRUE(writeMessage(ends[1], {Kind::Observation, image}));
    EXPECT_TRUE(writeMessage(ends[1], {Kind::Refusal, ""}));
    EXPECT_TRUE(writeMessage(ends[1], {Kind::Failure, "unplugged"}));
    closeWriter();
  });
  SensorMessageReader reader(ends[0]);
  SensorMessage message;
  ASSERT_EQ(reader.read(message, 10s), Status::Message);
  EXPECT_EQ(message.kind, Kind::Observation);
  EXPECT_EQ(message.bytes, image);
  ASSERT_EQ(reader.read(message, 10s), Status::Message);
  EXPECT_EQ(message.kind, Kind::Refusal);
  EXPECT_EQ(message.bytes, "");
  ASSERT_EQ(reader.read(message, 10s), Status::Message);
  EXPECT_EQ(message.kind, Kind::Failure);
  EXPECT_EQ(message.bytes, "unplugged");
  EXPECT_EQ(reader.read(message, 10s), Status::Closed);
  sensor.join();
}

TEST_F(SensorLink, SaysNothingWhileAMessageIsIncomplete) {
  SensorMessageReader reader(ends[0]);
  SensorMessage message;
  EXPECT_EQ(reader.read(message, 20ms), Status::Nothing);
  ASSERT_EQ(write(ends[1], "\1\4\0\0\0ab", 7), 7);
  EXPECT_EQ(reader.read(message, 20ms), Status::Nothing);
  ASSERT_EQ(write(ends[1], "cd", 2), 2);
  ASSERT_EQ(reader.read(message, 20ms), Status::Message);
  EXPECT_EQ(message.bytes, "abcd");
}

TEST_F(SensorLink, TellsWriterThatNobodyReads) {
  std::signal(SIGPIPE, SIG_IGN);
  close(ends[0]);
  EXPECT_FALSE(writeMessage(ends[1], {Kind::Failure, "heard by nobody"}));
  std::signal(SIGPIPE, SIG_DFL);
}

TEST(PackedObservation, IsWhatItWas) {
  mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(true);
  const auto scan = test::makeScan(3);
  const auto copy = unpackObservation(packObservation(*scan));
  ASSERT_NE(copy, nullptr);
  EXPECT_EQ(copy->timestamp, scan->timestamp);
  EXPECT_EQ(copy->sensorLabel, scan->sensorLabel);
  EXPECT_EQ(copy->rangeImage, scan->rangeImage);
  EXPECT_EQ(cv::norm(copy->intensityImage.asCvMatRef(), scan->intensityImage.asCvMatRef(), cv::NORM_INF), 0.0);
  EXPECT_EQ(copy->cameraParams, scan->cameraParams);
}

TEST(PackedObservation, IsNullFromOtherBytes) {
  EXPECT_EQ(unpackObservation(""), nullptr);
  EXPECT_EQ(unpackObservation("no observation"), nullptr);
  EXPECT_EQ(unpackObservation(packObservation(*test::makeScan()).substr(0, 100)), nullptr);
}

}  // namespace
}  // namespace wardslam::sources
