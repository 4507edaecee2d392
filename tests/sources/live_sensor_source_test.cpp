#include "wardslam/sources/live_sensor_source.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <thread>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

/// A fake camera (tests/sources/plugin) in a real process of its own.
class LiveSensor : public ::testing::Test {
 protected:
  /// Of 32x24 pixels. `keys`: lines for its section.
  [[nodiscard]] sources::LiveSensor camera(const std::string& keys = "", const std::string& driver = "FakeSensor") {
    const auto ini = folder.write("camera.ini", "[global]\nrawlog_prefix = x\n[CAMERA]\ndriver = " + driver +
                                                    "\nprocess_rate = 50\nsensorLabel = FAKE\n" + keys);
    sources::LiveSensor live;
    live.sensor = readSensorConfiguration(ini);
    live.plugins = {WARDSLAM_FAKE_SENSOR};
    live.options.open_timeout_s = 5.0;
    live.options.silence_timeout_s = 0.5;
    live.options.first_pause_s = 0.05;
    live.options.longest_pause_s = 0.1;
    live.options.max_waiting_frames = 3;
    return live;
  }
  [[nodiscard]] SourceOptions listening() {
    SourceOptions options;
    options.warn = [this](const std::string& sentence) { warnings.push_back(sentence); };
    return options;
  }
  [[nodiscard]] std::string place() const { return (folder.path() / "camera.ini").string() + ": [CAMERA]: "; }

  test::TemporaryFolder folder;
  std::vector<std::string> warnings;
};

/// makeScan() puts the number of the image into its first pixel.
int numberOf(const mrpt::obs::CObservation3DRangeScan& scan) { return scan.rangeImage(0, 0) - 1000; }

TEST_F(LiveSensor, DeliversWhatTheCameraSees) {
  auto live = camera();
  live.options.max_waiting_frames = 30;  // none is skipped
  LiveSensorSource source(live, listening());
  for (int number = 1; number <= 20; ++number) {
    const auto scan = source.next();
    ASSERT_NE(scan, nullptr);
    EXPECT_EQ(numberOf(*scan), number);
    EXPECT_TRUE(scan->hasIntensityImage);
  }
  EXPECT_EQ(source.size(), std::nullopt);
  EXPECT_EQ(source.counts().skipped, 0U);
  EXPECT_GE(source.counts().received, 20U);
  EXPECT_TRUE(warnings.empty());
}

TEST_F(LiveSensor, PassesOverOtherObservationsAndWhatDriversPrint) {
  auto live = camera("trouble = talks");
  live.options.max_waiting_frames = 30;
  LiveSensorSource source(live, listening());
  for (int number = 1; number <= 10; ++number) EXPECT_EQ(numberOf(*source.next()), number);
  EXPECT_EQ(source.counts().unusable, 0U);
}

TEST_F(LiveSensor, SkipsTheOldestWhenNobodyKeepsUp) {
  LiveSensorSource source(camera(), listening());
  const int before = numberOf(*source.next());
  while (source.counts().received < 30) std::this_thread::sleep_for(5ms);
  EXPECT_GT(numberOf(*source.next()), 30 - 4);  // not `before` + 1: at most three wait
  EXPECT_EQ(before, 1);
  source.close();
  const auto counts = source.counts();
  EXPECT_GT(counts.skipped, 20U);
  EXPECT_EQ(counts.received, 2 + counts.skipped);
}

TEST_F(LiveSensor, SaysWhenThereIsNoCamera) {
  EXPECT_THAT([&] { LiveSensorSource(camera("only_while = /no/such/file"), listening()); },
              ThrowsMessage<core::InputError>(place() + "no fake camera found"));
}

TEST_F(LiveSensor, SaysWhenACameraIsSilentFromTheStart) {
  auto live = camera("trouble = hangs\ngood_frames = 0");
  live.options.open_timeout_s = 1.0;
  EXPECT_THAT(
      [&] { LiveSensorSource(live, listening()); },
      ThrowsMessage<core::InputError>(place() + "the camera sent no image within 1 s; is another program using it?"));
}

TEST_F(LiveSensor, SaysWhichDriverWasMeant) {
  EXPECT_THAT([&] { LiveSensorSource(camera("", "COpenNI2Sens"), listening()); },
              ThrowsMessage<core::InputError>(EndsWith("did you mean 'COpenNI2Sensor'?")));
}

TEST_F(LiveSensor, SaysWhenAPluginCannotBeLoaded) {
  auto live = camera();
  live.plugins = {folder.write("no_library.so", "text")};
  EXPECT_THAT([&] { LiveSensorSource(live, listening()); },
              ThrowsMessage<core::InputError>(HasSubstr("no_library.so: cannot be loaded as a plug-in")));
}

TEST_F(LiveSensor, SaysWhenItsProgramIsAbsent) {
  auto live = camera();
  live.program = "/no/such/program";
  EXPECT_THAT([&] { LiveSensorSource(live, listening()); },
              ThrowsMessage<core::InputError>(StartsWith("/no/such/program: cannot be started")));
}

/// Trouble after five good images; the camera is there again when it is opened anew.
class LiveSensorLost : public LiveSensor, public ::testing::WithParamInterface<std::pair<const char*, const char*>> {};

TEST_P(LiveSensorLost, IsOpenedAgain) {
  const auto& [trouble, sentence] = GetParam();
  auto live = camera(std::string("trouble = ") + trouble);
  live.options.max_waiting_frames = 30;
  LiveSensorSource source(live, listening());
  for (int number = 1; number <= 5; ++number) EXPECT_EQ(numberOf(*source.next()), number);
  for (int number = 1; number <= 5; ++number) EXPECT_EQ(numberOf(*source.next()), number);
  EXPECT_EQ(source.counts().reconnects, 1U);
  EXPECT_THAT(warnings, ElementsAre(place() + sentence + "; trying to open it again",
                                    StartsWith(place() + "the camera is back after ")));
}

INSTANTIATE_TEST_SUITE_P(Each, LiveSensorLost,
                         ::testing::Values(std::pair("hangs",
                                                     "no image for 0.5 s; the camera is unplugged or its driver hangs"),
                                           std::pair("throws", "the plug was pulled"),
                                           std::pair("crashes", "the driver ended with signal 6 (Aborted)")),
                         [](const auto& kind) { return std::string(kind.param.first); });

TEST_F(LiveSensor, IsGivenUpWhenItStaysAway) {
  const auto present = folder.write("present", "");
  auto live = camera("trouble = throws\nonly_while = " + present.string());
  live.options.max_attempts = 3;
  LiveSensorSource source(live, listening());
  std::filesystem::remove(present);
  EXPECT_THAT(
      [&] {
        while (source.next()) {
        }
      },  // what came before is delivered
      ThrowsMessage<core::InputError>(place() + "no fake camera found (after 3 attempts to open it again)"));
}

TEST_F(LiveSensor, LeavesOutASingleBadObservation) {
  auto live = camera("trouble = depth_only_once");
  live.options.max_waiting_frames = 30;
  LiveSensorSource source(live, listening());
  for (const int number : {1, 2, 3, 4, 5, 7, 8}) EXPECT_EQ(numberOf(*source.next()), number);
  EXPECT_EQ(source.counts().unusable, 1U);
}

TEST_F(LiveSensor, SaysWhenItSeesDepthOnly) {
  EXPECT_THAT([&] { LiveSensorSource(camera("trouble = depth_only\ngood_frames = 0"), listening()); },
              ThrowsMessage<core::InputError>(place() + "every observation for 0.5 s has no intensity image"));
}

TEST_F(LiveSensor, SaysWhenImagesChangeTheirSize) {
  LiveSensorSource source(camera("trouble = resizes"), listening());
  EXPECT_THAT(
      [&] {
        while (source.next()) {
        }
      },
      ThrowsMessage<core::InputError>(
          place() + "every observation for 0.5 s has images of 64x48 pixels, but the run began with 32x24"));
}

TEST_F(LiveSensor, LeavesOutWhatAClockThatIsSetBackStamps) {
  auto live = camera("trouble = clock_set_back_once");
  live.options.max_waiting_frames = 30;
  LiveSensorSource source(live, listening());
  for (const int number : {1, 2, 3, 4, 5, 7, 8}) EXPECT_EQ(numberOf(*source.next()), number);
  EXPECT_EQ(source.counts().unusable, 1U);
}

TEST_F(LiveSensor, EndsWhereTheClockStaysSetBack) {
  LiveSensorSource source(camera("trouble = clock_set_back"), listening());
  EXPECT_THAT(
      [&] {
        while (source.next()) {
        }
      },
      ThrowsMessage<core::InputError>(place() + "every observation for 0.5 s is not younger than the one before it"));
}

TEST_F(LiveSensor, EndsWhenAskedTo) {
  auto live = camera("trouble = hangs");
  bool stop = false;
  live.stop = [&stop] { return stop; };
  LiveSensorSource source(live, listening());
  EXPECT_NE(source.next(), nullptr);
  stop = true;
  EXPECT_EQ(source.next(), nullptr);
}

TEST_F(LiveSensor, TakesTheGivenCalibration) {
  SourceOptions options = listening();
  options.camera = folder.write("camera.yaml", "width: 32\nheight: 24\nfx: 99\nfy: 99\ncx: 15\ncy: 11\n");
  LiveSensorSource source(camera(), options);
  EXPECT_EQ(source.next()->cameraParamsIntensity.fx(), 99.0);
}

}  // namespace
}  // namespace wardslam::sources
