#pragma once

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::core {

/// The weights that mrpt::nav::CHolonomicFullEval wants, as it reads them: it refuses any other number of them. The
/// last of eight, new in MRPT TODO, is TODO.
#if MRPT_VERSION >= WARDSLAM_MRPT_VERSION(2, 14, 0)
inline constexpr const char* kFullEvalFactors = R"(factorWeights = [0.25, 0.1, 1, 0.05, 0.5, 1, 1, 0]
factorNormalizeOrNot = [0, 0, 0, 0, 1, 1, 0, 0]
)";
#else
inline constexpr const char* kFullEvalFactors = R"(factorWeights = [0.25, 0.1, 1, 0.05, 0.5, 1, 1]
factorNormalizeOrNot = [0, 0, 0, 0, 1, 1, 0]
)";
#endif

}  // namespace wardslam::core
