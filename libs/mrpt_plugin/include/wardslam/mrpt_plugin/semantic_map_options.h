#pragma once

#include <mrpt/config/CLoadableOptions.h>

#include <string>

#include "wardslam/core/options.h"
#include "wardslam/exchange/map_drawing.h"
#include "wardslam/mapping/mapping_options.h"

/// Options of a CSemanticMap. Each is a section of an .ini file, in which a wrong key is an error that names it and the
/// nearest right one.
namespace wardslam::mrpt_plugin {

/// Reads one of the options below from a section of an .ini file, and tells of them as MRPT's options do.
/// loadFromConfigFile() throws core::InputError.
template <class Options>
struct IniOptions : mrpt::config::CLoadableOptions {
  void loadFromConfigFile(const mrpt::config::CConfigFileBase& source, const std::string& section) override;
  void saveToConfigFile(mrpt::config::CConfigFileBase& target, const std::string& section) const override;
  void dumpToTextStream(std::ostream& out) const override;
};

/// `<map>_insertOpts`: the keys of the section `mapping:` of the configuration, by their paths (`cloud.voxel_m =
/// 0.05`).
struct SemanticInsertionOptions : IniOptions<SemanticInsertionOptions> {
  std::string knowledge = "knowledge/hospital.yaml";
  std::string classes;
  mapping::ViewOptions views{0.0, 0.0, 0.0};  ///< All that is inserted.
  mapping::CloudOptions cloud;
  mapping::ObjectOptions objects;
  mapping::FloorPlanOptions floor_plan;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("knowledge", self.knowledge, "who can move what; a file, or one of the installed configuration");
    visit("classes", self.classes, "names of class ids, beside those the observations bring; empty = COCO's");
    visit.group("views", self.views);
    visit.group("cloud", self.cloud);
    visit.group("objects", self.objects);
    visit.group("floor_plan", self.floor_plan);
  }
};

/// `<map>_likelihoodOpts`. The model: of what does not move, about `pixels` points are taken, evenly over the image: of
/// a CObservation3DRangeScan from its depth, of a CObservationSemanticRGBD its key points, with their classes. One that
/// the pose puts d away from the nearest point of the cloud counts
///
///     log((1 - other) * same * exp(-d² / 2 sigma²) + other),
///
/// where `same` is `class_mismatch` if both have a class and the classes differ, else 1. The sum is weighed down to as
/// many independent measurements as `independent` says, since what neighbouring pixels see goes wrong together.
struct SemanticLikelihoodOptions : IniOptions<SemanticLikelihoodOptions> {
  int pixels = 300;
  double sigma_m = 0.1;
  double other = 0.05;
  double class_mismatch = 0.3;
  double independent = 20.0;
  double max_range_m = 6.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("pixels", self.pixels, {10, 100000}, "count", "pixels of a scan that are compared with the map");
    visit("sigma_m", self.sigma_m, {0.005, 2.0}, "m", "how far a point lies from the map where all is well");
    visit("other", self.other, {0.0001, 0.9999}, "", "share of pixels that show what is not in the map");
    visit("class_mismatch", self.class_mismatch, {0.0, 1.0}, "", "what a point of another class counts");
    visit("independent", self.independent, {0.1, 100000.0}, "count", "independent measurements in a scan");
    visit("max_range_m", self.max_range_m, {0.5, 50.0}, "m", "depth beyond is not used");
  }
};

/// `<map>_renderOpts`
struct SemanticRenderOptions : IniOptions<SemanticRenderOptions> {
  exchange::CloudColor color = exchange::CloudColor::Image;
  bool boxes = true;
  bool names = true;
  double point_size_px = 2.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("color", self.color, {"image", "class"}, "of the points: as the camera saw them, or that of their class");
    visit("boxes", self.boxes, "around the things that stand there");
    visit("names", self.names, "at the things that stand there");
    visit("point_size_px", self.point_size_px, {1.0, 20.0}, "px", "");
  }
};

}  // namespace wardslam::mrpt_plugin
