#pragma once

#include "wardslam/sources/live_options.h"
#include "wardslam/sources/stereo_options.h"

namespace wardslam::sources {

/// Section `sources:` of the configuration.
struct SourceSettings {
  LiveOptions live;
  StereoOptions stereo;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit.group("live", self.live);
    visit.group("stereo", self.stereo);
  }
};

}  // namespace wardslam::sources
