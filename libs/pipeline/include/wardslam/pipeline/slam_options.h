#pragma once

#include <filesystem>
#include <string>

#include "wardslam/core/options.h"
#include "wardslam/features/orb_extractor.h"
#include "wardslam/filters/filter_chain.h"
#include "wardslam/graph/graph_options.h"
#include "wardslam/mapping/mapping_options.h"
#include "wardslam/masks/contour_refinement.h"
#include "wardslam/odometry/odometry_options.h"
#include "wardslam/odometry/smoothing_options.h"
#include "wardslam/pipeline/start_pose.h"
#include "wardslam/segmentation/segmenter_factory.h"
#include "wardslam/sources/source_settings.h"

namespace wardslam::pipeline {

/// Section `knowledge:` of the configuration.
struct KnowledgeOptions {
  std::string file = "knowledge/hospital.yaml";

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("file", self.file, "who can move what; relative to this file or to the installed configuration");
  }
};

/// Section `zones:` of the configuration.
struct ZoneOptions {
  std::string file;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("file", self.file, "named parts of the floor, in the map frame; relative to this file; empty = none");
  }
};

/// Section `segmentation:` of the configuration: where masks come from, and how their contours are mended.
struct SegmentationSection : segmentation::SegmentationOptions {
  masks::ContourRefinementOptions refinement;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    segmentation::SegmentationOptions::describe(self, visit);
    masks::ContourRefinementOptions::describe(self.refinement, visit);
  }
};

/// The whole configuration of a SlamSystem: one section per room.
struct SlamOptions {
  bool deterministic = false;
  bool annotate = true;
  sources::SourceSettings sources;
  features::OrbOptions features;
  SegmentationSection segmentation;
  KnowledgeOptions knowledge;
  ZoneOptions zones;
  core::ConfigNode filters = defaultFilters();  ///< List of {class_name, params}; see filters::FilterChain.
  MapFrameOptions map_frame;
  odometry::OdometryOptions odometry;
  odometry::SmoothingOptions trajectory;
  graph::GraphOptions graph;
  mapping::MappingOptions mapping;

  std::filesystem::path file;  ///< Where it was read from; empty for the defaults.

  /// The semantic dynamic filter and, behind it, the geometric motion filter, with their defaults.
  [[nodiscard]] static core::ConfigNode defaultFilters();
  [[nodiscard]] static core::ConfigNode noFilters();

  /// Overrules a parameter of the filters of this class, in `filters` itself. False: there is no such filter.
  [[nodiscard]] bool setFilterParameter(const std::string& className, const std::string& key, const std::string& value);

  /// Leaves only the filters of this class, as configured; where there is none, one with its defaults.
  void keepOnlyFilters(const std::string& className);

  /// Leaves out the filters of this class.
  void removeFilters(const std::string& className);

  /// Whether there are masks to be had. The network that comes with the program, which is the default, only works where
  /// the semantic dynamic filter is there to make use of it.
  [[nodiscard]] bool segments() const;

  /// Everything but the filters, whose parameters only they themselves know.
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("deterministic", self.deterministic, "same input, same bytes out; tracking then waits for adjustments");
    visit("annotate", self.annotate,
          "write what filters found into pixelLabels and confidenceImage of the observation");
    visit.group("sources", self.sources);
    visit.group("features", self.features);
    visit.group("segmentation", self.segmentation);
    visit.group("knowledge", self.knowledge);
    visit.group("zones", self.zones);
    visit.group("map_frame", self.map_frame);
    visit.group("odometry", self.odometry);
    visit.group("trajectory", self.trajectory);
    visit.group("graph", self.graph);
    visit.group("mapping", self.mapping);
  }
};

/// Defaults, overwritten by what the file says. Throws core::InputError naming file, line and key.
[[nodiscard]] SlamOptions readSlamOptions(const std::filesystem::path& file);

/// The same from a configuration that is read already, as if it stood in `root.file()`.
[[nodiscard]] SlamOptions readSlamOptions(const core::ConfigNode& root);

/// The same YAML with files by their names alone: nothing of the computer it was written on, and enough to tell which
/// network and masks they were.
[[nodiscard]] std::string withoutFolders(const std::string& yaml);

/// All options as commented YAML that readSlamOptions() takes. The chain knows the parameters of `options.filters`.
[[nodiscard]] std::string writeSlamOptions(const SlamOptions& options, const filters::FilterChain& chain);

}  // namespace wardslam::pipeline
