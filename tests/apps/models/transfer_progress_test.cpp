#include "models/transfer_progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace wardslam::apps {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;

TEST(SizeText, UsesDecimalUnits) {
  EXPECT_EQ(sizeText(0), "0 B");
  EXPECT_EQ(sizeText(999), "999 B");
  EXPECT_EQ(sizeText(1000), "1.0 kB");
  EXPECT_EQ(sizeText(6163938), "6.2 MB");
  EXPECT_EQ(sizeText(177817887), "177.8 MB");
  EXPECT_EQ(sizeText(999999999), "1.0 GB");
  EXPECT_EQ(sizeText(12000000000000), "12000.0 GB");
}

TEST(TransferText, TellsRateAndTimeLeft) {
  EXPECT_EQ(transferText({0, 12000000, 62000000}, 4.8), "12.0 MB of 62.0 MB  2.5 MB/s  20 s left");
  EXPECT_EQ(transferText({0, 62000000, 62000000}, 24.8), "62.0 MB of 62.0 MB  2.5 MB/s  0 s left");
}

TEST(TransferText, DoesNotCountWhatWasThereForTheRate) {
  EXPECT_EQ(transferText({50000000, 60000000, 62000000}, 4.0), "60.0 MB of 62.0 MB  2.5 MB/s  1 s left");
}

TEST(TransferText, SaysNoMoreThanIsKnown) {
  EXPECT_EQ(transferText({0, 12000000, {}}, 4.8), "12.0 MB  2.5 MB/s");
  EXPECT_EQ(transferText({0, 0, 62000000}, 1.0), "0 B of 62.0 MB");
  EXPECT_EQ(transferText({0, 10, 100}, 0.0), "10 B of 100 B");
}

TEST(TransferProgress, DrawsOnTerminalsOnly) {
  std::ostringstream terminal;
  { TransferProgress(terminal, true, "net.onnx").update({0, 10, 10}); }
  EXPECT_THAT(terminal.str(), AllOf(HasSubstr("net.onnx  10 B of 10 B"), EndsWith("\n")));
  std::ostringstream file;
  { TransferProgress(file, false, "net.onnx").update({0, 10, 10}); }
  EXPECT_EQ(file.str(), "");
}

}  // namespace
}  // namespace wardslam::apps
