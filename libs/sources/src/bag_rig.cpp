#include "bag_rig.h"

#include <algorithm>

#include "bag_camera.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

constexpr const char* kRemedy =
    "; record depth that is registered to colour (realsense2_camera: align_depth, its topic aligned_depth_to_color; "
    "openni2: depth_registration), or record /tf_static, too";

/// What RealSense's own recorder calls all of them, and what drivers leave empty, names no frame.
bool isNamed(const std::string& frame) { return !frame.empty() && frame != "0"; }

bool isIdentity(const Eigen::Isometry3d& T) {
  return T.translation().norm() < 1e-6 && Eigen::AngleAxisd(T.linear()).angle() < 1e-6;
}

/// What was recorded of a camera whose calibration is replaced, to compare with; it need not be sound.
core::CameraModel rawCameraOf(const bags::CameraInfo& info) {
  core::CameraModel camera;
  camera.width_px = static_cast<int>(info.width_px);
  camera.height_px = static_cast<int>(info.height_px);
  camera.fx_px = info.k[0];
  camera.cx_px = info.k[2];
  camera.fy_px = info.k[4];
  camera.cy_px = info.k[5];
  return camera;
}

class RigMaker {
 public:
  RigMaker(const BagSurvey& survey, const std::string& depthTopic, const std::string& file)
      : survey_(survey), depthTopic_(depthTopic), file_(file) {}

  void placeDepth(BagRig& rig, const core::CameraModel& recordedColor) const {
    rig.depth = rig.color;
    const bool isOneFrame = isNamed(survey_.colorFrame) && survey_.colorFrame == survey_.depthFrame;
    if (isRegisteredByName(depthTopic_)) return;
    if (!survey_.depthInfo) {
      if (isOneFrame) return;
      fail("has no calibration (camera_info) beside it, and its frame '" + survey_.depthFrame +
           "' is not that of colour, '" + survey_.colorFrame + "'");
    }
    const core::CameraModel depth = cameraOf(*survey_.depthInfo, depthTopic_, file_ + ": " + depthTopic_);
    const bool isAlike = areAlike(depth, recordedColor);
    if (isOneFrame && isAlike) return;
    const auto T_depth_color = T_between(isOneFrame);
    if (isAlike && T_depth_color && isIdentity(*T_depth_color)) return;
    if (!T_depth_color && isAlike) {
      rig.assumed += "; depth is taken for registered to colour, as both have one calibration";
      return;
    }
    if (!T_depth_color) {
      fail("was seen by another camera than colour (their calibrations differ), and no transform leads from '" +
           survey_.depthFrame + "' to '" + survey_.colorFrame + "'");
    }
    rig.depth = depth;
    rig.T_depth_color = T_depth_color;
    rig.assumed += std::string("; depth is registered here, by ") +
                   (isOneFrame ? "its own calibration" : "the transforms recorded");
  }

  void placeCamera(BagRig& rig) const {
    std::optional<std::string> base;
    if (!survey_.robotFrame.empty()) base = survey_.transforms.ancestor(survey_.colorFrame, {survey_.robotFrame});
    if (!base) base = survey_.transforms.ancestor(survey_.colorFrame, {"base_link", "base_footprint"});
    if (!base) {
      rig.assumed += "; no transform leads to a robot (base_link), so the camera is taken for one";
      return;
    }
    if (const auto joint = survey_.transforms.changing(*base, survey_.colorFrame)) {
      rig.assumed += "; the camera moves on the robot ('" + *joint + "' does below '" + *base +
                     "'), so it is taken for one itself";
      return;
    }
    rig.T_base_color = survey_.transforms.T(*base, survey_.colorFrame);
    rig.baseFrame = *base;
    rig.assumed += "; the camera sits where the transforms from '" + *base + "' to '" + survey_.colorFrame + "' say";
  }

 private:
  [[nodiscard]] std::optional<Eigen::Isometry3d> T_between(bool isOneFrame) const {
    if (isOneFrame) return Eigen::Isometry3d::Identity();
    if (!isNamed(survey_.depthFrame) || !isNamed(survey_.colorFrame)) return std::nullopt;
    return survey_.transforms.T(survey_.depthFrame, survey_.colorFrame);
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw core::InputError(file_ + ": the depth of " + depthTopic_ + " " + why + kRemedy);
  }

  const BagSurvey& survey_;
  const std::string& depthTopic_;
  const std::string& file_;
};

}  // namespace

BagRig rigOf(const BagSurvey& survey, const std::string& colorTopic, const std::string& depthTopic,
             const std::optional<core::CameraModel>& given, const std::string& file) {
  if (!given && !survey.colorInfo) {
    throw core::InputError(file + ": no message of the calibration can be read; give --camera");
  }
  const auto recorded = [&] { return cameraOf(*survey.colorInfo, colorTopic, file + ": " + colorTopic); };
  BagRig rig;
  rig.color = given ? *given : recorded();
  const RigMaker maker(survey, depthTopic, file);
  maker.placeDepth(rig, given && survey.colorInfo ? rawCameraOf(*survey.colorInfo) : rig.color);
  maker.placeCamera(rig);
  if (survey.infoChanges) rig.assumed += "; the calibration changes in the recording, and the first is used for all";
  if (survey.hasNoStamps) rig.assumed += "; images have no stamps, so when they were recorded is taken";
  return rig;
}

}  // namespace wardslam::sources
