#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CText.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <sstream>

#include "hand_made_observation.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/mrpt_plugin/register_all.h"

namespace wardslam::mrpt_plugin {
namespace {

using ::testing::HasSubstr;

std::vector<std::uint8_t> written(const CObservationSemanticRGBD& observation) {
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << observation;
  const auto* first = static_cast<const std::uint8_t*>(stream.getRawBufferData());
  return {first, first + stream.getTotalBytesCount()};
}

CObservationSemanticRGBD::Ptr readBack(std::vector<std::uint8_t> bytes) {
  registerAll();
  mrpt::io::CMemoryStream stream;
  stream.assignMemoryNotOwn(bytes.data(), bytes.size());
  auto archive = mrpt::serialization::archiveFrom(stream);
  return archive.ReadObject<CObservationSemanticRGBD>();
}

std::string complaintAbout(const std::vector<std::uint8_t>& bytes) {
  try {
    static_cast<void>(readBack(bytes));
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

bool isSame(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && (a.empty() || cv::countNonZero(a != b) == 0);
}

void expectEqual(const core::Keypoint& a, const core::Keypoint& b) {
  EXPECT_EQ(a.raw_px, b.raw_px);
  EXPECT_EQ(a.undistorted_px, b.undistorted_px);
  EXPECT_EQ(a.depth_m, b.depth_m);
  EXPECT_EQ(a.angle_rad, b.angle_rad);
  EXPECT_EQ(a.response, b.response);
  EXPECT_EQ(a.scale, b.scale);
  EXPECT_EQ(a.motion, b.motion);
  EXPECT_EQ(a.staticProbability, b.staticProbability);
}

TEST(ObservationSemanticRgbd, ComesBackAsItWasWritten) {
  const auto o = handMadeObservation();
  const auto back = readBack(written(o));
  EXPECT_EQ(back->sensorLabel, o.sensorLabel);
  EXPECT_EQ(back->timestamp, o.timestamp);
  EXPECT_TRUE(core::fromMrpt(back->cameraPose).isApprox(core::fromMrpt(o.cameraPose), 1e-15));
  EXPECT_TRUE(back->camera == o.camera);
  EXPECT_TRUE(isSame(back->segmentation.classIds, o.segmentation.classIds));
  EXPECT_TRUE(isSame(back->segmentation.instanceIds, o.segmentation.instanceIds));
  EXPECT_TRUE(isSame(back->labelBits, o.labelBits));
  EXPECT_EQ(back->classes, o.classes);
  EXPECT_EQ(back->states, o.states);
  EXPECT_EQ(back->descriptorSide, o.descriptorSide);
  EXPECT_TRUE(isSame(back->features.descriptors, o.features.descriptors));
  ASSERT_EQ(back->features.size(), o.features.size());
  for (std::size_t i = 0; i < o.features.size(); ++i) {
    expectEqual(back->features.keypoints[i], o.features.keypoints[i]);
  }
  ASSERT_EQ(back->segmentation.instances.size(), 2U);
  EXPECT_EQ(back->segmentation.instances[1].id, 9);
  EXPECT_EQ(back->segmentation.instances[1].classId, 57);
  EXPECT_EQ(back->segmentation.instances[1].confidence, 0.5F);
  EXPECT_EQ(back->segmentation.instances[1].box_px, cv::Rect(40, 0, 24, 48));
}

TEST(ObservationSemanticRgbd, ComesBackWithoutSegmentationOrKeyPoints) {
  CObservationSemanticRGBD o;
  o.sensorLabel = "EMPTY";
  const auto back = readBack(written(o));
  EXPECT_EQ(back->sensorLabel, "EMPTY");
  EXPECT_TRUE(back->segmentation.empty());
  EXPECT_EQ(back->features.size(), 0U);
  EXPECT_TRUE(back->semanticDescriptors().empty());
}

TEST(ObservationSemanticRgbd, SemanticDescriptorsAreWindowsOfTheClassImage) {
  auto o = handMadeObservation();
  for (auto& keypoint : o.features.keypoints) keypoint.angle_rad = 0.0F;
  o.features.keypoints[1].raw_px = {40, 20};  // the chair begins here
  const cv::Mat descriptors = o.semanticDescriptors();
  ASSERT_EQ(descriptors.size(), cv::Size(25, 4));
  EXPECT_EQ(cv::countNonZero(descriptors.row(0)), 0);            // wall all around
  EXPECT_EQ(cv::countNonZero(descriptors.row(1) == 57), 5 * 3);  // columns 40, 41, 42 of 38..42
  EXPECT_EQ(cv::countNonZero(descriptors.row(2) == 1), 25);      // person all around
}

TEST(ObservationSemanticRgbd, TextSaysWhatIsThere) {
  std::ostringstream text;
  handMadeObservation().getDescriptionAsText(text);
  EXPECT_THAT(text.str(), HasSubstr("Key points: 4, of which static 2, on movable things 1, dynamic 1"));
  EXPECT_THAT(text.str(), HasSubstr("thing 3: person, confidence 0.75, 960 pixels"));
  EXPECT_THAT(text.str(), HasSubstr("RGBD_SEM"));
}

TEST(ObservationSemanticRgbd, ShowsDynamicPointsInRedWhereTheyAre) {
  auto o = handMadeObservation();
  o.cameraPose = mrpt::poses::CPose3D(0, 0, 1.0, 0, 0, 0);  // looks along x of the robot, one metre up
  const auto view = o.getVisualization();
  const auto points = view->getByClass<mrpt::opengl::CPointCloudColoured>();
  ASSERT_TRUE(points);
  ASSERT_EQ(points->size(), 3U);  // the fourth has no depth
  const auto color = points->getPointColor(2);
  EXPECT_GT(color.R, 200);
  EXPECT_LT(color.G + color.B, 100);
  EXPECT_GT(points->getPointColor(0).G, points->getPointColor(0).R);
  // Undistorted pixel (10.25, 39.75) at 1 m: right of the axis is negative y, below it is less height.
  const auto& p = points->getPoint3Df(2);
  EXPECT_NEAR(p.x, 1.0, 1e-5);
  EXPECT_NEAR(p.y, -(10.25 - 31.5) / 50.0, 1e-5);
  EXPECT_NEAR(p.z, 1.0 - (39.75 - 23.5) / 51.0, 1e-5);
}

TEST(ObservationSemanticRgbd, ShowsNamesOfThingsWithManyKeyPoints) {
  auto o = handMadeObservation();
  EXPECT_FALSE(o.getVisualization()->getByClass<mrpt::opengl::CText>());
  while (o.features.size() < 20) {
    o.features.keypoints.push_back(o.features.keypoints[2]);  // on the person, 1 m away
    o.states.push_back(o.states[2]);
  }
  o.cameraPose = mrpt::poses::CPose3D();
  const auto view = o.getVisualization();
  const auto name = view->getByClass<mrpt::opengl::CText>();
  ASSERT_TRUE(name);
  EXPECT_EQ(name->getString(), "person");
  EXPECT_NEAR(name->getPose().x, 1.0, 1e-5);
  EXPECT_FALSE(view->getByClass<mrpt::opengl::CText>(1));  // the chair has one
}

TEST(ObservationSemanticRgbd, RefusesNewerVersionsByName) {
  auto bytes = written(handMadeObservation());
  const std::string name = "wardslam::mrpt_plugin::CObservationSemanticRGBD";
  bytes.at(1 + name.size()) = 7;  // behind the length and the name of the class
  const std::string complaint = complaintAbout(bytes);
  EXPECT_THAT(complaint, HasSubstr("written by a newer WardSLAM, in version 7"));
}

TEST(ObservationSemanticRgbd, CutOffAnywhereIsAnError) {
  const auto bytes = written(handMadeObservation());
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    EXPECT_NE(complaintAbout({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)}), "") << size;
  }
}

TEST(ObservationSemanticRgbd, ADamagedByteOfTheContentNeverPassesUnnoticed) {
  const auto bytes = written(handMadeObservation());
  // Behind name, version, label and stamp; the last byte is MRPT's end mark.
  const std::size_t begin = 2 + 47 + (4 + 8) + 8;
  std::size_t complaints = 0;
  for (std::size_t at = begin; at + 1 < bytes.size(); ++at) {
    auto damaged = bytes;
    damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ 0x40U);
    try {
      EXPECT_EQ(written(*readBack(damaged)), bytes) << at;  // a few bits of zstd's mean nothing
    } catch (const std::exception&) {
      ++complaints;
    }
  }
  EXPECT_GT(complaints, (bytes.size() - begin) * 9 / 10);
}

TEST(ObservationSemanticRgbd, RefusesToWriteWhatContradictsItself) {
  auto o = handMadeObservation();
  o.states.pop_back();
  EXPECT_ANY_THROW(written(o));
  o = handMadeObservation();
  o.labelBits = cv::Mat(10, 10, CV_8UC1);
  EXPECT_ANY_THROW(written(o));
  o = handMadeObservation();
  o.descriptorSide = 4;
  EXPECT_ANY_THROW(written(o));
}

}  // namespace
}  // namespace wardslam::mrpt_plugin
