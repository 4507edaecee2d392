#pragma once

#include <cstdint>
#include <optional>

#include "wardslam/core/options.h"
#include "wardslam/masks/contour_refiner.h"

namespace wardslam::masks {

/// Whose contours are refined, and how; part of the section `segmentation:` of the configuration.
struct ContourRefinementOptions {
  enum class Refine : std::uint8_t { Never, Networks, Always };

  Refine refine_contours = Refine::Networks;
  ContourOptions contours;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("refine_contours", self.refine_contours, {"never", "networks", "always"},
          "whose masks of moving things are moved to the edges in the depth image; recorded masks may be better than "
          "that");
    visit.group("contours", self.contours);
  }
};

/// For things of the classes given (bit i stands for class i); none where masks are to be used as they come.
[[nodiscard]] std::optional<ContourRefiner> makeContourRefiner(const ContourRefinementOptions& options,
                                                               bool isFromNetwork,
                                                               const ContourRefiner::ClassSet& classes);

}  // namespace wardslam::masks
