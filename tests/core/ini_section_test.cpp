#include "wardslam/core/ini_section.h"

#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>

#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

mrpt::config::CConfigFileMemory iniOf(const std::string& text) {
  mrpt::config::CConfigFileMemory ini;
  ini.setContent(text);
  return ini;
}

TEST(IniSection, OverlaysPathsAndLeavesOutWhatIsSomebodyElses) {
  YAML::Node root = YAML::Load("{a: {b: 1, c: 2}}");
  overlay(root, iniOf("[s]\na.b = 3\nd = text\ntheirs = 4\n"), "s", {"theirs"});
  EXPECT_EQ(root["a"]["b"].as<int>(), 3);
  EXPECT_EQ(root["a"]["c"].as<int>(), 2);
  EXPECT_EQ(root["d"].as<std::string>(), "text");
  EXPECT_FALSE(root["theirs"]);
}

TEST(IniSection, LeavesOutRemarksBehindValues) {
  YAML::Node root(YAML::NodeType::Map);
  overlay(root, iniOf("[s]\na = 0.5   ; metres\nb = 7 // images\nc = x://y;z\n"), "s");
  EXPECT_EQ(root["a"].as<double>(), 0.5);
  EXPECT_EQ(root["b"].as<int>(), 7);
  EXPECT_EQ(root["c"].as<std::string>(), "x://y;z");
}

TEST(IniSection, NamesAKeyBelowAValue) {
  const YAML::Node root = YAML::Load("{a: 1}");
  EXPECT_THROW(overlay(root, iniOf("[s]\na.b = 3\n"), "s"), InputError);
}

TEST(IniSection, IsWrittenAsItIsRead) {
  mrpt::config::CConfigFileMemory ini;
  writeSection(YAML::Load("{a: {b: 1.5, c: {d: text}}}"), ini, "s");
  YAML::Node back(YAML::NodeType::Map);
  overlay(back, ini, "s");
  EXPECT_EQ(back["a"]["b"].as<double>(), 1.5);
  EXPECT_EQ(back["a"]["c"]["d"].as<std::string>(), "text");
}

}  // namespace
}  // namespace wardslam::core
