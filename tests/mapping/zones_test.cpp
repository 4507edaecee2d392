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

/// Zones of a file with this as its only zone, a square.
class ZoneRules : public testing::Test {
 protected:
  Zone read(const std::string& rules) {
    folder_.write("zones.yaml", "zones:\n  - {name: z, polygon: [[0, 0], [1, 0], [1, 1], [0, 1]]" + rules + "}\n");
    return Zones::fromFile(folder_.path() / "zones.yaml").all().front();
  }
  void expectRefused(const std::string& rules, const std::string& reason) {
    EXPECT_THAT([&] { static_cast<void>(read(rules)); }, ThrowsMessage<core::InputError>(HasSubstr(reason))) << rules;
  }

  test::TemporaryFolder folder_;
};

TEST_F(ZoneRules, AreReadByType) {
  EXPECT_EQ(read("").type, ZoneType::Place);
  EXPECT_EQ(read(", type: forbidden").type, ZoneType::Forbidden);
  EXPECT_EQ(read(", type: release").type, ZoneType::Release);
  const Zone slow = read(", type: slow, max_speed_mps: 0.3");
  EXPECT_EQ(slow.type, ZoneType::Slow);
  EXPECT_EQ(slow.maxSpeed_mps, 0.3);
  const Zone oneWay = read(", type: one_way, direction_deg: 90");
  EXPECT_EQ(oneWay.type, ZoneType::OneWay);
  EXPECT_NEAR(oneWay.direction_rad, 1.5707963, 1e-7);
  const Zone action = read(", type: action, on_entry: [ringBell, dimLights], on_exit: [brightenLights]");
  EXPECT_EQ(action.actions.entry, (std::vector<std::string>{"ringBell", "dimLights"}));
  EXPECT_TRUE(action.actions.inside.empty());
  EXPECT_EQ(action.actions.exit, std::vector<std::string>{"brightenLights"});
}

TEST_F(ZoneRules, WithoutWhatBelongsToThemAreRefused) {
  expectRefused(", type: quiet", "'quiet'");
  expectRefused(", type: slow", "needs max_speed_mps");
  expectRefused(", type: slow, max_speed_mps: 0", "more than 0 m/s");
  expectRefused(", type: slow, max_speed_mps: .nan", "more than 0 m/s");
  expectRefused(", type: slow, max_speed_mps: 11", "at most 10");
  expectRefused(", type: one_way", "needs direction_deg");
  expectRefused(", type: one_way, direction_deg: .inf", "no angle");
  expectRefused(", type: action", "asks for no action");
}

TEST_F(ZoneRules, ThatWouldBeLeftOutAreRefused) {
  expectRefused(", type: forbidden, max_speed_mps: 0.3", "max_speed_mps");
  expectRefused(", max_speed_mps: 0.3", "max_speed_mps");
}

}  // namespace
}  // namespace wardslam::mapping
