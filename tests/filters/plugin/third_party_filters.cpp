// What somebody outside the project would write: filters in a library of their own.

#include <mrpt/core/initializer.h>

#include "wardslam/filters/observation_filter.h"

namespace third_party {

struct EveryNthOptions {
  int nth = 2;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("nth", self.nth, {1, 1000}, "count", "which key points to reject");
  }
};

/// Rejects every nth key point.
class EveryNthFilter : public wardslam::filters::ObservationFilter {
  DEFINE_MRPT_OBJECT(EveryNthFilter, third_party)

 public:
  void initialize(const wardslam::core::ConfigNode& parameters, const wardslam::filters::FilterContext&) override {
    wardslam::core::readOptions(parameters, options_);
  }
  void begin(const wardslam::core::Frame&) override { begun_ = true; }
  void apply(wardslam::core::Frame& frame) override {
    if (!begun_) ++frame.events["third_party.not_begun"];
    auto& keypoints = frame.features.keypoints;
    const auto nth = static_cast<std::size_t>(options_.nth);
    for (std::size_t i = 0; i < keypoints.size(); i += nth) keypoints[i].motion = wardslam::core::Motion::Dynamic;
  }
  std::string parameters(int indent) const override { return wardslam::core::writeOptions(options_, indent); }

 private:
  EveryNthOptions options_;
  bool begun_ = false;
};

/// Has no parameters and does nothing.
class IdleFilter : public wardslam::filters::ObservationFilter {
  DEFINE_MRPT_OBJECT(IdleFilter, third_party)

 public:
  void initialize(const wardslam::core::ConfigNode& parameters, const wardslam::filters::FilterContext&) override {
    parameters.requireKeys({});
  }
  void apply(wardslam::core::Frame&) override {}
  std::string parameters(int) const override { return {}; }
};

/// Works until a library fails within it.
class FailingFilter : public wardslam::filters::ObservationFilter {
  DEFINE_MRPT_OBJECT(FailingFilter, third_party)

 public:
  void initialize(const wardslam::core::ConfigNode& parameters, const wardslam::filters::FilterContext&) override {
    parameters.requireKeys({});
  }
  void apply(wardslam::core::Frame& frame) override {
    if (frame.index == 7) CV_Error(cv::Error::StsAssert, "sizes\ndiffer");
  }
  std::string parameters(int) const override { return {}; }
};

IMPLEMENTS_MRPT_OBJECT(EveryNthFilter, wardslam::filters::ObservationFilter, third_party)
IMPLEMENTS_MRPT_OBJECT(IdleFilter, wardslam::filters::ObservationFilter, third_party)
IMPLEMENTS_MRPT_OBJECT(FailingFilter, wardslam::filters::ObservationFilter, third_party)

}  // namespace third_party

MRPT_INITIALIZER(registerThirdPartyFilters) {
  mrpt::rtti::registerClass(CLASS_ID(third_party::EveryNthFilter));
  mrpt::rtti::registerClass(CLASS_ID(third_party::IdleFilter));
  mrpt::rtti::registerClass(CLASS_ID(third_party::FailingFilter));
}
