#include "bag_camera.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "inverse_lens.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

constexpr std::size_t kPlumbBob = 5;
constexpr const char* kRemedy =
    "; record the rectified images of image_proc (image_rect_color), or give --camera with a calibration of plumb_bob";

std::string baseName(const std::string& topic) {
  const std::string withoutTransport = topic.substr(0, topic.find("/compressed"));
  return withoutTransport.substr(withoutTransport.find_last_of('/') + 1);
}

/// RealSense writes "Brown Conrady", which is plumb bob, and "Inverse Brown Conrady".
std::string modelOf(const bags::CameraInfo& info) {
  std::string name = info.distortionModel;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(letter == ' ' ? '_' : std::tolower(letter)); });
  return name == "brown_conrady" ? "plumb_bob" : name;
}

void setInverse(const bags::CameraInfo& info, core::CameraModel& camera, const std::string& where) {
  constexpr double kTolerated_px = 0.5;
  std::array<double, kPlumbBob> inverse{};
  std::copy(info.d.begin(), info.d.end(), inverse.begin());
  if (const auto error_px = setInverseLens(camera, inverse); error_px && *error_px < kTolerated_px) return;
  throw core::InputError(where + ": its lens ('" + info.distortionModel + "') has no counterpart of plumb_bob" +
                         kRemedy);
}

void setDistortion(const bags::CameraInfo& info, core::CameraModel& camera, const std::string& where) {
  const auto isZero = [](double coefficient) { return coefficient == 0.0; };
  if (std::all_of(info.d.begin(), info.d.end(), isZero)) return;
  const std::string model = modelOf(info);
  if (model == "inverse_brown_conrady" && info.d.size() <= kPlumbBob) return setInverse(info, camera, where);
  const bool isPlumbBob = model == "plumb_bob" && info.d.size() <= kPlumbBob;
  // The rational model with k4, k5 and k6 zero is plumb bob.
  const bool isAlike = (model == "rational_polynomial" || model == "plumb_bob") && info.d.size() <= 8 &&
                       std::all_of(info.d.begin() + static_cast<std::ptrdiff_t>(std::min(kPlumbBob, info.d.size())),
                                   info.d.end(), isZero);
  if (!isPlumbBob && !isAlike) {
    throw core::InputError(where + ": its lens is described as '" + info.distortionModel + "' with " +
                           std::to_string(info.d.size()) + " coefficients, which is not read (plumb_bob is)" + kRemedy);
  }
  double* const coefficients[] = {&camera.k1, &camera.k2, &camera.p1, &camera.p2, &camera.k3};
  for (std::size_t i = 0; i < std::min(kPlumbBob, info.d.size()); ++i) *coefficients[i] = info.d[i];
}

void requireWholeImage(const bags::CameraInfo& info, const std::string& where) {
  const auto [x, y, height, width] = info.roi_px;
  const bool isPart =
      (x | y) != 0 || (height != 0 && height != info.height_px) || (width != 0 && width != info.width_px);
  if (info.binning_x > 1 || info.binning_y > 1 || isPart) {
    throw core::InputError(where +
                           ": says that images are binned or a part of what the camera sees, which is not read; "
                           "give --camera with the calibration of the images as they are");
  }
}

}  // namespace

bool isRectified(const std::string& imageTopic) { return baseName(imageTopic).find("rect") != std::string::npos; }

core::CameraModel cameraOf(const bags::CameraInfo& info, const std::string& imageTopic, const std::string& where) {
  requireWholeImage(info, where);
  core::CameraModel camera;
  camera.width_px = static_cast<int>(info.width_px);
  camera.height_px = static_cast<int>(info.height_px);
  const bool usesProjection = isRectified(imageTopic) && info.p[0] > 0.0;
  const auto* matrix = usesProjection ? info.p.data() : info.k.data();
  const std::size_t row = usesProjection ? 4 : 3;
  camera.fx_px = matrix[0];
  camera.cx_px = matrix[2];
  camera.fy_px = matrix[row + 1];
  camera.cy_px = matrix[row + 2];
  const bool isCalibrated = camera.fx_px > 0.0 && camera.fy_px > 0.0 && std::isfinite(camera.fx_px + camera.fy_px) &&
                            camera.cx_px > 0.0 && camera.cx_px < camera.width_px && camera.cy_px > 0.0 &&
                            camera.cy_px < camera.height_px;
  if (!isCalibrated) {
    throw core::InputError(where + ": its camera is not calibrated (focal lengths " + std::to_string(camera.fx_px) +
                           " and " + std::to_string(camera.fy_px) + ", principal point " +
                           std::to_string(camera.cx_px) + ", " + std::to_string(camera.cy_px) +
                           "); give --camera with its calibration");
  }
  if (!usesProjection) setDistortion(info, camera, where);
  return camera;
}

bool areAlike(const core::CameraModel& a, const core::CameraModel& b) {
  const auto isNear = [](double x, double y) { return std::abs(x - y) < 1.0; };
  return a.width_px == b.width_px && a.height_px == b.height_px && isNear(a.fx_px, b.fx_px) &&
         isNear(a.fy_px, b.fy_px) && isNear(a.cx_px, b.cx_px) && isNear(a.cy_px, b.cy_px);
}

}  // namespace wardslam::sources
