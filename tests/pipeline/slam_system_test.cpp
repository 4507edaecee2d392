#include "wardslam/pipeline/slam_system.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <new>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "support/complaint.h"
#include "support/full_disk.h"
#include "support/temporary_folder.h"
#include "support/textured_room_scan.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/storage/map_file.h"
#include "wardslam/storage/map_file_writer.h"

namespace wardslam::test {

/// Writes down what is asked of it, and rejects every other key point.
class RecordingFilter : public filters::ObservationFilter {
  DEFINE_MRPT_OBJECT(RecordingFilter, wardslam::test)

 public:
  static std::vector<std::string>& log() {
    static std::vector<std::string> lines;
    return lines;
  }

  void initialize(const core::ConfigNode&, const filters::FilterContext& context) override {
    log().emplace_back(context.knowledge ? "initialize" : "initialize without knowledge");
  }
  void begin(const core::Frame& frame) override {
    log().push_back("begin" + number(frame) + (frame.features.size() == 0 ? "" : " too late"));
  }
  void apply(core::Frame& frame) override {
    log().push_back("apply" + number(frame) + (frame.features.size() > 0 ? "" : " too early"));
    auto& keypoints = frame.features.keypoints;
    for (std::size_t i = 0; i < keypoints.size(); i += 2) keypoints[i].motion = core::Motion::Dynamic;
    ++frame.events["test.applied"];
  }
  [[nodiscard]] std::string parameters(int) const override { return {}; }

 private:
  static std::string number(const core::Frame& frame) { return " " + std::to_string(frame.index); }
};

IMPLEMENTS_MRPT_OBJECT(RecordingFilter, filters::ObservationFilter, wardslam::test)

}  // namespace wardslam::test

namespace wardslam::pipeline {
namespace {

using mrpt::obs::CObservation3DRangeScan;
using test::observe;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Writes into the log of the filter, so that the order of all shows.
class RecordingObserver : public FrameObserver {
 public:
  explicit RecordingObserver(std::string name) : name_(std::move(name)) {}

  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override {
    test::RecordingFilter::log().push_back(name_ + " " + std::to_string(frame.index) + " " +
                                           odometry::toString(odometry.state));
    staticKeypoints = core::selectStatic(frame.features).size();
    keypoints = frame.features.size();
    events = frame.events;
    lastMatches = odometry.matches;
  }

  std::size_t staticKeypoints = 0;
  std::size_t keypoints = 0;
  int lastMatches = 0;
  core::EventCounts events;

 private:
  std::string name_;
};

class SlamSystemTest : public ::testing::Test {
 protected:
  void SetUp() override {
    mrpt::rtti::registerClass(CLASS_ID(test::RecordingFilter));
    test::RecordingFilter::log().clear();
  }

  static SlamOptions startingInTheMiddle() {
    SlamOptions options;
    options.map_frame.start_pose = "0 0 0 0 0 0 1";
    return options;
  }
  static SlamOptions withoutFilters() {
    SlamOptions options = startingInTheMiddle();
    options.filters = SlamOptions::noFilters();
    return options;
  }
  static SlamOptions withRecordingFilter() {
    SlamOptions options = startingInTheMiddle();
    options.filters = core::ConfigNode::fromText("[{class_name: 'wardslam::test::RecordingFilter'}]");
    return options;
  }

  const test::TexturedRoom room_;
};

TEST_F(SlamSystemTest, TracksARoom) {
  SlamSystem slam(withoutFilters());
  for (int image = 0; image < 10; ++image) {
    const auto result = slam.process(observe(room_, image));
    ASSERT_EQ(result.state, odometry::State::Ok) << image;
    const Eigen::Isometry3d T_room_cam = test::TexturedRoom::T_room_cam(image);
    EXPECT_LT((result.T_map_cam.translation() - T_room_cam.translation()).norm(), 0.006) << image;
    EXPECT_TRUE(result.T_map_cam.linear().isApprox(T_room_cam.linear(), 0.005)) << image;
  }
  slam.finish();
}

TEST_F(SlamSystemTest, InThreadsOrNotTheMapHoldsAllKeyframesInTheEnd) {
  for (const bool deterministic : {true, false}) {
    SlamOptions options = withoutFilters();
    options.deterministic = deterministic;
    SlamSystem slam(options);
    ASSERT_TRUE(slam.buildsSemanticMap());
    std::size_t keyframes = 0;
    for (int image = 0; image < 10; ++image) keyframes += slam.process(observe(room_, image)).keyframe ? 1U : 0U;
    slam.finish();
    EXPECT_EQ(slam.mapper().graph().keyframes().size(), keyframes);
    EXPECT_EQ(slam.semanticMap().keyframes.size(), keyframes);
    EXPECT_EQ(slam.mapBuilder()->map().keyframes.size(), keyframes);
    EXPECT_THAT(slam.leftOut(), testing::IsEmpty());
    const auto* mapper = &slam.mapper();
    slam.finish();
    EXPECT_EQ(&slam.mapper(), mapper) << "asking twice does no harm";
    EXPECT_EQ(slam.semanticMap().keyframes.size(), keyframes);
    EXPECT_EQ(slam.trajectory().size(), 10U);
  }
}

/// The last adjustment of all included.
TEST_F(SlamSystemTest, GraphMapFileAndTrajectoryAgreeInTheEnd) {
  for (const bool deterministic : {true, false}) {
    const test::TemporaryFolder folder;
    SlamOptions options = withoutFilters();
    options.deterministic = deterministic;
    storage::MapFileWriter writer(folder.path() / "map.wardmap", {});
    SlamSystem slam(options);
    slam.writeTo(writer);
    for (int image = 0; image < 12; ++image) slam.process(observe(room_, image));
    slam.finish();
    writer.finish(*slam.mapBuilder(), slam.mapper());
    const auto inFile = storage::MapFile::open(folder.path() / "map.wardmap").read().keyframes;
    const auto trajectory = slam.trajectory();
    ASSERT_GE(inFile.size(), 2U);
    for (const auto& [id, keyframe] : inFile) {
      const auto& T_graph = slam.mapper().graph().keyframes().at(id).T_map_cam;
      EXPECT_TRUE(keyframe.T_map_cam.isApprox(T_graph, 1e-9)) << id << ", deterministic: " << deterministic;
      const auto pose = std::find_if(trajectory.begin(), trajectory.end(),
                                     [&stamp_s = keyframe.stamp_s](const auto& p) { return p.stamp_s == stamp_s; });
      ASSERT_NE(pose, trajectory.end());
      EXPECT_TRUE(pose->T_map_cam.isApprox(T_graph, 1e-9)) << id << ", deterministic: " << deterministic;
    }
  }
}

TEST_F(SlamSystemTest, TellsWhatThereIsWhileItGoesOn) {
  for (const bool deterministic : {true, false}) {
    SlamOptions options = withoutFilters();
    options.deterministic = deterministic;
    SlamSystem slam(options);
    for (std::size_t images = 1; images <= 12; ++images) {
      slam.process(observe(room_, static_cast<int>(images)));
      const MapSoFar soFar = slam.mapSoFar();
      EXPECT_EQ(soFar.trajectory.size(), images);
      EXPECT_TRUE(soFar.semantic.keyframes.at(1).T_map_cam.isApprox(soFar.T_map_cam.at(1), 1e-9));
    }
  }
}

TEST_F(SlamSystemTest, WithoutMappingThereIsNoSemanticMap) {
  SlamOptions options = withoutFilters();
  options.mapping.enabled = false;
  SlamSystem slam(options);
  EXPECT_FALSE(slam.buildsSemanticMap());
  slam.process(observe(room_, 0));
  slam.finish();
  EXPECT_EQ(slam.mapBuilder(), nullptr);
  EXPECT_TRUE(slam.semanticMap().keyframes.empty());
  EXPECT_EQ(slam.mapper().graph().keyframes().size(), 1U);
}

TEST_F(SlamSystemTest, GoesOnInTheMapOfAnEarlierRun) {
  SlamOptions options = withoutFilters();
  options.deterministic = true;
  EarlierMap earlier;
  {
    SlamSystem first(options);
    for (int image = 0; image < 10; ++image) first.process(observe(room_, image));
    first.finish();
    earlier = {graph::save(first.mapper().graph()), first.semanticMap(), graph::Saved::MayChange};
  }
  ASSERT_FALSE(earlier.graph.keyframes.empty());
  SlamSystem second(options, earlier);
  for (int image = 3; image < 12; ++image) second.process(observe(room_, image));
  second.finish();
  EXPECT_EQ(second.mapper().submapsJoined(), 1U);
  const auto trajectory = second.trajectory();
  ASSERT_EQ(trajectory.size(), 9U);
  for (int image = 3; image < 12; ++image) {
    const auto& T_map_cam = trajectory[static_cast<std::size_t>(image - 3)].T_map_cam;
    EXPECT_LT((T_map_cam.translation() - test::TexturedRoom::T_room_cam(image).translation()).norm(), 0.006) << image;
  }
  EXPECT_GT(second.semanticMap().keyframes.size(), earlier.semantic.keyframes.size());
  EXPECT_EQ(second.semanticMap().cloud.count(1), 1U) << "what the first run saw";
}

TEST_F(SlamSystemTest, LocalisesInAMapWithoutMovingIt) {
  for (const bool deterministic : {true, false}) {
    SlamOptions options = withoutFilters();
    options.deterministic = true;
    SlamSystem first(options);
    for (int image = 0; image < 20; ++image) first.process(observe(room_, image));
    first.finish();
    const EarlierMap earlier{graph::save(first.mapper().graph()), first.semanticMap(), graph::Saved::IsHeld};
    options.deterministic = deterministic;
    options.mapping.enabled = false;
    SlamSystem second(options, earlier);
    for (int image = 0; image < 20; ++image) second.process(observe(room_, image));
    second.finish();
    EXPECT_EQ(second.mapper().submapsJoined(), 1U);
    const auto trajectory = second.trajectory();
    ASSERT_EQ(trajectory.size(), 20U);
    for (const auto& keyframe : earlier.graph.keyframes) {
      const auto& T_map_cam = second.mapper().graph().keyframes().at(keyframe->id).T_map_cam;
      EXPECT_EQ(T_map_cam.matrix(), keyframe->T_map_cam.matrix());
      const auto again = std::find_if(trajectory.begin(), trajectory.end(),
                                      [&](const auto& p) { return p.stamp_s == keyframe->stamp_s; });
      ASSERT_NE(again, trajectory.end());
      EXPECT_LT((again->T_map_cam.translation() - T_map_cam.translation()).norm(), 0.003) << keyframe->id;
    }
    const auto& points = second.mapper().graph().points();
    for (const auto& [id, p_map_m] : earlier.graph.p_map_m) EXPECT_EQ(points.at(id).point.p_map_m, p_map_m) << id;
  }
}

/// The one keyframe is mostly worked in when no image comes any more.
TEST_F(SlamSystemTest, TellsThatTheMapWasRecognisedAlsoWhenThatIsFoundOutInTheEnd) {
  SlamOptions options = withoutFilters();
  options.deterministic = true;
  EarlierMap earlier;
  SlamSystem first(options);
  for (int image = 0; image < 10; ++image) first.process(observe(room_, image));
  first.finish();
  earlier.graph = graph::save(first.mapper().graph());
  earlier.semantic = first.semanticMap();
  for (const bool deterministic : {true, false}) {
    options.deterministic = deterministic;
    SlamSystem second(options, earlier);
    second.process(observe(room_, 3));
    second.finish();
    ASSERT_EQ(second.mapper().submapsJoined(), 1U) << deterministic;
    EXPECT_TRUE(second.recognisedAt_s()) << deterministic;
  }
}

TEST_F(SlamSystemTest, ClassesOfAnEarlierMapMustMeanTheSame) {
  EarlierMap earlier;
  earlier.semantic.labels.rename(60, "operating table");
  earlier.semantic.objects[1].classId = 60;
  EXPECT_THAT([&] { SlamSystem(withoutFilters(), earlier); },
              ThrowsMessage<core::InputError>(HasSubstr("class 60 is 'operating table' in the map but 'bed'")));
}

TEST_F(SlamSystemTest, StagesComeInOrder) {
  SlamSystem slam(withRecordingFilter());
  RecordingObserver first("first");
  RecordingObserver second("second");
  slam.addObserver(first);
  slam.addObserver(second);
  slam.process(observe(room_, 0));
  slam.process(observe(room_, 1));
  EXPECT_THAT(test::RecordingFilter::log(),
              ElementsAre("initialize", "begin 0", "apply 0", "first 0 ok", "second 0 ok",  //
                          "begin 1", "apply 1", "first 1 ok", "second 1 ok"));
}

TEST_F(SlamSystemTest, OdometryGetsTheStaticKeypointsAlone) {
  SlamSystem slam(withRecordingFilter());
  RecordingObserver observer("observer");
  slam.addObserver(observer);
  const auto result = slam.process(observe(room_, 0));
  ASSERT_NE(result.keyframe, nullptr);
  EXPECT_EQ(observer.staticKeypoints, observer.keypoints / 2);
  EXPECT_EQ(result.keyframe->features.size(), observer.staticKeypoints);
  EXPECT_EQ(observer.events.at("test.applied"), 1U);
  slam.process(observe(room_, 1));
  EXPECT_GT(observer.lastMatches, 50);
}

TEST_F(SlamSystemTest, AnUnusableObservationIsLeftOutAndItGoesOn) {
  SlamSystem slam(withRecordingFilter());
  RecordingObserver observer("observer");
  slam.addObserver(observer);
  slam.process(observe(room_, 0));
  const auto withoutDepth = observe(room_, 1);
  withoutDepth->hasRangeImage = false;
  EXPECT_THROW(slam.process(withoutDepth), core::FrameError);
  const auto ofAnotherSize = observe(room_, 2);
  ofAnotherSize->rangeImage_setSize(120, 160);
  EXPECT_THROW(slam.process(ofAnotherSize), core::FrameError);

  const auto result = slam.process(observe(room_, 3));
  EXPECT_EQ(result.state, odometry::State::Ok);
  EXPECT_LT((result.T_map_cam.translation() - test::TexturedRoom::T_room_cam(3).translation()).norm(), 0.005);
  EXPECT_THAT(test::RecordingFilter::log(), ElementsAre("initialize", "begin 0", "apply 0", "observer 0 ok",  //
                                                        "begin 1", "apply 1", "observer 1 ok"));
}

/// Memory is used up while an image is worked on.
class ExhaustedObserver : public FrameObserver {
 public:
  void onFrame(const core::Frame& frame, const odometry::OdometryResult& /*odometry*/) override {
    if (frame.index == 4) throw std::bad_alloc();
  }
};

TEST_F(SlamSystemTest, AfterAnExceptionThereIsAllThatWasFoundUntilThen) {
  for (const bool deterministic : {true, false}) {
    SlamOptions options = withoutFilters();
    options.deterministic = deterministic;
    SlamSystem slam(options);
    ExhaustedObserver observer;
    slam.addObserver(observer);
    for (int image = 0; image < 4; ++image) slam.process(observe(room_, image));
    EXPECT_THROW(slam.process(observe(room_, 4)), std::bad_alloc);
    slam.finish();
    EXPECT_EQ(slam.trajectory().size(), 5U);
    EXPECT_FALSE(slam.semanticMap().keyframes.empty());
  }
}

TEST_F(SlamSystemTest, AfterAnExceptionInAThreadToo) {
  const test::TemporaryFolder folder;
  SlamSystem slam(withoutFilters());
  storage::MapFileWriter writer(folder.path() / "map.wardmap", {});
  writer.setWarningSink([](const std::string&) { throw std::bad_alloc(); });
  slam.writeTo(writer);
  const test::FullDisk full;
  int done = 0;
  const auto processAll = [&] {
    for (; done < 10; ++done) slam.process(observe(room_, done));
    slam.finish();
  };
  EXPECT_THROW(processAll(), std::bad_alloc);
  try {
    slam.finish();
  } catch (const std::bad_alloc&) {  // where it was process() that threw
  }
  EXPECT_GE(slam.trajectory().size(), static_cast<std::size_t>(done));
  EXPECT_NE(slam.mapBuilder(), nullptr);
  EXPECT_FALSE(slam.semanticMap().keyframes.empty());
  EXPECT_FALSE(slam.mapper().graph().keyframes().empty());
}

TEST_F(SlamSystemTest, AnImageOfAnotherSizeIsLeftOutAndItGoesOn) {
  SlamSystem slam(withoutFilters());
  slam.process(observe(room_, 0));
  const auto smaller = observe(room_, 1);
  cv::Mat image;
  cv::resize(smaller->intensityImage.asCvMatRef(), image, {160, 120});
  smaller->intensityImage = mrpt::img::CImage(image, mrpt::img::DEEP_COPY);
  smaller->rangeImage_setSize(120, 160);
  smaller->rangeImage.fill(5000);
  for (auto* camera : {&smaller->cameraParams, &smaller->cameraParamsIntensity}) {
    camera->ncols = 160;
    camera->nrows = 120;
  }
  EXPECT_THAT([&] { slam.process(smaller); }, ThrowsMessage<core::FrameError>(HasSubstr("160x120")));
  EXPECT_EQ(slam.process(observe(room_, 2)).state, odometry::State::Ok);
  slam.finish();
  EXPECT_EQ(slam.trajectory().size(), 2U);
}

TEST_F(SlamSystemTest, TimesItsStages) {
  SlamSystem slam(withoutFilters());
  for (int image = 0; image < 3; ++image) slam.process(observe(room_, image));
  const auto statistics = slam.profiler().statistics();
  double parts_ms = 0;
  for (const char* stage : {"sources.build_frame", "features.extract", "filters.apply", "odometry.track"}) {
    ASSERT_EQ(statistics.count(stage), 1U) << stage;
    EXPECT_EQ(statistics.at(stage).calls, 3U) << stage;
    parts_ms += statistics.at(stage).total_ms;
  }
  EXPECT_LE(parts_ms, statistics.at("pipeline.process").total_ms);
}

TEST_F(SlamSystemTest, RecordedMasksBringTheirLabelsAndAreRequiredToMatch) {
  const test::TemporaryFolder folder;
  folder.write("classes.txt", "100 trolley\n");
  std::filesystem::create_directory(folder.path() / "masks");
  folder.write("masks/5.000000.png", "of another recording");
  SlamOptions options;
  options.segmentation.type = segmentation::SegmentationOptions::Type::RecordedMasks;
  options.segmentation.recorded_masks.folder = (folder.path() / "masks").string();
  SlamSystem slam(options);
  EXPECT_EQ(slam.labelSpace().name(100), "trolley");
  slam.process(observe(room_, 0));
  EXPECT_THROW(slam.requireSoundSetup(), core::InputError);
}

TEST_F(SlamSystemTest, TheConfigurationMakesTheSameSystem) {
  const test::TemporaryFolder folder;
  auto options = withRecordingFilter();
  options.features.key_points = 700;
  const SlamSystem slam(options);
  EXPECT_THAT(slam.configuration(), HasSubstr("key_points: 700 "));
  EXPECT_THAT(slam.configuration(), HasSubstr("- class_name: wardslam::test::RecordingFilter"));
  const SlamSystem again(readSlamOptions(folder.write("my.yaml", slam.configuration())));
  EXPECT_EQ(again.configuration(), slam.configuration());
}

TEST_F(SlamSystemTest, RefusesFilesThatAreMissing) {
  auto options = withoutFilters();
  options.knowledge.file = "no_such_knowledge.yaml";
  EXPECT_THROW(SlamSystem{options}, core::InputError);
  options = withoutFilters();
  options.segmentation.type = segmentation::SegmentationOptions::Type::Yolo;
  options.segmentation.yolo.model = "no_such_network.onnx";
  EXPECT_THROW(SlamSystem{options}, core::InputError);
}

TEST_F(SlamSystemTest, TheDefaultFilterWantsMasks) {
  SlamOptions options;
  options.segmentation.type = segmentation::SegmentationOptions::Type::None;
  EXPECT_THAT(test::complaintOf([&] { return SlamSystem{options}; }), HasSubstr("masks"));
}

TEST_F(SlamSystemTest, SegmentsByTheNetworkThatComesWithTheProgram) {
  const SlamSystem slam{SlamOptions{}};
  EXPECT_EQ(slam.labelSpace().name(104), "bedside_cabinet");
}

}  // namespace
}  // namespace wardslam::pipeline
