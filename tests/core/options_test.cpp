#include "wardslam/core/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "support/complaint.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

enum class Mode { Slow, Fast };

struct Inner {
  double ratio = 0.5;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("ratio", self.ratio, {0.0, 1.0}, "", "share of the whole");
  }
};

struct Outer {
  int count = 7;
  double length_m = 1.5;
  bool enabled = false;
  std::string name = "plain";
  Mode mode = Mode::Slow;
  Inner inner;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("count", self.count, {1, 100}, "count", "how many");
    visit("length", self.length_m, {-10.0, 10.0}, "m", "how long");
    visit("enabled", self.enabled, "whether at all");
    visit("name", self.name, "what it is called");
    visit("mode", self.mode, {"slow", "fast"}, "how");
    visit.group("inner", self.inner);
  }
};

Outer read(const std::string& yaml) {
  Outer options;
  readOptions(ConfigNode::fromText(yaml, "my.yaml"), options);
  return options;
}

/// What reading complains about; empty when it does not.
std::string complaint(const std::string& yaml) {
  return test::complaintOf([&] { return read(yaml); });
}

TEST(Options, KeepDefaultsWhereTheFileIsSilent) {
  for (const char* yaml : {"", "{}", "count:\n", "inner:\n"}) {
    const Outer options = read(yaml);
    EXPECT_EQ(options.count, 7) << yaml;
    EXPECT_EQ(options.length_m, 1.5) << yaml;
    EXPECT_EQ(options.name, "plain") << yaml;
    EXPECT_EQ(options.inner.ratio, 0.5) << yaml;
  }
}

TEST(Options, TakeEveryKindOfValue) {
  const Outer options = read("count: 3\nlength: -2.25\nenabled: true\nname: a b\nmode: fast\ninner: {ratio: 1}\n");
  EXPECT_EQ(options.count, 3);
  EXPECT_EQ(options.length_m, -2.25);
  EXPECT_TRUE(options.enabled);
  EXPECT_EQ(options.name, "a b");
  EXPECT_EQ(options.mode, Mode::Fast);
  EXPECT_EQ(options.inner.ratio, 1.0);
}

TEST(Options, BoundsBelongToTheAllowedValues) {
  EXPECT_EQ(read("count: 1").count, 1);
  EXPECT_EQ(read("count: 100").count, 100);
  EXPECT_EQ(complaint("name: x\ncount: 101"), "my.yaml:2: 'count': 101 is outside [1, 100] count");
  EXPECT_EQ(complaint("count: 0"), "my.yaml:1: 'count': 0 is outside [1, 100] count");
  EXPECT_THAT(complaint("length: 10.01"), HasSubstr("10.01 is outside [-10, 10] m"));
  EXPECT_THAT(complaint("length: .nan"), HasSubstr("outside"));
  EXPECT_THAT(complaint("length: .inf"), HasSubstr("outside"));
}

TEST(Options, UnknownKeyNamesFileLineAndNearestKey) {
  EXPECT_EQ(complaint("count: 3\nlenght: 2\n"), "my.yaml:2: 'lenght': unknown key; did you mean 'length'?");
  EXPECT_EQ(complaint("inner:\n  rato: 0.1\n"), "my.yaml:2: 'inner.rato': unknown key; did you mean 'ratio'?");
}

TEST(Options, KeyGivenTwiceIsRefused) {
  EXPECT_THAT(complaint("count: 3\nname: x\ncount: 4\n"), AllOf(StartsWith("my.yaml:3: 'count'"), HasSubstr("twice")));
}

TEST(Options, KeyThatIsNoNameIsRefused) { EXPECT_THAT(complaint("count: 3\n[a, b]: 4\n"), StartsWith("my.yaml:2: ")); }

TEST(Options, WrongTypeSaysWhatIsExpected) {
  EXPECT_EQ(complaint("count: many"), "my.yaml:1: 'count': a whole number is expected here");
  EXPECT_THAT(complaint("count: 1.5"), HasSubstr("a whole number is expected"));
  EXPECT_THAT(complaint("count: 99999999999"), HasSubstr("a whole number is expected"));
  EXPECT_THAT(complaint("length: 1,5"), HasSubstr("a number is expected"));
  EXPECT_THAT(complaint("length: [1]"), HasSubstr("a number is expected"));
  EXPECT_THAT(complaint("enabled: 2"), HasSubstr("true or false is expected"));
  EXPECT_THAT(complaint("name: {a: 1}"), HasSubstr("a text is expected"));
  EXPECT_THAT(complaint("inner: 3"), HasSubstr("'inner': a mapping"));
  EXPECT_THAT(complaint("- 1"), HasSubstr("a mapping"));
}

TEST(Options, EnumerationListsItsNames) {
  EXPECT_EQ(complaint("mode: quick"), "my.yaml:1: 'mode': 'quick' is none of: slow, fast");
}

TEST(Options, WrittenOptionsReadBackExactly) {
  Outer options;
  options.count = 42;
  options.length_m = 1.0 / 3.0;
  options.enabled = true;
  options.name = "quote \" backslash \\ colon: # hash\nnew line, ä";
  options.mode = Mode::Fast;
  options.inner.ratio = 0.1;
  const Outer back = read(writeOptions(options));
  EXPECT_EQ(back.count, options.count);
  EXPECT_EQ(back.length_m, options.length_m);
  EXPECT_EQ(back.enabled, options.enabled);
  EXPECT_EQ(back.name, options.name);
  EXPECT_EQ(back.mode, options.mode);
  EXPECT_EQ(back.inner.ratio, options.inner.ratio);
}

TEST(Options, AreWrittenWithUnitBoundsAndHelp) {
  EXPECT_EQ(writeOptions(Outer{}),
            "count: 7  # [1, 100] count how many\n"
            "length: 1.5  # [-10, 10] m how long\n"
            "enabled: false  # true, false: whether at all\n"
            "name: \"plain\"  # what it is called\n"
            "mode: slow  # slow, fast: how\n"
            "inner:\n"
            "  ratio: 0.5  # [0, 1] share of the whole\n");
}

TEST(OptionReader, OpaquePartIsKnownButNotRead) {
  OptionReader reader(ConfigNode::fromText("filters: [{class_name: X}]\n", "my.yaml"));
  const ConfigNode filters = reader.opaque("filters");
  EXPECT_NO_THROW(reader.finish());
  EXPECT_EQ(filters.item(0).child("class_name").yaml().as<std::string>(), "X");
  EXPECT_EQ(filters.item(0).child("class_name").key(), "filters[0].class_name");
  EXPECT_THROW(static_cast<void>(filters.item(1)), InputError);
  EXPECT_FALSE(filters.item(0).child("params").exists());
}

TEST(ConfigNode, TellsWhereTextIsNotYaml) {
  EXPECT_THAT([] { return ConfigNode::fromText("a: 1\nb: [1, 2\nc: 3\n", "my.yaml"); },
              testing::ThrowsMessage<InputError>(AllOf(StartsWith("my.yaml:3: "), HasSubstr("not valid YAML"))));
}

TEST(ConfigNode, TellsThatAFileCannotBeRead) {
  const test::TemporaryFolder folder;
  EXPECT_THAT([&] { return ConfigNode::fromFile(folder.path() / "none.yaml"); },
              testing::ThrowsMessage<InputError>(HasSubstr("none.yaml: cannot be opened")));
  EXPECT_THROW(static_cast<void>(ConfigNode::fromFile(folder.path())), InputError) << "a folder is no file";
}

TEST(ConfigNode, ReadingAskedForAbsentKeysLeavesTheNodeAlone) {
  const ConfigNode node = ConfigNode::fromText("a: 1\n");
  EXPECT_FALSE(node.child("b").exists());
  EXPECT_EQ(node.yaml().size(), 1U);
}

}  // namespace
}  // namespace wardslam::core
