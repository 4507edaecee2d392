#pragma once

#include <mrpt/maps/TMetricMapInitializer.h>

#include <string>
#include <vector>

#include "wardslam/core/options.h"
#include "wardslam/pipeline/slam_options.h"

namespace mrpt::config {
class CConfigFileBase;
}

namespace wardslam::mrpt_slam {

/// What a CMetricMapBuilderSemantic does besides SLAM.
struct MapBuilderOptions {
  std::string map;
  bool waits_for_map = true;
  std::string sensor_label;
  int points_px = 6;
  std::string images;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("map", self.map, "a .wardmap to go on in; empty = begin a new map");
    visit("waits_for_map", self.waits_for_map,
          "for the map to keep up, as recordings can; a robot leaves images out of it instead");
    visit("sensor_label", self.sensor_label, "of the RGB-D camera; empty = the first one that is seen");
    visit("points_px", self.points_px, {1, 64}, "px", "from one point to the next in the scans of the simple map");
    visit("images", self.images,
          "folder for the images of the scans of the simple map, without which it cannot be gone on in; empty = they "
          "have points alone");
  }
};

/// All that an .ini file says to a CMetricMapBuilderSemantic.
struct MapBuilderConfiguration {
  MapBuilderOptions builder;
  pipeline::SlamOptions slam;
  mrpt::maps::TSetOfMetricMapInitializers maps;  ///< Empty: a CSemanticMap.
};

/// From a section in the style of MRPT's, which also says which metric maps are wanted, and the section [WardSLAM]
/// (pipeline::readSlamOptions()), which may be missing:
///
///     [MappingApplication]
///     map = ward.wardmap                 ; any of MapBuilderOptions
///     CSemanticMap_count = 1             ; metric maps, each with its sections as MRPT has them
///     occupancyGrid_count = 1
///     [WardSLAM]
///     features.key_points = 800
///
/// `ofTheProgram`: keys of the section that are somebody else's. Throws core::InputError that names a wrong key and the
/// nearest right one.
[[nodiscard]] MapBuilderConfiguration readMapBuilderConfiguration(const mrpt::config::CConfigFileBase& ini,
                                                                  const std::string& section,
                                                                  const std::vector<std::string>& ofTheProgram = {});

}  // namespace wardslam::mrpt_slam
