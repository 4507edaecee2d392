#include "wardslam/core/thread_priority.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace wardslam::core {

void lowerThreadPriority() {
#ifdef __linux__
  constexpr int kNice = 10;  // a tenth of the share of another thread
  static_cast<void>(setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice));  // of this thread alone
#endif
}

}  // namespace wardslam::core
