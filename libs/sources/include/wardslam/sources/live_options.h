#pragma once

namespace wardslam::sources {

/// Section `sources.live:` of the configuration.
struct LiveOptions {
  double open_timeout_s = 10.0;
  double silence_timeout_s = 2.0;
  double first_pause_s = 0.5;
  double longest_pause_s = 8.0;
  int max_attempts = 30;
  int max_waiting_frames = 1;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("open_timeout", self.open_timeout_s, {0.1, 120.0}, "s", "how long a camera may take to its first image");
    visit("silence_timeout", self.silence_timeout_s, {0.1, 60.0}, "s",
          "a camera without images for so long is closed and opened again");
    visit("first_pause", self.first_pause_s, {0.0, 60.0}, "s", "before opening again; doubles with every failure …");
    visit("longest_pause", self.longest_pause_s, {0.0, 600.0}, "s", "… up to this");
    visit("max_attempts", self.max_attempts, {0, 1000000}, "count",
          "the run ends when a camera that was lost cannot be opened so many times in a row");
    visit("max_waiting_frames", self.max_waiting_frames, {1, 30}, "count",
          "images that may wait for tracking; beyond that the oldest are skipped");
  }
};

}  // namespace wardslam::sources
