#include "map_feed.h"

#include <gmock/gmock.h>

#include <chrono>
#include <future>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::pipeline {
namespace {

std::unique_ptr<mapping::MapBuilder> makeBuilder() {
  return std::make_unique<mapping::MapBuilder>(mapping::MappingOptions{}, mapping::MapSetting{});
}

/// Of a wall two metres ahead.
core::Frame makeFrame(double stamp_s) {
  core::Frame frame;
  frame.stamp_s = stamp_s;
  frame.camera.width_px = 40;
  frame.camera.height_px = 30;
  frame.camera.fx_px = frame.camera.fy_px = 30.0;
  frame.camera.cx_px = 19.5;
  frame.camera.cy_px = 14.5;
  frame.color_bgr = cv::Mat(30, 40, CV_8UC3, cv::Scalar(200, 190, 180));
  frame.depth_m = cv::Mat(30, 40, CV_32FC1, cv::Scalar(2.0));
  return frame;
}

/// A frame a second, all of them tracked; keyframes are those of the hand-made ward.
class MapFeedTest : public testing::Test {
 protected:
  void update(odometry::KeyframeId id, bool isKeyframe, const std::vector<odometry::MapUpdate>& updates = {}) {
    update(feed_, id, isKeyframe, updates);
  }
  void update(MapFeed& feed, odometry::KeyframeId id, bool isKeyframe,
              const std::vector<odometry::MapUpdate>& updates = {}) {
    odometry::OdometryResult odometry;
    odometry.state = odometry::State::Ok;
    odometry.referenceKeyframe = id;
    if (isKeyframe) odometry.keyframe = test::makeView(id, ward_);
    SharedUpdates shared;
    for (const auto& found : updates) shared.push_back(std::make_shared<const odometry::MapUpdate>(found));
    feed.update(makeFrame(stamp_s_ += 1.0), odometry, shared);
  }
  [[nodiscard]] std::size_t calls(const std::string& step) const {
    const auto statistics = profiler_.statistics();
    const auto found = statistics.find(step);
    return found == statistics.end() ? 0 : found->second.calls;
  }
  [[nodiscard]] static odometry::MapUpdate moved(odometry::KeyframeId id, double x_m) {
    odometry::MapUpdate update;
    update.T_map_cam[id] = Eigen::Isometry3d(Eigen::Translation3d(x_m, 0, 0));
    return update;
  }

  double stamp_s_ = 0.0;
  mapping::SemanticMap ward_ = test::makeWard();
  core::Profiler profiler_;
  core::Stage<mapping::MapBuilder> stage_{makeBuilder(), core::StageThread::Caller};
  MapFeed feed_{stage_, {{}, false}, profiler_, WhenBehind::LeavesViewsOut};
};

TEST_F(MapFeedTest, AKeyframeIsThereBeforeWhatTheGraphSaysOfIt) {
  const auto x_m = [&] {
    double found_m = 0.0;
    stage_.post([&](mapping::MapBuilder& b) { found_m = b.map().keyframes.at(1).T_map_cam.translation().x(); });
    return found_m;
  };
  update(1, true, {moved(1, 5.0)});
  EXPECT_EQ(x_m(), 5.0);
  feed_.apply(std::make_shared<const odometry::MapUpdate>(moved(1, 6.0)));
  EXPECT_EQ(x_m(), 6.0);
}

TEST_F(MapFeedTest, ViewsAreTimedAndTheFileIsWrittenAfterEveryKeyframe) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "map.wardmap";
  storage::MapFileWriter writer(path, {ward_.labels, "deterministic: true\n"});
  feed_.writeTo(writer);
  const auto inFile = [&] { return storage::MapFile::open(path).read().keyframes; };
  update(1, true, {moved(1, 5.0)});
  ASSERT_EQ(inFile().size(), 1U);
  EXPECT_EQ(inFile().at(1).T_map_cam.translation().x(), 5.0) << "written after what the graph found out";
  update(1, false, {moved(1, 6.0)});
  EXPECT_EQ(inFile().at(1).T_map_cam.translation().x(), 5.0) << "not at a frame that is no keyframe";
  update(2, true);
  EXPECT_EQ(inFile().size(), 2U);
  EXPECT_EQ(inFile().at(1).T_map_cam.translation().x(), 6.0);
  EXPECT_EQ(calls("mapping.add"), 3U);
  EXPECT_EQ(calls("storage.write"), 2U);
}

TEST_F(MapFeedTest, WithoutAFileNothingIsWritten) {
  update(1, true);
  EXPECT_EQ(calls("mapping.add"), 1U);
  EXPECT_EQ(calls("storage.write"), 0U);
}

/// Keeps a stage busy until it is opened.
class Gate {
 public:
  explicit Gate(core::Stage<mapping::MapBuilder>& stage) {
    stage.post([this](mapping::MapBuilder&) {
      reached_.set_value();
      open_.get_future().wait();
    });
    reached_.get_future().wait();
  }
  void open() { open_.set_value(); }

 private:
  std::promise<void> reached_;
  std::promise<void> open_;
};

TEST_F(MapFeedTest, OfACameraOnlyViewsThatAreNoKeyframesAreLeftOut) {
  core::Stage<mapping::MapBuilder> stage(makeBuilder(), core::StageThread::Own, {64, 2});
  Gate gate(stage);
  MapFeed feed(stage, {{}, false}, profiler_, WhenBehind::LeavesViewsOut);
  for (const odometry::KeyframeId id : {1, 2, 3}) {
    update(feed, id, true);
    update(feed, id, false);
  }
  EXPECT_EQ(stage.leftOut(), 1U);
  gate.open();
  EXPECT_EQ(stage.finish()->map().keyframes.size(), 3U);
  EXPECT_EQ(calls("mapping.add"), 5U) << "all three keyframes' and two of the others";
}

TEST_F(MapFeedTest, ARecordingWaitsUntilEveryViewIsWorkedIn) {
  core::Stage<mapping::MapBuilder> stage(makeBuilder(), core::StageThread::Own, {2, 0});
  Gate gate(stage);
  MapFeed feed(stage, {{}, false}, profiler_, WhenBehind::Waits);
  auto recording = std::async(std::launch::async, [&] {
    update(feed, 1, true);
    for (int i = 0; i < 20; ++i) update(feed, 1, false);
  });
  EXPECT_EQ(recording.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  gate.open();
  recording.get();
  (void)stage.finish();
  EXPECT_EQ(stage.leftOut(), 0U);
  EXPECT_EQ(calls("mapping.add"), 21U);
}

}  // namespace
}  // namespace wardslam::pipeline
