#include "mask_propagator.h"

#include <gtest/gtest.h>

#include <functional>

#include "masks/textured_scene.h"

namespace wardslam::masks {
namespace {

using namespace scene;

constexpr double kFrame_s = 1.0 / 30;

/// What is seen at a frame.
using Film = std::function<Picture(int frame)>;

struct Carried {
  core::Segmentation masks;
  Picture truth;

  [[nodiscard]] cv::Mat of(std::uint16_t id) const { return masks.instanceIds == id; }
  [[nodiscard]] cv::Mat truthOf(std::uint16_t id) const { return truth.masks.instanceIds == id; }
  [[nodiscard]] double iouOf(std::uint16_t id) const { return iou(of(id), truthOf(id)); }
  [[nodiscard]] const core::Instance* find(std::uint16_t id) const {
    for (const auto& instance : masks.instances) {
      if (instance.id == id) return &instance;
    }
    return nullptr;
  }
};

/// The true masks of frame 0, carried through every frame to the last.
Carried carry(const Film& film, int frames) {
  const Picture first = film(0);
  ImageMotion motion;
  motion.advance(shrink(first.gray, first.depth_m, 0.0));
  Trail trail(motion.picture());
  Picture last = first;
  for (int i = 1; i <= frames; ++i) {
    last = film(i);
    motion.advance(shrink(last.gray, last.depth_m, kFrame_s * i));
    trail.follow(motion.step());
  }
  return {carryMasks(first.masks, trail, motion.picture()), last};
}

TEST(CarryMasks, FollowsAThingThatMoves) {
  const Carried carried = carry(
      [](int i) {
        Picture picture = wall(4.0);
        put(picture, 7, kPerson, {60 + 6 * i, 60 + i, 60, 110}, 2.0);
        return picture;
      },
      5);
  EXPECT_GT(carried.iouOf(7), 0.93);
  ASSERT_NE(carried.find(7), nullptr);
  EXPECT_EQ(carried.find(7)->classId, kPerson);
  EXPECT_EQ(carried.find(7)->confidence, 0.9F);
  EXPECT_EQ(carried.find(7)->box_px, cv::boundingRect(carried.of(7)));
  EXPECT_EQ(cv::countNonZero((carried.masks.classIds == kPerson) != carried.of(7)), 0);
}

TEST(CarryMasks, FollowsWhileTheCameraTurns) {
  const Film film = [](int i) {
    Picture picture = wall(4.0, {8 * i, 0});
    put(picture, 1, kPerson, {200 - 3 * i, 60, 60, 110}, 2.0);
    put(picture, 2, kChair, {120 - 8 * i, 140, 50, 60}, 3.9);
    return picture;
  };
  const Carried carried = carry(film, 6);
  EXPECT_GT(carried.iouOf(1), 0.93);
  EXPECT_GT(carried.iouOf(2), 0.9);
  EXPECT_LT(iou(film(0).masks.instanceIds == 1, carried.truthOf(1)), 0.6) << "left as it was it would be useless";
}

TEST(CarryMasks, FollowsWhatComesNearer) {
  const Carried carried = carry(
      [](int i) {
        Picture picture = wall(5.0);
        put(picture, 1, kPerson, {120, 60, 60, 110}, 3.0 - 0.06 * i);
        return picture;
      },
      8);
  EXPECT_GT(carried.iouOf(1), 0.93);
}

TEST(CarryMasks, LeavesWhatTheThingUncovers) {
  // Seen to move or not: where the wall can be measured, the thing is no longer.
  const Carried carried = carry(
      [](int i) {
        Picture picture = wall(4.0);
        put(picture, 1, kPerson, {60 + 10 * i, 60, 60, 110}, 2.0);
        return picture;
      },
      5);
  EXPECT_EQ(cv::countNonZero(carried.of(1)(cv::Rect(60, 60, 44, 110))), 0);
}

TEST(CarryMasks, TakesInWhatEntersTheImage) {
  const Carried carried = carry(
      [](int i) {
        Picture picture = wall(4.0);
        put(picture, 1, kPerson, {-70 + 6 * i, 60, 90, 110}, 2.0);  // 20 px of it, 56 px at the end
        return picture;
      },
      6);
  EXPECT_EQ(cv::countNonZero(carried.truthOf(1)), 56 * 110);
  EXPECT_GT(carried.iouOf(1), 0.9);
}

TEST(CarryMasks, GoesByTheImageWhereThereIsNoDepth) {
  const Carried carried = carry(
      [](int i) {
        Picture picture = wall(4.0);
        put(picture, 1, kPerson, {60 + 6 * i, 60, 60, 110}, 2.0);
        picture.depth_m.setTo(0);
        return picture;
      },
      4);
  const int area_px = cv::countNonZero(carried.truthOf(1));
  EXPECT_GT(cv::countNonZero(carried.of(1) & carried.truthOf(1)), 0.85 * area_px);
  // What it uncovers looks like nothing before: the image alone cannot tell that it is the wall.
  EXPECT_LT(cv::countNonZero(carried.of(1) & ~carried.truthOf(1)), 0.45 * area_px);
}

TEST(CarryMasks, AHoleInTheDepthImageIsNoHoleInTheMask) {
  const cv::Rect hole(100, 90, 20, 20);
  const Carried carried = carry(
      [&](int i) {
        Picture picture = wall(4.0);
        put(picture, 1, kPerson, {80, 60, 60, 110}, 2.0);
        if (i % 2 == 1) picture.depth_m(hole).setTo(0);
        return picture;
      },
      3);
  EXPECT_EQ(cv::countNonZero(carried.of(1)(hole)), hole.area());
}

TEST(CarryMasks, DropsWhatIsHiddenByOrReplacedBySomethingElse) {
  const Film film = [](int i) {
    Picture picture = wall(4.0);
    put(picture, 1, kPerson, {60, 60, 60, 110}, 3.0);
    put(picture, 2, kPerson, {200, 60, 60, 110}, 3.0);
    if (i >= 2) put(picture, 3, kChair, {40, 40, 100, 150}, 1.0);
    return picture;
  };
  const Carried carried = carry(film, 2);
  EXPECT_EQ(carried.find(1), nullptr) << "something nearer came before it";
  EXPECT_EQ(cv::countNonZero(carried.of(1)), 0);
  ASSERT_NE(carried.find(2), nullptr);
  EXPECT_GT(carried.iouOf(2), 0.95);
}

TEST(CarryMasks, DropsWhatLeftTheImage) {
  const Carried carried = carry(
      [](int i) {
        Picture picture = wall(4.0, {10 * i, 0});
        put(picture, 1, kPerson, {30 - 10 * i, 60, 40, 110}, 4.0);
        return picture;
      },
      9);
  EXPECT_TRUE(carried.masks.instances.empty());
  EXPECT_EQ(cv::countNonZero(carried.masks.classIds), 0);
}

TEST(CarryMasks, ThingsThatTouchKeepApart) {
  const Carried carried = carry(
      [](int i) {
        Picture picture = wall(4.0);
        put(picture, 1, kPerson, {80, 60, 60, 110}, 2.0);
        put(picture, 2, kPerson, {140 + 4 * i, 60, 60, 110}, 2.6);  // was beside the first, walks off
        return picture;
      },
      4);
  EXPECT_GT(carried.iouOf(1), 0.93);
  EXPECT_GT(carried.iouOf(2), 0.93);
}

TEST(CarryMasks, GivesMasksOfFullSize) {
  Picture small = wall(4.0);
  put(small, 1, kPerson, {60, 60, 60, 110}, 2.0);
  const auto enlarged = [](const cv::Mat& image) {
    cv::Mat result;
    cv::resize(image, result, {2 * kWidth_px, 2 * kHeight_px}, 0, 0, cv::INTER_NEAREST);
    return result;
  };
  core::Segmentation masks{enlarged(small.masks.classIds), enlarged(small.masks.instanceIds), small.masks.instances};
  ImageMotion motion;
  for (int i = 0; i < 2; ++i) motion.advance(shrink(enlarged(small.gray), enlarged(small.depth_m), kFrame_s * i));
  Trail trail(motion.picture());
  trail.follow(motion.step());
  const core::Segmentation carried = carryMasks(masks, trail, motion.picture());
  EXPECT_EQ(carried.classIds.size(), cv::Size(640, 480));
  EXPECT_EQ(carried.instanceIds.type(), CV_16UC1);
  EXPECT_GT(iou(carried.instanceIds == 1, masks.instanceIds == 1), 0.97);
}

TEST(CarryMasks, OfNothingIsNothing) {
  const Picture picture = wall(4.0);
  const SmallPicture now = shrink(picture.gray, picture.depth_m, 0.0);
  EXPECT_TRUE(carryMasks({}, Trail(now), now).empty());
  const core::Segmentation nobody = carryMasks(picture.masks, Trail(now), now);
  EXPECT_EQ(nobody.classIds.size(), picture.gray.size());
  EXPECT_EQ(cv::countNonZero(nobody.classIds), 0);
  EXPECT_TRUE(nobody.instances.empty());
}

}  // namespace
}  // namespace wardslam::masks
