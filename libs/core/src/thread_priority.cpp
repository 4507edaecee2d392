#include "wardslam/core/thread_priority.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace wardslam::core {

void lowerThreadPriority() {
#ifdef __linux__
  constexpr int kNicer = 10;  // a tenth of the share of another thread
  const auto thisThread = static_cast<id_t>(gettid());
  static_cast<void>(setpriority(PRIO_PROCESS, thisThread, getpriority(PRIO_PROCESS, thisThread) + kNicer));
#endif
}

}  // namespace wardslam::core
