#pragma once

namespace wardslam::core {

/// The calling thread gives way to others from now on: what maps may take longer, what tracks may not. Nothing changes
/// where the system has no priorities of threads.
void lowerThreadPriority();

}  // namespace wardslam::core
