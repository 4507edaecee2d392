#pragma once

#include "people/anatomy.h"
#include "people/look.h"

/// How a figure is dressed; used by poseFigure() only.
namespace wardslam::synth::figure {

/// All but the skirt.
[[nodiscard]] anatomy::Parts makeParts(const Look& look);
/// What of a tunic, coat or gown hangs below the hips, over thighs that are raised by these angles.
[[nodiscard]] Mesh makeSkirtOfGarment(const Look& look, double left_rad, double right_rad);

}  // namespace wardslam::synth::figure
