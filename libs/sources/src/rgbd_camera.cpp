#include "wardslam/sources/rgbd_camera.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <string_view>
#include <vector>

#include "camera_formats/camera_format.h"
#include "camera_formats/camera_values.h"
#include "wardslam/core/camera_limits.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/options.h"
#include "wardslam/core/text_lines.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;
using core::ConfigNode;

constexpr double kOddRatio = 1.1;   // of the focal lengths
constexpr double kOddCentre = 0.1;  // of the image's width or height
constexpr int kSmallest_px = 16;
constexpr double kLargestFocalLength_px = 1e5;
constexpr double kLargestCentre_px = 1e6;

/// YAML as OpenCV writes it, which the standard's parsers refuse: "%YAML:1.0", "key:value". Lines keep their numbers.
std::string standardYaml(const fs::path& file) {
  static const std::regex kNoBlank(R"(^(\s*[A-Za-z_][A-Za-z0-9_.]*):(?=[^\s:]))");
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  static_cast<void>(core::readTextLines(file));  // names UTF-16
  std::ifstream in(file);
  std::string text;
  for (std::string line; std::getline(in, line);) {
    if (line.compare(0, kMark.size(), kMark) == 0) line.erase(0, kMark.size());
    if (line.empty() || line.front() != '%') text += std::regex_replace(line, kNoBlank, "$1: ");
    text += "\n";
  }
  return text;
}

ConfigNode parse(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const int first = in.peek();
  if (in && first == '<') {
    throw core::InputError(file.string() +
                           ": is XML, of which no camera is read; write its numbers into a file of lines 'width: 640', "
                           "'height: 480', 'fx: …', 'fy: …', 'cx: …', 'cy: …', or have OpenCV write YAML");
  }
  if (!in) return ConfigNode::fromFile(file);  // says why not
  return ConfigNode::fromText(standardYaml(file), file);
}

void refuseNegativeFy(const ConfigNode& node) {
  const ConfigNode fy = node.child("fy");
  double value = 0.0;
  if (!fy.exists() || !YAML::convert<double>::decode(fy.yaml(), value) || value >= 0.0) return;
  std::ostringstream text;
  text << value << " is negative, as ICL-NUIM writes it for a y axis that points up; the images themselves have y "
       << "downwards, so write " << -value;
  fy.fail(text.str());
}

/// Without the other names of depth_factor, which depthFactorIn() knows.
ConfigNode withoutAliases(const ConfigNode& node) {
  YAML::Node kept = node.yaml();
  for (const char* alias : {"depth_scale", "png_depth_scale", "depth_map_factor"}) {
    if (!node.child(alias).exists()) continue;
    if (kept.is(node.yaml())) kept.reset(YAML::Clone(node.yaml()));  // loses the numbers of lines
    kept.remove(alias);
  }
  return {kept, node.file()};
}

RgbdCamera readOwn(const ConfigNode& root) {
  if (root.exists() && root.yaml().IsMap()) refuseNegativeFy(root);
  const ConfigNode node = root.exists() && root.yaml().IsMap() ? withoutAliases(root) : root;
  RgbdCamera camera;
  camera.depth_units_per_m = 1.0;   // within bounds, which 0 is not
  core::readOptions(node, camera);  // first, as a key may be missing because it is misspelt
  for (const char* key : {"width", "height", "fx", "fy", "cx", "cy"}) {
    if (!node.child(key).exists()) node.fail(std::string("the key '") + key + "' is missing from this camera file");
  }
  if (!node.child("depth_factor").exists()) camera.depth_units_per_m = 0.0;
  return camera;
}

std::string numbersText(const RgbdCamera& camera) {
  const core::CameraModel& c = camera.color;
  std::ostringstream text;
  if (c.width_px > 0) text << c.width_px << "x" << c.height_px << " pixels, ";
  text << "fx " << c.fx_px << ", fy " << c.fy_px << ", cx " << c.cx_px << ", cy " << c.cy_px;
  if (camera.depth_units_per_m > 0) text << ", depth of " << camera.depth_units_per_m << " units a metre";
  return text.str();
}

void requireSound(const core::CameraModel& camera, const ConfigNode& root) {
  const bool hasSize = camera.width_px != 0 || camera.height_px != 0;
  if (hasSize && std::min(camera.width_px, camera.height_px) < kSmallest_px) root.fail("tells no size of an image");
  for (const double focalLength_px : {camera.fx_px, camera.fy_px}) {
    if (!(focalLength_px >= 1.0 && focalLength_px <= kLargestFocalLength_px)) {
      root.fail("tells no focal length in pixels; calibrate the camera first");
    }
  }
  for (const double k : {camera.k1, camera.k2, camera.p1, camera.p2, camera.k3}) {
    if (!(std::abs(k) <= core::kStrongestLens)) root.fail("has a coefficient of the lens that no lens has");
  }
  for (const double centre_px : {camera.cx_px, camera.cy_px}) {
    if (!(std::abs(centre_px) <= kLargestCentre_px)) root.fail("has a principal point that no camera has");
  }
  const bool isInside = camera.cx_px >= -0.5 && camera.cx_px <= camera.width_px - 0.5 && camera.cy_px >= -0.5 &&
                        camera.cy_px <= camera.height_px - 0.5;
  if (!hasSize || isInside) return;
  std::ostringstream text;
  text << "the principal point (" << camera.cx_px << ", " << camera.cy_px << ") lies outside the image of "
       << camera.width_px << "x" << camera.height_px << " pixels; the numbers are those of another size (about "
       << std::lround(2 * camera.cx_px) << "x" << std::lround(2 * camera.cy_px)
       << "): give those of the images that were recorded";
  root.fail(text.str());
}

void tellWhatIsOdd(const core::CameraModel& camera, const fs::path& file,
                   const std::function<void(const std::string&)>& note) {
  std::ostringstream text;
  if (std::max(camera.fx_px, camera.fy_px) > kOddRatio * std::min(camera.fx_px, camera.fy_px)) {
    text << "fx (" << camera.fx_px << ") and fy (" << camera.fy_px << ") are more than 10 % apart";
  } else if (camera.width_px > 0 && (std::abs(camera.cx_px - 0.5 * camera.width_px) > kOddCentre * camera.width_px ||
                                     std::abs(camera.cy_px - 0.5 * camera.height_px) > kOddCentre * camera.height_px)) {
    text << "the principal point (" << camera.cx_px << ", " << camera.cy_px << ") is far from the middle of "
         << camera.width_px << "x" << camera.height_px << " pixels";
  }
  if (!text.str().empty()) {
    note(file.string() + ": " + text.str() + ", which is rare; is this the calibration of images of this size?");
  }
}

}  // namespace

RgbdCamera readRgbdCamera(const fs::path& file, const std::function<void(const std::string&)>& note) {
  const ConfigNode root = parse(file);
  std::optional<RgbdCamera> camera;
  std::string program;
  for (const CameraFormat& format : cameraFormats()) {
    if (!root.exists() || !(camera = format.read(root))) continue;
    program = format.program;
    break;
  }
  if (!camera) camera = readOwn(root);
  if (root.exists() && root.yaml().IsMap() && camera->depth_units_per_m == 0.0)
    camera->depth_units_per_m = depthFactorIn(root);
  requireSound(camera->color, root);
  if (!program.empty()) note(file.string() + ": is read as a calibration of " + program + ": " + numbersText(*camera));
  tellWhatIsOdd(camera->color, file, note);
  return *camera;
}

std::string listCameraFiles() {
  std::vector<std::string> files;
  try {
    for (const auto& entry : fs::directory_iterator(core::findDataFile("cameras"))) {
      if (entry.path().extension() == ".yaml") files.push_back(entry.path().lexically_normal().string());
    }
  } catch (const core::InputError&) {
    return "(the folder config/cameras was not found)";
  }
  std::sort(files.begin(), files.end());
  std::string list;
  for (const std::string& name : files) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace wardslam::sources
