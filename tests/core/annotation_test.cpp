#include "wardslam/core/annotation.h"

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/serialization/CArchive.h>

#include <opencv2/core.hpp>

namespace wardslam::core {
namespace {

using mrpt::obs::CObservation3DRangeScan;

/// 3 rows × 5 columns; (1, 4) is a moving person, (2, 0) a movable thing at rest.
cv::Mat someLabelBits() {
  cv::Mat bits = cv::Mat::zeros(3, 5, CV_8UC1);
  bits.at<std::uint8_t>(1, 4) = bitOf(PixelLabel::Dynamic) | bitOf(PixelLabel::Person);
  bits.at<std::uint8_t>(2, 0) = bitOf(PixelLabel::Movable);
  return bits;
}

void expectSomeLabels(const CObservation3DRangeScan& observation) {
  ASSERT_TRUE(observation.hasPixelLabels());
  EXPECT_TRUE(observation.pixelLabels->checkLabel(1, 4, 0));
  EXPECT_FALSE(observation.pixelLabels->checkLabel(1, 4, 1));
  EXPECT_TRUE(observation.pixelLabels->checkLabel(1, 4, 2));
  EXPECT_TRUE(observation.pixelLabels->checkLabel(2, 0, 1));
  EXPECT_FALSE(observation.pixelLabels->checkLabel(2, 0, 0));
  EXPECT_FALSE(observation.pixelLabels->checkLabel(0, 0, 0));
  EXPECT_EQ(observation.pixelLabels->getLabelName(0), "dynamic");
  EXPECT_EQ(observation.pixelLabels->getLabelName(1), "movable");
  EXPECT_EQ(observation.pixelLabels->getLabelName(2), "person");
  EXPECT_EQ(observation.pixelLabels->getLabelName(3), "thing");

  ASSERT_TRUE(observation.hasConfidenceImage);
  const cv::Mat& confidence = observation.confidenceImage.asCvMatRef();
  ASSERT_EQ(confidence.size(), cv::Size(5, 3));
  EXPECT_EQ(cv::countNonZero(confidence == 255), 14);
  EXPECT_EQ(confidence.at<std::uint8_t>(1, 4), 0);
}

TEST(Annotation, SetsOneBitPerLabelAndDarkensWhatMoves) {
  CObservation3DRangeScan observation;
  annotate(observation, someLabelBits());
  expectSomeLabels(observation);
}

TEST(Annotation, ReplacesTheEarlierOne) {
  CObservation3DRangeScan observation;
  annotate(observation, cv::Mat(3, 5, CV_8UC1, cv::Scalar(255)));
  annotate(observation, someLabelBits());
  expectSomeLabels(observation);
}

TEST(Annotation, CanBeTakenAway) {
  CObservation3DRangeScan observation;
  annotate(observation, someLabelBits());
  removeAnnotation(observation);
  EXPECT_FALSE(observation.hasPixelLabels());
  EXPECT_FALSE(observation.hasConfidenceImage);
}

TEST(Annotation, OfOthersStays) {
  CObservation3DRangeScan observation;
  const auto labels = std::make_shared<mrpt::obs::TPixelLabelInfo<1>>();
  labels->setLabelName(0, "floor");
  observation.pixelLabels = labels;
  observation.hasConfidenceImage = true;
  removeAnnotation(observation);
  EXPECT_EQ(observation.pixelLabels, labels);
  EXPECT_TRUE(observation.hasConfidenceImage);
}

TEST(Annotation, LeavesTheGivenBitsAlone) {
  CObservation3DRangeScan observation;
  const cv::Mat bits = someLabelBits();
  annotate(observation, bits);
  EXPECT_EQ(cv::countNonZero(bits != someLabelBits()), 0);
}

TEST(Annotation, SurvivesBeingStoredInARawlog) {
  CObservation3DRangeScan observation;
  annotate(observation, someLabelBits());
  mrpt::io::CMemoryStream memory;
  mrpt::serialization::archiveFrom(memory) << observation;
  memory.Seek(0);
  CObservation3DRangeScan back;
  mrpt::serialization::archiveFrom(memory) >> back;
  expectSomeLabels(back);
}

TEST(Annotation, CanBeReadBack) {
  CObservation3DRangeScan observation;
  EXPECT_TRUE(annotationOf(observation).empty());
  annotate(observation, someLabelBits());
  EXPECT_EQ(cv::countNonZero(annotationOf(observation) != someLabelBits()), 0);

  observation.pixelLabels = std::make_shared<mrpt::obs::TPixelLabelInfo<4>>();
  EXPECT_TRUE(annotationOf(observation).empty()) << "labels of somebody else";
}

}  // namespace
}  // namespace wardslam::core
