#include "camera_values.h"

#include <algorithm>
#include <cmath>

#include "wardslam/core/image_header.h"

namespace wardslam::sources {
namespace {

using core::ConfigNode;

double numberIn(const ConfigNode& node) {
  double number = 0.0;
  if (!node.yaml().IsScalar() || !YAML::convert<double>::decode(node.yaml(), number) || !std::isfinite(number)) {
    node.fail("a number is expected here");
  }
  return number;
}

}  // namespace

double numberAt(const ConfigNode& node, const std::string& key) {
  const ConfigNode value = node.child(key);
  if (!value.exists()) node.fail("the key '" + key + "' is missing from this camera file");
  return numberIn(value);
}

double numberAt(const ConfigNode& node, const std::string& key, double otherwise) {
  const ConfigNode value = node.child(key);
  return value.exists() ? numberIn(value) : otherwise;
}

int pixelsIn(double number, const ConfigNode& where) {
  if (!(number >= 0.0 && number <= core::kLargestImage_px)) {
    where.fail("a width or height of at most " + std::to_string(core::kLargestImage_px) + " pixels is expected here");
  }
  return static_cast<int>(number);
}

int pixelsAt(const ConfigNode& node, const std::string& key) { return pixelsIn(numberAt(node, key), node.child(key)); }

std::vector<double> numbersAt(const ConfigNode& list, std::size_t least) {
  std::vector<double> numbers;
  if (list.exists() && list.yaml().IsSequence()) {
    for (std::size_t i = 0; i < list.yaml().size(); ++i) {
      const ConfigNode item = list.item(i);
      const bool isRow = item.yaml().IsSequence();  // of a matrix
      for (std::size_t j = 0; isRow && j < item.yaml().size(); ++j) numbers.push_back(numberIn(item.item(j)));
      if (!isRow) numbers.push_back(numberIn(item));
    }
  }
  if (numbers.size() < least) list.fail("a list of " + std::to_string(least) + " numbers is expected here");
  return numbers;
}

ConfigNode firstChild(const ConfigNode& node, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    if (auto child = node.child(key); child.exists()) return child;
  }
  return {YAML::Node(), node.file(), *keys.begin()};
}

void setMatrix(core::CameraModel& camera, const std::vector<double>& matrix) {
  // Row by row the third row begins with zeros; some write it column by column (Record3D, Eigen).
  const bool isByColumns = matrix[2] == 0.0 && matrix[5] == 0.0 && matrix[6] != 0.0;
  camera.fx_px = matrix[0];
  camera.cx_px = matrix[isByColumns ? 6 : 2];
  camera.fy_px = matrix[4];
  camera.cy_px = matrix[isByColumns ? 7 : 5];
}

void setPlumbBob(core::CameraModel& camera, const std::vector<double>& coefficients, const ConfigNode& where) {
  constexpr std::size_t kKnown = 5;
  for (std::size_t i = kKnown; i < coefficients.size(); ++i) {
    if (coefficients[i] == 0.0) continue;
    where.fail(
        "a lens of more than five coefficients (rational or thin-prism model) cannot be read; calibrate with "
        "plumb_bob (k1 k2 p1 p2 k3), or rectify the images and write zeros");
  }
  const auto at = [&](std::size_t i) { return i < coefficients.size() ? coefficients[i] : 0.0; };
  camera.k1 = at(0);
  camera.k2 = at(1);
  camera.p1 = at(2);
  camera.p2 = at(3);
  camera.k3 = at(4);
}

void requirePlumbBob(const ConfigNode& model) {
  if (!model.exists() || !model.yaml().IsScalar()) return;
  std::string name = model.yaml().Scalar();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  // Rational models are told by their further coefficients: many files name one and use the first five alone.
  for (const char* known : {"", "plumb_bob", "radtan", "pinhole", "perspective", "none", "brown-conrady",
                            "brown_conrady", "rational_polynomial", "rectified"}) {
    if (name == known) return;
  }
  model.fail(
      "'" + model.yaml().Scalar() +
      "' is a lens model that cannot be read (fisheye and wide lenses); rectify the images and give the camera of "
      "the rectified ones");
}

double depthFactorIn(const ConfigNode& root) {
  static const std::initializer_list<const char*> kNames = {"depth_factor",     "DepthMapFactor", "RGBD.DepthMapFactor",
                                                            "depthmap_factor",  "depth_scale",    "png_depth_scale",
                                                            "depth_map_factor", "depthScale"};
  ConfigNode value = firstChild(root, kNames);
  for (const char* section : {"Preprocessing", "Camera", "Mapping", "Tracking", "cam", "cam0"}) {
    const ConfigNode inner = root.child(section);
    if (!value.exists() && inner.exists() && inner.yaml().IsMap()) value = firstChild(inner, kNames);
  }
  if (!value.exists()) return 0.0;
  const double number = numberIn(value);
  if (!(number > 0.0) || number > 1e6) value.fail("units of depth per metre are expected here, such as 5000 or 1000");
  return number < 1.0 ? 1.0 / number : number;
}

void setPinhole(core::CameraModel& camera, const core::ConfigNode& section) {
  camera.fx_px = numberAt(section, "fx");
  camera.fy_px = numberAt(section, "fy");
  camera.cx_px = numberAt(section, "cx");
  camera.cy_px = numberAt(section, "cy");
}

}  // namespace wardslam::sources
