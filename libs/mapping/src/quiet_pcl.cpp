#include "quiet_pcl.h"

#include <pcl/console/print.h>

#include <mutex>

namespace wardslam::mapping {
namespace {

/// The first that begins silences PCL, the last that ends gives back what was set before.
struct Silence {
  std::mutex mutex;
  int count = 0;
  pcl::console::VERBOSITY_LEVEL before = pcl::console::L_INFO;
};

Silence& silence() {
  static Silence one;  // as PCL's setting is
  return one;
}

}  // namespace

QuietPcl::QuietPcl() {
  const std::lock_guard lock(silence().mutex);
  if (silence().count++ > 0) return;
  silence().before = pcl::console::getVerbosityLevel();
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
}

QuietPcl::~QuietPcl() {
  const std::lock_guard lock(silence().mutex);
  if (--silence().count == 0) pcl::console::setVerbosityLevel(silence().before);
}

}  // namespace wardslam::mapping
