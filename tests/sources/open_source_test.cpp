#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <thread>

#include "recording/rawlog_writer.h"
#include "sources/scan_maker.h"
#include "sources/tum_folder_writer.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/frame_builder.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam::sources {
namespace {

using test::TumFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(OpenSource, AMissingPathIsNamed) {
  EXPECT_THAT([] { return openSource("/no/such/place", {}); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("/no/such/place"), HasSubstr("no such file or folder"))));
}

TEST(OpenSource, AFolderWithoutListsIsNoSequence) {
  const test::TemporaryFolder folder;
  EXPECT_THAT([&] { return openSource(folder.path(), {}); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("rgb.txt"), HasSubstr("TUM sequence"))));
}

TEST(OpenSource, AMissingCameraFileIsNamed) {
  const TumFolder folder(1);
  SourceOptions options;
  options.camera = folder.path() / "none.yaml";
  EXPECT_THAT([&] { return openSource(folder.path(), options); },
              ThrowsMessage<core::InputError>(HasSubstr("none.yaml")));
}

TEST(OpenSource, WarnsInTheCallersThread) {
  const TumFolder folder(2);
  std::filesystem::remove(folder.path() / TumFolder::depthFile(0));
  const auto caller = std::this_thread::get_id();
  int warnings = 0;
  SourceOptions options;
  options.warn = [&](const std::string&) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    ++warnings;
  };
  const auto source = openSource(folder.path(), options);
  while (source->next()) continue;
  EXPECT_EQ(warnings, 1);
}

TEST(OpenSource, ARawlogMadeFromAFolderGivesTheSameFrames) {
  const TumFolder folder(3);
  const auto file = folder.path() / "copy.rawlog";
  {
    recording::RawlogWriter writer(file);
    const auto source = openSource(folder.path(), {});
    while (const auto scan = source->next()) writer.write(*scan);
    writer.commit();
  }
  const auto fromFolder = openSource(folder.path(), {});
  const auto fromRawlog = openSource(file, {});
  FrameBuilder folderFrames;
  FrameBuilder rawlogFrames;
  for (int i = 0; i < 3; ++i) {
    const core::Frame expected = folderFrames.build(fromFolder->next());
    const core::Frame frame = rawlogFrames.build(fromRawlog->next());
    EXPECT_EQ(frame.stamp_s, expected.stamp_s);
    EXPECT_EQ(cv::norm(frame.color_bgr, expected.color_bgr, cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(frame.gray, expected.gray, cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(frame.depth_m, expected.depth_m, cv::NORM_INF), 0.0);
    EXPECT_EQ(frame.camera.k1, expected.camera.k1);
    EXPECT_EQ(frame.camera.fy_px, expected.camera.fy_px);
  }
  EXPECT_FALSE(fromRawlog->next());
}

}  // namespace
}  // namespace wardslam::sources
