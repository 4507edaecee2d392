#include "wardslam/graph/place_recognition.h"

#include <gmock/gmock.h>

#include "odometry/synthetic_world.h"

namespace wardslam::graph {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class PlaceRecognitionTest : public ::testing::Test {
 protected:
  static constexpr int kGap = 4;

  static PlaceRecognitionOptions options() {
    PlaceRecognitionOptions options;
    options.min_keyframe_gap = kGap;
    return options;
  }

  void add(const core::Features& features) { places_.add(++last_, features.descriptors); }

  void addElsewhere(int count) {
    for (int i = 0; i < count; ++i) add(world_.lookElsewhere(200));
  }

  /// The place, its descriptors a little different each time.
  core::Features place(int image = 0) {
    return world_.look(test::SyntheticWorld::T_world_cam(image, 10), {1.0, 1.0, 20});
  }

  test::SyntheticWorld world_{1000};
  PlaceRecognition places_{options()};
  odometry::KeyframeId last_ = 0;
};

TEST_F(PlaceRecognitionTest, FindsAPlaceWhenSomeOthersHaveCome) {
  add(place());
  EXPECT_THAT(places_.candidates(place(), {}), IsEmpty());
  addElsewhere(kGap);
  EXPECT_THAT(places_.candidates(place(), {}), ElementsAre(1));
}

TEST_F(PlaceRecognitionTest, FindsAPlaceAtOnceWhenTold) {
  places_.build();
  EXPECT_THAT(places_.candidates(place(), {}), IsEmpty()) << "nothing was added yet";
  add(place());
  places_.build();
  EXPECT_THAT(places_.candidates(place(), {}), ElementsAre(1));
}

TEST_F(PlaceRecognitionTest, KeepsFindingPlacesAsTheMapGrows) {
  addElsewhere(3 * kGap);
  add(place());
  const odometry::KeyframeId old = last_;
  addElsewhere(2 * kGap);
  EXPECT_THAT(places_.candidates(place(), {}), ElementsAre(old));
}

TEST_F(PlaceRecognitionTest, LeavesOutWhatIsKnownAnyway) {
  add(place());
  addElsewhere(2 * kGap);
  EXPECT_THAT(places_.candidates(place(), {1}), IsEmpty());
}

TEST_F(PlaceRecognitionTest, FindsNothingWhereItNeverWas) {
  add(place());
  addElsewhere(2 * kGap);
  EXPECT_THAT(places_.candidates(world_.lookElsewhere(500), {}), IsEmpty());
  EXPECT_THAT(places_.candidates({}, {}), IsEmpty());
}

TEST_F(PlaceRecognitionTest, TheLikeliestComesFirst) {
  add(place(9));  // a metre on, turned by half a field of view
  add(place(0));
  addElsewhere(2 * kGap);
  ASSERT_THAT(places_.candidates(place(0), {}), testing::SizeIs(testing::Ge(2U)));
  EXPECT_EQ(places_.candidates(place(0), {}).front(), 2U);
  EXPECT_EQ(places_.candidates(place(9), {}).front(), 1U);
}

TEST_F(PlaceRecognitionTest, FindsNothingThatWasRemoved) {
  add(place());
  addElsewhere(kGap);
  places_.remove(1);
  EXPECT_THAT(places_.candidates(place(), {}), IsEmpty());
  add(place());
  places_.remove(last_);
  addElsewhere(2 * kGap);
  EXPECT_THAT(places_.candidates(place(), {}), IsEmpty()) << "also not of those that waited";
  add(place());
  places_.build();
  EXPECT_THAT(places_.candidates(place(), {}), ElementsAre(last_));
}

}  // namespace
}  // namespace wardslam::graph
