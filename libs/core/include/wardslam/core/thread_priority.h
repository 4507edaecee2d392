#pragma once

namespace wardslam::core {

/// The calling thread gives way to others of this program from now on, more than it did: what maps may take longer,
/// what tracks may not. Nothing changes where the system has no priorities of threads.
void lowerThreadPriority();

}  // namespace wardslam::core
