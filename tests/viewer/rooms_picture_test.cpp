#include "wardslam/viewer/rooms_picture.h"

#include <gtest/gtest.h>

namespace wardslam::viewer {
namespace {

/// A room of 2 m × 1 m with its corner at (1, 1), another of 1 m × 1 m north of its western half.
building::Rooms twoRooms() {
  building::Rooms rooms;
  rooms.resolution_m = 0.1;
  rooms.ids = cv::Mat(40, 40, CV_32SC1, cv::Scalar(0));
  rooms.ids(cv::Rect(10, 10, 20, 10)).setTo(1);
  rooms.ids(cv::Rect(10, 20, 10, 10)).setTo(2);
  rooms.all = {{1, "ward", 2.0, {2.0, 1.5}, {}}, {2, "store", 1.0, {1.5, 2.5}, {}}};
  rooms.doors = {{1, 2, {1.2, 2.0}, {1.8, 2.0}, 0.6}};
  return rooms;
}

TEST(RoomsPicture, NorthIsUpAndRoomsHaveTheirOwnColours) {
  const cv::Mat picture = drawRooms(twoRooms());
  ASSERT_EQ(picture.size(), cv::Size(2 * 20 + 60, 2 * 20 + 60));  // 2 m × 2 m at 30 px a metre, 20 px around
  const auto ward = picture.at<cv::Vec3b>(20 + 55, 20 + 2);
  const auto store = picture.at<cv::Vec3b>(20 + 5, 20 + 2);
  EXPECT_NE(ward, store);
  EXPECT_EQ(picture.at<cv::Vec3b>(20 + 5, 20 + 45), cv::Vec3b(255, 255, 255));  // no room in the north-east
  EXPECT_EQ(picture.at<cv::Vec3b>(20 + 30, 20 + 15), cv::Vec3b(0, 0, 0));       // the door
}

TEST(RoomsPicture, NoRoomsMakeASmallEmptyPicture) {
  const cv::Mat picture = drawRooms({});
  EXPECT_EQ(cv::countNonZero(picture.reshape(1) != 255), 0);
  EXPECT_LT(picture.total(), 10000U);
}

}  // namespace
}  // namespace wardslam::viewer
