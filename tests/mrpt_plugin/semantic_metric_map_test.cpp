#include "wardslam/mrpt_plugin/semantic_metric_map.h"

#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfObjects.h>

#include <filesystem>

#include "annotated_room.h"
#include "semantic_map_encoding.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/annotation.h"
#include "wardslam/core/errors.h"
#include "wardslam/mrpt_plugin/register_all.h"

namespace wardslam::mrpt_plugin {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::ThrowsMessage;

constexpr auto kPerson_px = [] { return cv::Rect(2, 2, 60, 236); };  // well within the person

mrpt::maps::TSetOfMetricMapInitializers definitions(const std::string& ini) {
  registerAll();
  mrpt::config::CConfigFileMemory file;
  file.setContent(ini);
  mrpt::maps::TSetOfMetricMapInitializers definitions;
  definitions.loadFromConfigFile(file, "map");
  return definitions;
}

class SemanticMetricMap : public ::testing::Test {
 protected:
  AnnotatedRoom room;
  CSemanticMap map;
};

TEST_F(SemanticMetricMap, IsMadeByAnIniFileBesideMrptsOwn) {
  const mrpt::maps::CMultiMetricMap maps(
      definitions("[map]\nCSemanticMap_count = 1\npointsMap_count = 1\n"
                  "[map_CSemanticMap_00_creationOpts]\nenableSaveAs3DObject = false\n"
                  "[map_CSemanticMap_00_insertOpts]\ncloud.voxel_m = 0.05\n"
                  "[map_CSemanticMap_00_renderOpts]\ncolor = class\n"));
  EXPECT_THAT(maps.maps, SizeIs(2));
  const auto made = maps.mapByClass<CSemanticMap>();
  ASSERT_TRUE(made);
  EXPECT_EQ(made->insertionOptions.cloud.voxel_m, 0.05);
  EXPECT_EQ(made->renderOptions.color, exchange::CloudColor::Class);
  EXPECT_FALSE(made->genericMapParams.enableSaveAs3DObject);
  EXPECT_TRUE(made->isEmpty());
}

TEST_F(SemanticMetricMap, AWrongKeyIsNamedWithTheNearest) {
  const auto expect = [](const std::string& ini, const std::string& wrong, const std::string& nearest) {
    EXPECT_THAT([&ini] { static_cast<void>(definitions("[map]\nCSemanticMap_count = 1\n" + ini)); },
                ThrowsMessage<std::exception>(AllOf(HasSubstr(wrong), HasSubstr("'" + nearest + "'"))));
  };
  expect("[map_CSemanticMap_00_insertOpts]\ncloud.voxel = 0.05\n", "voxel'", "voxel_m");
  expect("[map_CSemanticMap_00_likelihoodOpts]\nsigma = 0.05\n", "sigma'", "sigma_m");
  expect("[map_CSemanticMap_00_creationOpts]\nenableObservationInsert = 1\n", "enableObservationInsert'",
         "enableObservationInsertion");
  expect("[map_CSemanticMap_00_insertOptions]\ncloud.voxel_m = 0.05\n", "insertOptions", "_insertOpts");
}

TEST_F(SemanticMetricMap, PeopleNeverEnterAndThingsAreFound) {
  room.insertInto(map);
  EXPECT_FALSE(map.isEmpty());
  EXPECT_EQ(AnnotatedRoom::pointsIn(map.map(), kPerson_px()), 0);
  EXPECT_GT(AnnotatedRoom::pointsIn(map.map(), {100, 20, 60, 200}), 100);
  ASSERT_THAT(map.objects(), SizeIs(1));
  const auto& chair = map.objects().begin()->second;
  EXPECT_EQ(chair.classId, AnnotatedRoom::kChair);
  EXPECT_EQ(map.map().labels.name(chair.classId), "chair");
  const auto nearest = map.nearest({0.0, 0.0, 0.0});
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->object->id, chair.id);
  EXPECT_THAT(map.asString(), HasSubstr("1 things"));
}

TEST_F(SemanticMetricMap, HearsOfAnImageBeforeOrAfterIt) {
  room.insertInto(map);
  CSemanticMap other;
  for (int image = 0; image < 3; ++image) {
    EXPECT_FALSE(other.insertObservation(AnnotatedRoom::semantic(image), AnnotatedRoom::robotPose()));
    EXPECT_TRUE(other.insertObservation(*room.scan(image), AnnotatedRoom::robotPose()));
  }
  EXPECT_EQ(encode(other.map()), encode(map.map()));
}

TEST_F(SemanticMetricMap, TakesAnnotatedScansAlone) {
  for (int image = 0; image < 3; ++image) {
    const auto scan = room.scan(image);
    core::annotate(*scan, AnnotatedRoom::semantic(image).labelBits);
    EXPECT_TRUE(map.insertObservation(*scan, AnnotatedRoom::robotPose()));
  }
  EXPECT_EQ(AnnotatedRoom::pointsIn(map.map(), kPerson_px()), 0);
  EXPECT_GT(AnnotatedRoom::pointsIn(map.map(), {100, 20, 60, 200}), 100);
  EXPECT_TRUE(map.objects().empty());
}

TEST_F(SemanticMetricMap, SaysOnceThatAllOfAScanWithoutAnnotationsIsInserted) {
  std::vector<std::string> said;
  map.logging_enable_console_output = false;
  map.logRegisterCallback([&said](std::string_view text, auto&&...) { said.emplace_back(text); });
  for (int image = 0; image < 4; ++image) map.insertObservation(*room.scan(image), AnnotatedRoom::robotPose());
  EXPECT_GT(AnnotatedRoom::pointsIn(map.map(), kPerson_px()), 100);
  ASSERT_THAT(said, SizeIs(1));
  EXPECT_THAT(said[0], HasSubstr("without annotations"));
}

TEST_F(SemanticMetricMap, WhatIsSeenToHaveGoneLeaves) {
  const cv::Rect box_px(130, 100, 40, 40);
  const auto insert = [&](int image, bool withBox) {
    const auto scan = room.scan(image);
    if (withBox) {
      cv::Mat range(240, 320, CV_16UC1, scan->rangeImage.data());
      range(box_px).setTo(5000);  // 1 m
    }
    map.insertObservation(*scan, AnnotatedRoom::robotPose());
  };
  map.logging_enable_console_output = false;
  const auto nearPoints = [this] {
    int count = 0;
    for (const auto& [id, tile] : map.map().cloud) {
      for (const auto& point : tile.points) count += point.p_cam_m.z() < 1.1F ? 1 : 0;
    }
    return count;
  };
  for (int image = 0; image < 4; ++image) insert(image, true);
  EXPECT_GT(nearPoints(), 10);
  for (int image = 4; image < 24; ++image) insert(image, false);
  EXPECT_EQ(nearPoints(), 0);
}

TEST_F(SemanticMetricMap, LeavesOutWhatIsNoScanOrCannotBeUsed) {
  map.logging_enable_console_output = false;
  EXPECT_FALSE(map.insertObservation(mrpt::obs::CObservationOdometry(), AnnotatedRoom::robotPose()));
  auto scan = room.scan(0);
  scan->hasIntensityImage = false;
  EXPECT_FALSE(map.insertObservation(*scan, AnnotatedRoom::robotPose()));
  EXPECT_TRUE(map.isEmpty());
  CObservationSemanticRGBD small = AnnotatedRoom::semantic(1);
  small.segmentation.classIds = small.segmentation.classIds.rowRange(0, 10).clone();
  EXPECT_TRUE(map.insertObservation(*room.scan(1), AnnotatedRoom::robotPose()));
  EXPECT_FALSE(map.insertObservation(small, AnnotatedRoom::robotPose()));
  EXPECT_TRUE(map.objects().empty());
}

TEST_F(SemanticMetricMap, IsCopiedWithAllItKnows) {
  room.insertInto(map, 1);  // seen once: known, and not shown yet
  const auto copy = std::dynamic_pointer_cast<CSemanticMap>(map.duplicateGetSmartPtr());
  CSemanticMap assigned;
  assigned = map;
  room.insertInto(map, 4);
  room.insertInto(*copy, 4);
  room.insertInto(assigned, 4);
  EXPECT_GT(map.points().size(), 100U);
  EXPECT_EQ(encode(copy->map()), encode(map.map()));
  EXPECT_EQ(encode(assigned.map()), encode(map.map()));
  copy->clear();
  EXPECT_TRUE(copy->isEmpty());
  EXPECT_EQ(copy->points().size(), 0U);
  EXPECT_FALSE(map.isEmpty());
}

TEST_F(SemanticMetricMap, GoesOnInAMapThatIsThere) {
  room.insertInto(map);
  CSemanticMap other(map.map());
  room.insertInto(other);
  EXPECT_THAT(other.objects(), SizeIs(1));
  EXPECT_EQ(other.map().keyframes.size(), 2 * map.map().keyframes.size());
}

TEST_F(SemanticMetricMap, InsertsOnlyWhatShowsSomethingNewWhereAskedTo) {
  map.insertionOptions.views = {0.1, 0.06, 1.5};
  room.insertInto(map, 4);  // a second apart
  EXPECT_THAT(map.map().keyframes, SizeIs(2));
  const auto copy = std::dynamic_pointer_cast<CSemanticMap>(map.duplicateGetSmartPtr());
  copy->insertObservation(*room.scan(3), AnnotatedRoom::robotPose());
  EXPECT_THAT(copy->map().keyframes, SizeIs(2)) << "a copy knows what its original was shown last";
}

TEST_F(SemanticMetricMap, LearnsNamesWhenTheyCome) {
  map.insertObservation(*room.scan(0), AnnotatedRoom::robotPose());  // no names with it
  for (int image = 1; image < 4; ++image) {
    auto semantic = AnnotatedRoom::semantic(image);
    for (auto& [id, name] : semantic.classes) name = name == "chair" ? "recliner" : name;
    map.insertObservation(*room.scan(image), AnnotatedRoom::robotPose());
    map.insertObservation(semantic, AnnotatedRoom::robotPose());
  }
  ASSERT_THAT(map.objects(), SizeIs(1));
  EXPECT_EQ(map.map().labels.name(map.objects().begin()->second.classId), "recliner");
  EXPECT_THAT(map.map().keyframes, SizeIs(4)) << "and forgets nothing";
}

TEST_F(SemanticMetricMap, IsMatchedAsPointsAre) {
  room.insertInto(map);
  mrpt::tfest::TMatchingPairList pairs;
  mrpt::maps::TMatchingExtraResults extra;
  mrpt::maps::TMatchingParams parameters;
  parameters.maxDistForCorrespondence = 0.01F;
  CSemanticMap other = map;
  map.determineMatching3D(&other, {}, pairs, parameters, extra);
  EXPECT_EQ(pairs.size(), map.points().size());
  EXPECT_FLOAT_EQ(map.compute3DMatchingRatio(&other.points(), {}, {}), 1.0F);
  EXPECT_FLOAT_EQ(map.compute3DMatchingRatio(&other, {5, 5, 5, 0, 0, 0}, {}), 0.0F);
  EXPECT_EQ(map.getAsSimplePointsMap()->size(), map.points().size());
  EXPECT_GT(map.boundingBox().max.x, map.boundingBox().min.x);
}

TEST_F(SemanticMetricMap, AScanIsMostLikelyWhereItWasTaken) {
  room.insertInto(map);
  const auto pose = AnnotatedRoom::robotPose();
  auto semantic = AnnotatedRoom::semantic(0);
  for (int row = 10; row < 240; row += 20) {
    for (int col = 85; col < 320; col += 20) {
      const auto depth_m = room.room.look(test::TexturedRoom::T_room_cam(0)).depth_m.at<float>(row, col);
      core::Keypoint& keypoint = semantic.features.keypoints.emplace_back();
      keypoint.raw_px = keypoint.undistorted_px = {static_cast<float>(col), static_cast<float>(row)};
      keypoint.depth_m = depth_m;
      semantic.states.push_back(KeypointState::Static);
    }
  }
  const auto scan = room.scan(0);
  core::annotate(*scan, semantic.labelBits);
  EXPECT_TRUE(map.canComputeObservationLikelihood(*scan));
  EXPECT_TRUE(map.canComputeObservationLikelihood(semantic));
  const auto likelihoodOf = [&](const mrpt::obs::CObservation& observation, const mrpt::poses::CPose3D& offset) {
    return map.computeObservationLikelihood(observation, pose + offset);
  };
  for (const auto& offset : {mrpt::poses::CPose3D(0.3, 0, 0, 0, 0, 0), mrpt::poses::CPose3D(0, -0.3, 0, 0, 0, 0),
                             mrpt::poses::CPose3D(0, 0, 0, 0.2, 0, 0)}) {
    EXPECT_GT(likelihoodOf(*scan, {}), likelihoodOf(*scan, offset) + 1.0);
    EXPECT_GT(likelihoodOf(semantic, {}), likelihoodOf(semantic, offset) + 1.0);
  }
  EXPECT_FALSE(map.canComputeObservationLikelihood(mrpt::obs::CObservationOdometry()));
}

TEST_F(SemanticMetricMap, AnotherClassIsLessLikely) {
  room.insertInto(map);
  auto semantic = AnnotatedRoom::semantic(0);
  core::Keypoint& keypoint = semantic.features.keypoints.emplace_back();
  keypoint.raw_px = keypoint.undistorted_px = {240.0F, 120.0F};
  keypoint.depth_m = room.room.look(test::TexturedRoom::T_room_cam(0)).depth_m.at<float>(120, 240);
  semantic.states.push_back(KeypointState::Static);
  const double same = map.computeObservationLikelihood(semantic, AnnotatedRoom::robotPose());
  auto other = semantic;
  other.timestamp += std::chrono::seconds(1);
  other.segmentation.classIds = semantic.segmentation.classIds.clone();
  other.segmentation.classIds.setTo(60);
  const double different = map.computeObservationLikelihood(other, AnnotatedRoom::robotPose());
  const auto& options = map.likelihoodOptions;
  // The point lies at the very place: exp(-d² / 2 sigma²) is the same in both and nearly 1.
  EXPECT_NEAR(same, 0.0, 0.1);
  EXPECT_NEAR(different, std::log((1 - options.other) * options.class_mismatch + options.other), 0.1);
}

TEST_F(SemanticMetricMap, IsDrawnByColourOrClassWithBoxesAndNames) {
  const CSemanticMap ward(test::makeWard());
  const auto all = ward.getVisualization();
  EXPECT_EQ(std::distance(all->begin(), all->end()), 1 + 2 * 6);  // cloud; boxes and names of six that stand there
  CSemanticMap byClass = ward;
  byClass.renderOptions.color = exchange::CloudColor::Class;
  byClass.renderOptions.boxes = byClass.renderOptions.names = false;
  const auto bare = byClass.getVisualization();
  ASSERT_EQ(std::distance(bare->begin(), bare->end()), 1);
  const auto cloud = std::dynamic_pointer_cast<mrpt::opengl::CPointCloudColoured>(*bare->begin());
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->getPointColor(1).G, 128);  // no class
  EXPECT_EQ(cloud->getPointColor(0).R, 192);  // class 57, as the challenge's palette has it
  EXPECT_EQ(cloud->getPointColor(0).B, 64);
  byClass.genericMapParams.enableSaveAs3DObject = false;
  EXPECT_TRUE(byClass.getVisualization()->empty());
}

TEST_F(SemanticMetricMap, IsSavedForOtherPrograms) {
  const test::TemporaryFolder folder;
  const std::string prefix = (folder.path() / "ward").string();
  CSemanticMap(test::makeWard()).saveMetricMapRepresentationToFile(prefix);
  for (const char* ending : {".ply", "_objects.csv", ".3Dscene"}) EXPECT_TRUE(std::filesystem::exists(prefix + ending));
}

}  // namespace
}  // namespace wardslam::mrpt_plugin
