// Leaves out key points whose depth cannot be trusted: those far away, or without any. WardSLAM loads the library that
// the configuration names (range_filter.yaml) and makes the filter by its class name; docs/filters.md explains.

#include <mrpt/core/initializer.h>
#include <wardslam/filters/observation_filter.h>

#include <string>

namespace example {

/// Declared once: read from YAML with bounds and good errors, and written back by `wardslam run` into config.yaml.
struct RangeFilterOptions {
  double max_depth_m = 3.5;
  bool needs_depth = false;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("max_depth_m", self.max_depth_m, {0.1, 100.0}, "m", "key points farther away are left out");
    visit("needs_depth", self.needs_depth, "so are those without depth");
  }
};

class RangeFilter : public wardslam::filters::ObservationFilter {
  DEFINE_MRPT_OBJECT(RangeFilter, example)

 public:
  void initialize(const wardslam::core::ConfigNode& parameters, const wardslam::filters::FilterContext&) override {
    wardslam::core::readOptions(parameters, options_);
  }

  void apply(wardslam::core::Frame& frame) override {
    for (auto& keypoint : frame.features.keypoints) {
      const bool isFar = static_cast<double>(keypoint.depth_m) > options_.max_depth_m;
      const bool isUnknown = options_.needs_depth && !keypoint.hasDepth();
      if (isFar || isUnknown) keypoint.motion = wardslam::core::Motion::Dynamic;
    }
  }

  [[nodiscard]] std::string parameters(int indent) const override {
    return wardslam::core::writeOptions(options_, indent);
  }

 private:
  RangeFilterOptions options_;
};

IMPLEMENTS_MRPT_OBJECT(RangeFilter, wardslam::filters::ObservationFilter, example)

}  // namespace example

MRPT_INITIALIZER(registerRangeFilter) { mrpt::rtti::registerClass(CLASS_ID(example::RangeFilter)); }
