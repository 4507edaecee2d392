#include "repeated_schema_filter.h"

#include <gtest/gtest.h>

#include <iostream>
#include <sstream>
#include <thread>

namespace wardslam::segmentation {
namespace {

/// As ONNX 1.17 writes it: the message ends a line, and another end follows.
constexpr const char* kRepetition =
    "Schema error: Trying to register schema with name Abs (domain:  version: 1) from file old.cc line 1, but it is "
    "already registered from file old.cc line 1\n\n";

class RepeatedSchemaFilterTest : public ::testing::Test {
 protected:
  std::string filtered(const std::string& text) {
    in_ << text;
    filter_.finish();
    return out_.str();
  }

  std::stringbuf out_;
  RepeatedSchemaFilter filter_{out_};
  std::ostream in_{&filter_};
};

TEST_F(RepeatedSchemaFilterTest, HoldsRepetitionsBack) {
  EXPECT_EQ(filtered(std::string("a\n") + kRepetition + kRepetition + "\nb\n"), "a\n\nb\n");
}

TEST_F(RepeatedSchemaFilterTest, HoldsThemBackHoweverTheyAreWritten) {
  const std::string text = kRepetition;
  in_ << text.substr(0, 14) << text.substr(14, text.size() - 15) << text.back() << "Schema " << std::flush;
  EXPECT_EQ(filtered("lost\n"), "Schema lost\n");
}

TEST_F(RepeatedSchemaFilterTest, PassesAllElseOn) {
  const std::string others =
      "\n\nSchema error: Trying to register schema with name X, but its domain is unknown\n"
      "wardslam: Schema error: Trying to register schema with name X but it is already registered\n"
      "\rframe 3/10";
  EXPECT_EQ(filtered(others), others);
}

TEST_F(RepeatedSchemaFilterTest, PassesOnWhatOtherThreadsWriteAsItComes) {
  in_ << "half a line";
  std::thread([&] { std::ostream(&filter_) << kRepetition << std::flush; }).join();
  EXPECT_EQ(out_.str(), kRepetition);
}

TEST_F(RepeatedSchemaFilterTest, GuardFiltersStandardErrorWhileItLives) {
  std::stringbuf standIn;
  std::streambuf* const before = std::cerr.rdbuf(&standIn);
  {
    RepeatedSchemaFilter filter(*std::cerr.rdbuf());
    const FilterGuard guard(filter);
    std::cerr << kRepetition << "a real error";
  }
  std::cerr << kRepetition;
  std::cerr.rdbuf(before);
  EXPECT_EQ(standIn.str(), std::string("a real error") + kRepetition);
}

}  // namespace
}  // namespace wardslam::segmentation
