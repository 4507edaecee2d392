#include "wardslam/query/object_name.h"

#include <gmock/gmock.h>

#include "support/complaint.h"
#include "support/hand_made_map.h"
#include "wardslam/core/errors.h"

namespace wardslam::query {
namespace {

using testing::HasSubstr;

class ObjectNameTest : public testing::Test {
 protected:
  std::string complaintAbout(const std::string& name) const {
    return test::complaintOf([&] { return objectNamed(map_, name).id; });
  }

  mapping::SemanticMap map_ = test::makeWard();  // chairs are 1, 2, 4, 6 (gone), 7; the bed is 5, the backpack 3
};

TEST_F(ObjectNameTest, CountsWithinTheClassAndNumbersStayWhenSomethingIsGone) {
  EXPECT_EQ(objectNamed(map_, "chair 1").id, 1U);
  EXPECT_EQ(objectNamed(map_, "chair 3").id, 4U);
  EXPECT_EQ(objectNamed(map_, "chair 5").id, 7U);
}

TEST_F(ObjectNameTest, TakesIdsAndClassesOfWhichThereIsOne) {
  EXPECT_EQ(objectNamed(map_, "#4").id, 4U);
  EXPECT_EQ(objectNamed(map_, "chair #7").id, 7U);
  EXPECT_EQ(objectNamed(map_, "bed").id, 5U);
}

TEST_F(ObjectNameTest, ClassesOfTwoWordsAreSpelledEitherWay) {
  map_.labels.rename(test::kBed, "hospital_bed");
  EXPECT_EQ(objectNamed(map_, "hospital_bed 1").id, 5U);
  EXPECT_EQ(objectNamed(map_, "hospital bed").id, 5U);
}

TEST_F(ObjectNameTest, NamesWhatItUnderstands) {
  for (const auto& [id, object] : map_.objects) {
    if (object.state == mapping::ObjectState::Gone) continue;
    EXPECT_EQ(objectNamed(map_, nameOf(object, map_)).id, id);
  }
}

TEST_F(ObjectNameTest, SaysWhatThereIsInstead) {
  EXPECT_THAT(complaintAbout("chair"), HasSubstr("could be any of chair 1, chair 2, chair 3, chair 5"));
  EXPECT_THAT(complaintAbout("bed 2"), HasSubstr("only bed 1"));
  EXPECT_THAT(complaintAbout("bad 1"), HasSubstr("did you mean 'bed'"));
  EXPECT_THAT(complaintAbout("chair 4"), HasSubstr("is gone"));
  EXPECT_THAT(complaintAbout("#99"), HasSubstr("no object '#99'"));
  EXPECT_THAT(complaintAbout("bed #1"), HasSubstr("is no 'bed' but chair 1"));
  EXPECT_THAT(complaintAbout("chair 0"), HasSubstr("no 'chair 0'"));
  map_.objects.clear();
  EXPECT_THAT(complaintAbout("bed 1"), HasSubstr("holds no objects"));
}

}  // namespace
}  // namespace wardslam::query
