#pragma once

/// What no camera has: a file that says so is damaged or of something else, and reckoning with it could take for ever.
namespace wardslam::core {

inline constexpr double kLongestFocus_px = 1e6;
inline constexpr double kStrongestLens = 1e4;       ///< Of any coefficient of distortion.
inline constexpr double kLongestBaseline_m = 10.0;  ///< Between the cameras of a stereo pair.

}  // namespace wardslam::core
