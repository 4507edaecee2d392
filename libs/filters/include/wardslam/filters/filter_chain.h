#pragma once

#include <string>
#include <vector>

#include "wardslam/filters/observation_filter.h"

namespace wardslam::filters {

/// The filters every frame passes, in order, as the configuration lists them:
///
///     filters:
///       - class_name: wardslam::filters::SemanticDynamicFilter
///         params: {n: 21, delta: 55}
///       - class_name: my_project::MyFilter
///         plugin: libmy_filters.so            # loaded first; a relative path starts at the configuration file
class FilterChain {
 public:
  /// No filter: everything stays static.
  FilterChain() = default;

  /// `list`: the value of `filters:`. Throws core::InputError naming file and line: unknown key, a class name nobody
  /// registered (with the nearest that is), a plug-in that cannot be loaded, parameters the filter refuses.
  FilterChain(const core::ConfigNode& list, const FilterContext& context);

  /// Before key points are extracted: lets every filter start its work on the images. Does not block.
  void begin(const core::Frame& frame);

  /// After key points are extracted: every filter marks the frame.
  void apply(core::Frame& frame);

  /// After tracking: tells every filter where the camera was.
  void end(const core::Frame& frame, const std::optional<Eigen::Isometry3d>& T_map_cam);

  [[nodiscard]] bool empty() const { return links_.empty(); }
  [[nodiscard]] std::size_t size() const { return links_.size(); }

  /// The list as YAML with every parameter in effect, `indent` steps of two blanks in.
  [[nodiscard]] std::string parameters(int indent) const;

 private:
  struct Link {
    std::string plugin;  ///< As in the configuration; empty = none.
    ObservationFilter::Ptr filter;
  };

  std::vector<Link> links_;
};

}  // namespace wardslam::filters
