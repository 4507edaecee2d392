#include "wardslam/sources/rawlog_reader.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include "recording/rawlog_writer.h"
#include "sources/scan_maker.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/input_damage.h"

namespace wardslam::sources {
namespace {

class ReadRawlog : public ::testing::Test {
 protected:
  test::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "in.rawlog";
};

TEST_F(ReadRawlog, CopiesObjectsByteForByte) {
  recording::RawlogWriter writer(file, recording::ImageCoding::Jpeg);  // coding an image again would change it
  for (int i = 0; i < 3; ++i) writer.write(*test::makeScan(i));
  writer.commit();
  const auto copy = folder.path() / "copy.rawlog";
  RawlogReader reader(file);
  recording::RawlogWriter copier(copy);
  while (reader.read()) copier.write(reader.bytes());
  copier.commit();
  EXPECT_EQ(reader.objects(), 3U);
  EXPECT_EQ(test::readText(copy), test::readText(file));
}

TEST_F(ReadRawlog, KnowsObservationsOfOtherLibrariesOfMrpt) {
  recording::RawlogWriter writer(file);
  auto cloud = mrpt::obs::CObservationPointCloud();
  cloud.sensorLabel = "LIDAR";
  writer.write(cloud);
  writer.commit();
  RawlogReader reader(file);
  const auto observations = observationsIn(reader.read());
  ASSERT_EQ(observations.size(), 1U);
  EXPECT_EQ(observations[0]->sensorLabel, "LIDAR");
  EXPECT_EQ(reader.read(), nullptr);
}

TEST_F(ReadRawlog, TellsHowFarItIs) {
  recording::RawlogWriter writer(file);
  for (int i = 0; i < 20; ++i) writer.write(*test::makeScan(i, 320, 240));
  writer.commit();
  RawlogReader reader(file);
  EXPECT_EQ(reader.fraction(), 0.0);
  double last = 0.0;
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(reader.read());
    EXPECT_GE(reader.fraction(), last);
    last = reader.fraction();
  }
  EXPECT_NEAR(last, 0.5, 0.15);
  while (reader.read()) continue;
  EXPECT_EQ(reader.fraction(), 1.0);
}

TEST_F(ReadRawlog, EndsAtAnObjectThatIsCutOff) {
  recording::RawlogWriter writer(file);
  writer.write(*test::makeScan(0));
  writer.write(*test::makeScan(1));
  writer.commit();
  const auto size = std::filesystem::file_size(file);
  std::filesystem::resize_file(file, size - size / 6);
  RawlogReader reader(file);
  EXPECT_TRUE(reader.read());
  EXPECT_THROW(static_cast<void>(reader.read()), InputDamage);
  EXPECT_EQ(reader.read(), nullptr);
}

TEST_F(ReadRawlog, ThatIsAbsentIsAnError) { EXPECT_THROW(RawlogReader{file}, core::InputError); }

TEST(ObservationsIn, ASensoryFrameAreThoseInIt) {
  const auto frame = std::make_shared<mrpt::obs::CSensoryFrame>();
  const auto scan = test::makeScan();
  frame->insert(std::make_shared<mrpt::obs::CObservationOdometry>());
  frame->insert(scan);
  const auto observations = observationsIn(frame);
  ASSERT_EQ(observations.size(), 2U);
  EXPECT_EQ(observations[1], scan);
}

}  // namespace
}  // namespace wardslam::sources
