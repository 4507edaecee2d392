#include "descriptor_index.h"

#include <gmock/gmock.h>

namespace wardslam::graph {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

MATCHER_P2(Is, keyframe, distance, "") { return arg.keyframe == keyframe && arg.distance == distance; }

/// The first so many bits of the byte differ from those of all others.
cv::Mat withBits(int bits, int byte = 0) {
  cv::Mat descriptor(1, 32, CV_8UC1, cv::Scalar(0));
  for (int bit = 0; bit < bits; ++bit) descriptor.at<std::uint8_t>(byte + bit / 8) |= 1U << (bit % 8);
  return descriptor;
}

class DescriptorIndexTest : public testing::Test {
 protected:
  [[nodiscard]] auto nearest(const cv::Mat& descriptor, std::size_t count = 3, int mostDistance = 50) const {
    return index_.nearest(descriptor.ptr(), count, mostDistance);
  }

  DescriptorIndex index_;
};

TEST_F(DescriptorIndexTest, FindsTheNearestAndHowManyBitsDiffer) {
  index_.add(1, withBits(0));
  index_.add(2, withBits(3));
  index_.add(3, withBits(7));
  EXPECT_THAT(nearest(withBits(2)), ElementsAre(Is(2U, 1), Is(1U, 2), Is(3U, 5)));
  EXPECT_THAT(nearest(withBits(2), 2), ElementsAre(Is(2U, 1), Is(1U, 2)));
  EXPECT_THAT(nearest(withBits(2), 3, 2), ElementsAre(Is(2U, 1), Is(1U, 2)));
}

TEST_F(DescriptorIndexTest, CountsAllBits) {
  index_.add(1, withBits(256));
  EXPECT_THAT(nearest(withBits(256)), ElementsAre(Is(1U, 0)));
  EXPECT_THAT(nearest(withBits(0), 3, 256), IsEmpty()) << "not one bit of any key is the same";
  EXPECT_THAT(nearest(withBits(250), 3, 256), ElementsAre(Is(1U, 6)));
}

TEST_F(DescriptorIndexTest, OfEqualsThoseThatCameFirstComeFirst) {
  for (odometry::KeyframeId keyframe = 1; keyframe <= 4; ++keyframe) index_.add(keyframe, withBits(1));
  EXPECT_THAT(nearest(withBits(1)), ElementsAre(Is(1U, 0), Is(2U, 0), Is(3U, 0)));
}

TEST_F(DescriptorIndexTest, TakesDescriptorsOf32BytesOnly) {
  EXPECT_NO_THROW(index_.add(1, {}));
  EXPECT_THROW(index_.add(1, cv::Mat(1, 64, CV_8UC1, cv::Scalar(0))), cv::Exception);
  EXPECT_THROW(index_.add(1, cv::Mat(1, 32, CV_32FC1, cv::Scalar(0))), cv::Exception);
}

TEST_F(DescriptorIndexTest, ForgetsWhatIsOfAKeyframe) {
  cv::Mat both = withBits(1);
  both.push_back(withBits(2));
  index_.add(1, both);
  index_.add(2, withBits(4));
  index_.add(3, withBits(8));
  EXPECT_EQ(index_.size(), 4U);
  index_.remove(2);
  index_.remove(9);
  EXPECT_EQ(index_.size(), 3U);
  EXPECT_THAT(nearest(withBits(4)), ElementsAre(Is(1U, 2), Is(1U, 3), Is(3U, 4)));
  index_.remove(1);  // more are gone than are left
  EXPECT_EQ(index_.size(), 1U);
  EXPECT_THAT(nearest(withBits(4)), ElementsAre(Is(3U, 4)));
  index_.add(4, withBits(5));
  EXPECT_THAT(nearest(withBits(4)), ElementsAre(Is(4U, 1), Is(3U, 4)));
  index_.remove(3);
  EXPECT_THAT(nearest(withBits(4)), ElementsAre(Is(4U, 1)));
}

}  // namespace
}  // namespace wardslam::graph
