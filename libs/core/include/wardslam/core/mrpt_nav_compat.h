#pragma once

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::core {

/// How mrpt::nav::CHolonomicFullEval is to weigh what speaks for a direction, as it reads it from its section. It
/// refuses any other number of weights than it knows factors: seven in MRPT 2.5 (Debian 12), eight in 2.14 (Debian 13).
/// Only those count that PHASE1_FACTORS names.
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
