#pragma once

namespace wardslam::mapping {

/// What ground does that one can drive on: rise or fall by so much per metre (ramps for wheelchairs and beds have at
/// most 1:8), and lie by so much beside where it is, for noise and thresholds.
constexpr double kSteepest = 0.15;
constexpr double kGroundNoise_m = 0.03;

}  // namespace wardslam::mapping
