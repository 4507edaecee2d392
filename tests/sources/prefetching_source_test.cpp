#include "prefetching_source.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "sources/scan_maker.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

/// Delivers scans 0, 1, …; before scan `damagedBefore` it meets damage, instead of scan `throwsAt` it throws.
class ScriptedSource : public ObservationSource {
 public:
  struct Script {
    int scans = 5;
    int damagedBefore = -1;
    int throwsAt = -1;
  };
  ScriptedSource(Script script, WarningSink warn) : script_(script), warn_(std::move(warn)) { warn_("opened"); }

  std::shared_ptr<mrpt::obs::CObservation3DRangeScan> next() override {
    if (nextScan_ == script_.damagedBefore) {
      ++damage_["sources.test"];
      warn_("damaged");
    }
    if (nextScan_ == script_.throwsAt) throw core::InputError("thrown");
    if (nextScan_ == script_.scans) return nullptr;
    return test::makeScan(nextScan_++);
  }
  [[nodiscard]] std::optional<std::size_t> size() const override { return 42; }
  [[nodiscard]] const core::EventCounts& damage() const override { return damage_; }

 private:
  Script script_;
  WarningSink warn_;
  int nextScan_ = 0;
  core::EventCounts damage_;
};

class Prefetching : public ::testing::Test {
 protected:
  std::unique_ptr<PrefetchingSource> open(ScriptedSource::Script script) {
    return std::make_unique<PrefetchingSource>(
        [script](WarningSink warn) { return std::make_unique<ScriptedSource>(script, std::move(warn)); },
        [this](const std::string& sentence) { warnings.push_back(sentence); });
  }
  static int numberOf(const mrpt::obs::CObservation3DRangeScan& scan) {
    return static_cast<int>(core::fromMrptTime(scan.timestamp) + 0.5) - 1000;
  }
  std::vector<std::string> warnings;
};

TEST_F(Prefetching, KeepsTheOrder) {
  const auto source = open({50, -1, -1});
  EXPECT_EQ(source->size(), 42U);
  for (int i = 0; i < 50; ++i) {
    const auto scan = source->next();
    ASSERT_TRUE(scan);
    EXPECT_EQ(numberOf(*scan), i);
  }
  EXPECT_FALSE(source->next());
  EXPECT_FALSE(source->next());
}

TEST_F(Prefetching, TellsOfDamageWhenItIsDue) {
  const auto source = open({5, 2, -1});
  EXPECT_THAT(warnings, ElementsAre("opened"));
  ASSERT_TRUE(source->next());
  ASSERT_TRUE(source->next());
  EXPECT_THAT(source->damage(), IsEmpty());
  EXPECT_THAT(warnings, ElementsAre("opened"));
  ASSERT_TRUE(source->next());
  EXPECT_THAT(source->damage(), ElementsAre(Pair("sources.test", 1)));
  EXPECT_THAT(warnings, ElementsAre("opened", "damaged"));
}

TEST_F(Prefetching, PassesOnDamageAtTheEnd) {
  const auto source = open({1, 1, -1});
  ASSERT_TRUE(source->next());
  EXPECT_FALSE(source->next());
  EXPECT_THAT(source->damage(), ElementsAre(Pair("sources.test", 1)));
}

TEST_F(Prefetching, PassesOnExceptionsInTheirPlace) {
  const auto source = open({5, -1, 1});
  ASSERT_TRUE(source->next());
  EXPECT_THROW(static_cast<void>(source->next()), core::InputError);
  EXPECT_FALSE(source->next());
}

TEST_F(Prefetching, PassesOnExceptionsOfOpening) {
  const auto fail = [](const WarningSink&) -> std::unique_ptr<ObservationSource> { throw core::InputError("closed"); };
  EXPECT_THROW(PrefetchingSource(fail, {}), core::InputError);
}

TEST_F(Prefetching, MayBeLeftBeforeTheEnd) {
  const auto source = open({1000000, -1, -1});
  ASSERT_TRUE(source->next());  // the destructor must not wait for the rest
}

}  // namespace
}  // namespace wardslam::sources
