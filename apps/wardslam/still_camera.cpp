#include "still_camera.h"

#include <iomanip>
#include <sstream>
#include <utility>

namespace wardslam::apps {
namespace {

/// Longer than drivers repeat an image that is late.
constexpr double kFrozen_s = 1.0;

std::string at(double stamp_s) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << stamp_s << " s";
  return text.str();
}

}  // namespace

void StillCamera::onFrame(const core::Frame& frame, const odometry::OdometryResult& /*odometry*/) {
  if (frame.events.count("sources.depth_still") > 0 && !std::exchange(toldOfDepth_, true)) {
    tell_("depth has stood still since before " + at(frame.stamp_s) +
          " while the colours went on; it is not used until it goes on (is the depth sensor at fault?)");
  }
  if (frame.index == 0 || frame.events.count("sources.image_repeated") == 0) {
    lastChange_s_ = frame.stamp_s;
    return;
  }
  if (frame.stamp_s - lastChange_s_ >= kFrozen_s && !std::exchange(toldOfImage_, true)) {
    tell_("the camera delivers one and the same image since " + at(lastChange_s_) +
          ", as no camera does; until that ends the pose is where it was then");
  }
}

}  // namespace wardslam::apps
