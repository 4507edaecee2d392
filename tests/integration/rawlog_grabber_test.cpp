#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cstdlib>
#include <memory>
#include <opencv2/core.hpp>
#include <regex>
#include <string>

#include "support/temporary_folder.h"
#include "virtual_camera.h"
#include "wardslam/core/annotation.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;

#ifdef WARDSLAM_VIRTUAL_OPENNI2

/// MRPT's own program with our sensor configurations and plug-in.
class RawlogGrabber : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v rawlog-grabber > /dev/null") != 0) {
      GTEST_SKIP() << "rawlog-grabber comes with the Debian package mrpt-apps";
    }
  }

  /// Records some scans with a configuration that comes with the program; the rawlog.
  [[nodiscard]] fs::path record(const std::string& configuration, const std::string& options = "") const {
    std::string ini = test::readText(fs::path(WARDSLAM_CONFIG_DIR) / "sensors" / configuration);
    ini =
        std::regex_replace(ini, std::regex("rawlog_prefix *= .*"), "rawlog_prefix = " + (folder.path() / "r").string());
    const auto file = folder.write("grabber.ini", ini);
    // It ends at the first key, and also when its input ends. 20 MB are about ten scans.
    const std::string rawlogs = (folder.path() / "r*.rawlog").string();
    const std::string untilEnough = "for i in $(seq 100); do sleep 0.2; [ $(stat -c %s " + rawlogs +
                                    " 2> /dev/null || echo 0) -gt 20000000 ] && break; done; echo q";
    const std::string log = (folder.path() / "log").string();
    const std::string grab = "rawlog-grabber " + options + " " + file.string() + " > " + log + " 2>&1";
    EXPECT_EQ(std::system(("(" + untilEnough + ") | " + grab).c_str()), 0) << test::readText(log);
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      if (entry.path().extension() == ".rawlog") return entry.path();
    }
    ADD_FAILURE() << test::readText(log);
    return {};
  }

  test::VirtualCamera camera;
  test::TemporaryFolder folder;
};

TEST_F(RawlogGrabber, TakesTheConfigurationOfLiveRuns) {
  const auto source = sources::openSource(record("openni2.ini"), {});
  std::size_t scans = 0;
  for (; const auto scan = source->next(); ++scans) EXPECT_EQ(scan->sensorLabel, "OPENNI2");
  EXPECT_GT(scans, 5U);
  EXPECT_TRUE(source->damage().empty());
}

TEST_F(RawlogGrabber, RecordsAnnotatedScansWithThePlugin) {
  const auto source = sources::openSource(record("semantic_openni2.ini", "-p " WARDSLAM_MRPT_PLUGIN), {});
  std::size_t scans = 0;
  for (; const auto scan = source->next(); ++scans) {
    EXPECT_EQ(scan->sensorLabel, "CAMERA");
    EXPECT_EQ(core::annotationOf(*scan).size(), cv::Size(640, 480));
    EXPECT_TRUE(scan->hasConfidenceImage);
  }
  EXPECT_GT(scans, 5U);
  EXPECT_TRUE(source->damage().empty());
}

#else

TEST(RawlogGrabber, NeedsOpenNi2) {
  GTEST_SKIP() << "built without the virtual camera: it needs the Debian package libopenni2-dev";
}

#endif

}  // namespace
}  // namespace wardslam
