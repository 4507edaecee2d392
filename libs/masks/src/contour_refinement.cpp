#include "wardslam/masks/contour_refinement.h"

namespace wardslam::masks {

std::optional<ContourRefiner> makeContourRefiner(const ContourRefinementOptions& options, bool isFromNetwork,
                                                 const ContourRefiner::ClassSet& classes) {
  using Refine = ContourRefinementOptions::Refine;
  const bool isWanted =
      options.refine_contours == Refine::Always || (options.refine_contours == Refine::Networks && isFromNetwork);
  if (!isWanted) return std::nullopt;
  return ContourRefiner(options.contours, classes);
}

}  // namespace wardslam::masks
