#include "wardslam/mapping/zones.h"

#include <gmock/gmock.h>

#include <fstream>
#include <limits>

#include "support/temporary_folder.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"

namespace wardslam::mapping {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Zone rectangle(const std::string& name, double x0, double y0, double x1, double y1) {
  return {name, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

TEST(Zones, NameThePlaceWhateverTheOrder) {
  const Zone ward = rectangle("ward", 0, 0, 10, 10);
  const Zone isolation = rectangle("isolation", 2, 2, 4, 4);
  for (const Zones& zones : {Zones({ward, isolation}), Zones({isolation, ward})}) {
    EXPECT_EQ(zones.at({3, 3}), "isolation") << "the smaller of two";
    EXPECT_EQ(zones.at({5, 5}), "ward");
    EXPECT_EQ(zones.at({10, 5}), "ward") << "the border belongs to it";
    EXPECT_EQ(zones.at({10.01, 5}), "");
  }
  EXPECT_EQ(Zones().at({0, 0}), "");
}

TEST(Zones, MayBeConcave) {
  const Zones zones({{"L", {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}}});
  EXPECT_EQ(zones.at({3, 0.5}), "L");
  EXPECT_EQ(zones.at({0.5, 3}), "L");
  EXPECT_EQ(zones.at({3, 3}), "");
}

TEST(Zones, RefuseWhatIsNoFloor) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [](std::vector<Zone> zones, const std::string& reason) {
    EXPECT_THAT([&] { Zones{zones}; }, ThrowsMessage<core::InputError>(HasSubstr(reason))) << reason;
  };
  refuses({{"thin", {{0, 0}, {1, 0}}}}, "zone \"thin\" needs at least 3 corners");
  refuses({{"bow tie", {{0, 0}, {2, 2}, {2, 0}, {0, 2}}}}, "zone \"bow tie\" has sides that cross");
  refuses({{"line", {{0, 0}, {1, 1}, {2, 2}}}}, "zone \"line\" has no area");
  refuses({{"odd", {{0, 0}, {nan, 0}, {1, 1}}}}, "zone \"odd\" has a corner that is not a number");
  refuses({rectangle("a", 0, 0, 1, 1), rectangle("a", 2, 2, 3, 3)}, "zone \"a\" is given twice");
  refuses({rectangle("", 0, 0, 1, 1)}, "a zone has no name");
}

class ZonesFileTest : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) {
    std::ofstream(file_) << text;
    return file_;
  }

  const test::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "zones.yaml";
};

TEST_F(ZonesFileTest, IsRead) {
  const auto zones =
      Zones::fromFile(write("zones:\n"
                            "- name: clean\n"
                            "  polygon: [[0, 0], [4, 0], [4, 3.5], [0, 3.5]]\n"));
  ASSERT_EQ(zones.all().size(), 1U);
  EXPECT_EQ(zones.at({3.9, 3.4}), "clean");
}

TEST_F(ZonesFileTest, TheExampleIsOne) {
  const auto zones = Zones::fromFile(core::findDataFile("zones/example.yaml", {}));
  EXPECT_EQ(zones.at({7, 2}), "isolation area");
  EXPECT_EQ(zones.at({2, 2}), "ward");
}

TEST_F(ZonesFileTest, ErrorsNameFileLineAndZone) {
  const auto refuses = [&](const std::string& text, const std::string& where, const std::string& what) {
    EXPECT_THAT([&] { static_cast<void>(Zones::fromFile(write(text))); },
                ThrowsMessage<core::InputError>(AllOf(HasSubstr("zones.yaml" + where), HasSubstr(what))));
  };
  refuses("zones:\n- name: a\n  polygon: [[0, 0], [1, 0, 3], [1, 1]]\n", ":2", "a pair [x, y]");
  refuses("zones:\n- name: a\n  polygon: [[0, 0], [one, 0], [1, 1]]\n", ":2", "polygon [[x, y], ...] in metres");
  refuses("zones:\n- name: a\n  polygn: [[0, 0], [1, 0], [1, 1]]\n", ":", "polygon");
  refuses("zones:\n- name: a\n  polygon: [[0, 0], [1, 0]]\n", "", "zone \"a\" needs at least 3 corners");
  refuses("rooms: []\n", ":", "zones");
  refuses("zones: 3\n", ":", "zones");
  EXPECT_THROW(static_cast<void>(Zones::fromFile(folder_.path() / "absent.yaml")), core::InputError);
}

}  // namespace
}  // namespace wardslam::mapping
