#pragma once

#include <cstdint>
#include <map>

#include "wardslam/core/options.h"
#include "wardslam/core/segmentation.h"

namespace wardslam::masks {

struct InstanceTrackerOptions {
  double bridge_s = 0.5;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("bridge_s", self.bridge_s, {0.0, 60.0}, "s",
          "what the segmenter misses stays for so long, though no longer than it was seen before; 0 = not at all");
  }
};

/// Keeps the identity of instances from one segmented picture to the next, and keeps for a while what the segmenter
/// misses:
///
///     result = tracker.update(detected, carried, stamp_s);   // carried: the last result, brought to this picture
///
/// A detection takes over the id of the carried instance of its class that it overlaps best; the others get ids not
/// used lately. A carried instance that is not detected anew stays, with the pixels no detection has, as long as its
/// time lasts and half of it is left; within that time its confidence falls to a quarter.
class InstanceTracker {
 public:
  explicit InstanceTracker(const InstanceTrackerOptions& options) : options_(options) {}

  /// Both are about one picture; either may be empty. Detections without instances are told apart by region.
  /// `carried`: ids as update() gave them. Empty when the segmenter
  /// brought nothing and nothing is kept. Shares no pixels with its arguments.
  [[nodiscard]] core::Segmentation update(const core::Segmentation& detected, const core::Segmentation& carried,
                                          double stamp_s);

 private:
  /// The life of an instance as detections show it.
  struct Track {
    double firstSeen_s = 0.0;
    double lastSeen_s = 0.0;
    float confidence = 0.0F;  ///< When last seen.
  };

  void identify(core::Segmentation& detected, const core::Segmentation& carried, double stamp_s);
  void keepMissed(const core::Segmentation& carried, double stamp_s, core::Segmentation& result) const;
  [[nodiscard]] double patienceFor_s(const Track& track) const;
  [[nodiscard]] std::uint16_t newId();
  void forgetAbsent(const core::Segmentation& present);

  InstanceTrackerOptions options_;
  std::map<std::uint16_t, Track> tracks_;  ///< Of the instances in the last result.
  std::uint16_t lastId_ = 0;
};

}  // namespace wardslam::masks
