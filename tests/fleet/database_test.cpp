#include "wardslam/fleet/database.h"

#include "fleet/fleet_test.h"

namespace wardslam::fleet {
namespace {

using testing::HasSubstr;

class DatabaseTest : public FleetTest {
 protected:
  std::string pushingError(const std::string& url) const {
    writeWard();
    return test::complaintOf([&] { return push(url, {"robot 1", "ward", "north", "1"}, file_).objects; });
  }
};

TEST(DatabaseUrl, IsShownWithoutThePassword) {
  EXPECT_EQ(withoutPassword("postgresql://me:secret@host/ward"), "postgresql://me@host/ward");
  EXPECT_EQ(withoutPassword("postgresql://me@host/ward"), "postgresql://me@host/ward");
  EXPECT_EQ(withoutPassword("host=a password='se cret' user=b"), "host=a password=... user=b");
  EXPECT_EQ(withoutPassword("postgresql:///w?password=secret&user=b"), "postgresql:///w?password=...&user=b");
}

TEST_F(DatabaseTest, IsPreparedOnceByManyAtOnce) {
  const auto url = server().make("bare");
  atOnce(4, [&](int) { EXPECT_EQ(prepareDatabase(url).now, schemaVersion()); });
  EXPECT_EQ(prepareDatabase(url).before, schemaVersion());
  EXPECT_EQ(server().sql("bare", "SELECT count(*) FROM wardslam.migrations"), std::to_string(schemaVersion()));
}

TEST_F(DatabaseTest, SaysWhatIsWrongAndWhatToDo) {
  EXPECT_THAT(pushingError("postgresql://nobody@127.0.0.1:1/ward"), HasSubstr("is the server running"));
  EXPECT_THAT(pushingError(server().url("nowhere")), HasSubstr("make it with createdb"));
  EXPECT_THAT(pushingError(server().make("empty")),
              HasSubstr("has no tables of WardSLAM yet; run wardslam fleet init"));
  (void)sql("DELETE FROM migrations WHERE version = 2");
  EXPECT_THAT(pushingError(url_), HasSubstr("its schema has version 1, this program needs 2; run wardslam fleet init"));
  (void)sql("INSERT INTO migrations VALUES (2, 'x'), (3, 'y')");
  EXPECT_THAT(pushingError(url_), HasSubstr("its schema has version 3, this program knows 2; use a newer WardSLAM"));
}

TEST_F(DatabaseTest, RobotsAddReadersRead) {
  (void)sql(
      "DO $$ BEGIN CREATE ROLE porter LOGIN IN ROLE wardslam_robot; CREATE ROLE nurse LOGIN IN ROLE "
      "wardslam_reader; END $$");
  EXPECT_EQ(pushingError(server().url(database_, "porter")), "");
  EXPECT_THAT(pushingError(server().url(database_, "nurse")), HasSubstr("this user may not do that"));
  EXPECT_ANY_THROW((void)sql("SET ROLE wardslam_robot; DELETE FROM sightings"));
  EXPECT_EQ(sql("SET ROLE wardslam_reader; SELECT count(*) FROM sightings"), "7");
}

TEST_F(DatabaseTest, AFileThatIsNoMapIsSaid) {
  const auto file = folder_.write("letter.wardmap", "Dear robot, this is no map but a letter of some length.");
  EXPECT_THAT(test::complaintOf([&] {
                return push(url_, {"r", "m", "s", "1"}, file).objects;
              }),
              HasSubstr("is not a WardSLAM map"));
}

}  // namespace
}  // namespace wardslam::fleet
