#include "wardslam/masks/contour_refiner.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "masks/textured_scene.h"

namespace wardslam::masks {
namespace {

using scene::iou;
using scene::kChair;
using scene::kPerson;

const cv::Size kSize(640, 480);
const cv::Scalar kWall_bgr(190, 190, 190);
const cv::Scalar kCloth_bgr(120, 60, 30);
const cv::Rect kBody(260, 120, 90, 240);
const cv::Rect kArm(350, 160, 70, 26);  // stretched out to the right

/// Someone with one arm stretched out, 2 m away, before a grey wall at 4 m.
struct Room {
  cv::Mat color_bgr = cv::Mat(kSize, CV_8UC3, kWall_bgr);
  cv::Mat depth_m = cv::Mat(kSize, CV_32FC1, cv::Scalar(4.0));
  cv::Mat person = cv::Mat(kSize, CV_8UC1, cv::Scalar(0));

  Room() {
    put(kBody);
    put(kArm);
  }
  void put(const cv::Rect& box) {
    color_bgr(box).setTo(kCloth_bgr);
    depth_m(box).setTo(2.0);
    person(box).setTo(255);
  }
  void wallAt(const cv::Rect& box) {
    color_bgr(box).setTo(kWall_bgr);
    depth_m(box).setTo(4.0);
    person(box).setTo(0);
  }
};

void add(core::Segmentation& segmentation, const cv::Mat& mask, std::uint16_t id, core::ClassId classId) {
  if (segmentation.empty()) segmentation = {cv::Mat::zeros(kSize, CV_8UC1), cv::Mat::zeros(kSize, CV_16UC1), {}};
  segmentation.classIds.setTo(classId, mask);
  segmentation.instanceIds.setTo(id, mask);
  segmentation.instances.push_back({id, classId, 0.7F, cv::boundingRect(mask)});
}

core::Segmentation found(const cv::Mat& mask, std::uint16_t id = 5, core::ClassId classId = kPerson) {
  core::Segmentation segmentation;
  add(segmentation, mask, id, classId);
  return segmentation;
}

core::Segmentation refine(const Room& room, const core::Segmentation& found, const core::DepthNoise& noise = {}) {
  const ContourRefiner refiner({}, ContourRefiner::ClassSet().set(kPerson));
  return refiner.refine(room.color_bgr, room.depth_m, noise, found);
}

cv::Mat personOf(const core::Segmentation& segmentation) { return segmentation.classIds == kPerson; }

cv::Mat widened(const cv::Mat& mask, int px) {
  cv::Mat result;
  cv::dilate(mask, result, cv::getStructuringElement(cv::MORPH_RECT, {2 * px + 1, 2 * px + 1}));
  return result;
}

cv::Mat boxed(const cv::Rect& box) {
  cv::Mat mask(kSize, CV_8UC1, cv::Scalar(0));
  mask(box).setTo(255);
  return mask;
}

TEST(ContourRefiner, TakesBackWhatBleedsOntoTheWall) {
  const Room room;
  const cv::Mat bleeding = widened(room.person, 10);
  ASSERT_LT(iou(bleeding, room.person), 0.8);
  EXPECT_GT(iou(personOf(refine(room, found(bleeding))), room.person), 0.99);
}

TEST(ContourRefiner, GrowsToTheEdge) {
  const Room room;
  const cv::Mat handless = room.person & ~boxed({408, 150, 50, 50});
  EXPECT_GT(iou(personOf(refine(room, found(handless))), room.person), 0.99);
}

TEST(ContourRefiner, DoesNotGrowOntoWhatGoesOnBeyondItsReach) {
  const Room room;
  const cv::Mat armless = boxed(kBody);
  EXPECT_EQ(cv::boundingRect(personOf(refine(room, found(armless)))), kBody) << "it might be a table";
}

TEST(ContourRefiner, LeavesAlmostAloneWhatIsRight) {
  const Room room;
  EXPECT_GT(iou(personOf(refine(room, found(room.person))), room.person), 0.99);
}

TEST(ContourRefiner, OpensTheGapThroughWhichTheWallIsSeen) {
  Room room;
  const cv::Mat filled = room.person.clone();
  room.wallAt({290, 260, 30, 100});  // between the legs
  EXPECT_GT(iou(personOf(refine(room, found(filled))), room.person), 0.99);
}

TEST(ContourRefiner, DoesNotRunOutOverTheFloor) {
  Room room;
  // A level floor with its horizon in row 60; in row 359, where the feet are, it is as far away as they.
  for (int y = 160; y < kSize.height; ++y) {
    const cv::Mat row = ~room.person.row(y);
    room.depth_m.row(y).setTo(2.0 * (359 - 60) / (y - 60), row);
    room.color_bgr.row(y).setTo(cv::Scalar(60, 90, 110), row);
  }
  EXPECT_GT(iou(personOf(refine(room, found(room.person))), room.person), 0.98);
  EXPECT_GT(iou(personOf(refine(room, found(widened(room.person, 8)))), room.person), 0.97);
}

TEST(ContourRefiner, CutsOffTheShadowBesideTheSilhouette) {
  Room room;
  room.depth_m(cv::Rect(kBody.x - 12, kBody.y, 12, kBody.height)).setTo(0.0);
  EXPECT_GT(iou(personOf(refine(room, found(widened(room.person, 10)))), room.person), 0.98);
}

TEST(ContourRefiner, TakesTheNoiseOfAPairOfCamerasForNoEdges) {
  Room room;
  cv::Mat noise_m(kSize, CV_32FC1);
  cv::RNG(5).fill(noise_m, cv::RNG::NORMAL, 0.0, 0.03);  // times z², without more
  room.depth_m += noise_m.mul(room.depth_m).mul(room.depth_m);
  const cv::Mat footless = room.person & ~boxed({250, 348, 110, 12});
  EXPECT_GT(iou(personOf(refine(room, found(footless), {0.0, 0.03, 0.0})), room.person), 0.99);
}

TEST(ContourRefiner, KeepsTheMiddleThatWasNotMeasured) {
  Room room;
  room.depth_m(cv::Rect(280, 140, 50, 60)).setTo(0.0);  // black cloth
  EXPECT_GT(iou(personOf(refine(room, found(widened(room.person, 8)))), room.person), 0.99);
}

TEST(ContourRefiner, KeepsOtherInstancesAsTheyAre) {
  const Room room;
  core::Segmentation both = found(boxed(kBody) & ~boxed({340, 120, 10, 240}), 5);
  add(both, boxed(kArm), 6, kChair);
  const core::Segmentation refined = refine(room, both);
  EXPECT_EQ(cv::countNonZero((refined.instanceIds == 6) != boxed(kArm)), 0);
  EXPECT_EQ(cv::countNonZero((refined.classIds == kChair) != boxed(kArm)), 0);
  EXPECT_GT(iou(personOf(refined), boxed(kBody)), 0.97) << "grows beside it";
}

TEST(ContourRefiner, KeepsIdsClassesAndConfidencesAndFitsTheBoxes) {
  const Room room;
  const core::Segmentation refined = refine(room, found(widened(room.person, 10)));
  ASSERT_EQ(refined.instances.size(), 1U);
  EXPECT_EQ(refined.instances[0].id, 5);
  EXPECT_EQ(refined.instances[0].classId, kPerson);
  EXPECT_EQ(refined.instances[0].confidence, 0.7F);
  EXPECT_EQ(refined.instances[0].box_px, cv::boundingRect(refined.instanceIds == 5));
  EXPECT_EQ(cv::countNonZero((refined.instanceIds == 5) != personOf(refined)), 0);
}

TEST(ContourRefiner, DoesNotWriteIntoTheMasksItGot) {
  const Room room;
  const cv::Mat bleeding = widened(room.person, 10);
  const core::Segmentation before = found(bleeding);
  (void)refine(room, before);
  EXPECT_EQ(cv::countNonZero(personOf(before) != bleeding), 0);
}

TEST(ContourRefiner, LeavesAloneWhatDepthSaysLittleOf) {
  Room room;
  room.depth_m(cv::Rect(250, 100, 200, 190)).setTo(0.0);  // most of the person
  const cv::Mat bleeding = widened(room.person, 10);
  EXPECT_EQ(cv::countNonZero(personOf(refine(room, found(bleeding))) != bleeding), 0);
}

TEST(ContourRefiner, LeavesAloneWhatWouldLoseMostOfItself) {
  const Room room;
  const cv::Mat onTheWall = boxed({40, 40, 120, 120}) | boxed({300, 200, 10, 10});
  EXPECT_EQ(cv::countNonZero(personOf(refine(room, found(onTheWall))) != onTheWall), 0);
}

TEST(ContourRefiner, LeavesOtherClassesAlone) {
  const Room room;
  const cv::Mat bleeding = widened(room.person, 10);
  const core::Segmentation refined = refine(room, found(bleeding, 5, kChair));
  EXPECT_EQ(cv::countNonZero((refined.classIds == kChair) != bleeding), 0);
}

TEST(ContourRefiner, GivesBackWhatItCannotRefine) {
  Room room;
  EXPECT_TRUE(refine(room, {}).empty());
  const cv::Mat bleeding = widened(room.person, 10);
  room.depth_m = cv::Mat();
  EXPECT_EQ(cv::countNonZero(personOf(refine(room, found(bleeding))) != bleeding), 0);
  room.depth_m = cv::Mat(240, 320, CV_32FC1, cv::Scalar(2.0));
  EXPECT_EQ(cv::countNonZero(personOf(refine(room, found(bleeding))) != bleeding), 0);
}

TEST(ContourRefiner, TakesImagesOfAnySize) {
  const Room room;
  const core::Segmentation bleeding = found(widened(room.person, 10));
  const cv::Rect part(0, 0, 501, 387);  // no multiples of anything
  const ContourRefiner refiner({}, ContourRefiner::ClassSet().set(kPerson));
  const core::Segmentation refined =
      refiner.refine(room.color_bgr(part), room.depth_m(part), {},
                     {bleeding.classIds(part), bleeding.instanceIds(part), bleeding.instances});
  EXPECT_GT(iou(personOf(refined), room.person(part)), 0.98);
}

}  // namespace
}  // namespace wardslam::masks
