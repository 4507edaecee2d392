#include <sstream>

#include "camera_format.h"
#include "camera_values.h"

namespace wardslam::sources {
namespace {

/// All words of a text that holds nothing but numbers, parted by blanks, commas or lines.
std::vector<double> numbersOf(const core::ConfigNode& root) {
  std::string text = root.yaml().Scalar();
  for (char& letter : text) letter = letter == ',' || letter == ';' ? ' ' : letter;
  std::istringstream words(text);
  std::vector<double> numbers;
  for (double number = 0.0; words >> number;) numbers.push_back(number);
  return words.eof() ? numbers : std::vector<double>();
}

/// Rows of `columns` numbers that are a camera matrix, with zeros and ones where it has them.
bool isMatrix(const std::vector<double>& m, std::size_t columns) {
  return m[1] == 0.0 && m[columns] == 0.0 && m[2 * columns] == 0.0 && m[2 * columns + 1] == 0.0 &&
         m[2 * columns + 2] == 1.0;
}

}  // namespace

/// Numbers alone: "fx fy cx cy" of ETH3D's calibration.txt, or a matrix of three rows (Redwood, 7-Scenes) or four
/// (ScanNet). They tell neither size nor unit of depth.
std::optional<RgbdCamera> readNumberCamera(const core::ConfigNode& root) {
  if (!root.yaml().IsScalar()) return std::nullopt;
  const std::vector<double> numbers = numbersOf(root);
  const std::size_t columns = numbers.size() == 16 ? 4 : 3;
  RgbdCamera camera;
  core::CameraModel& model = camera.color;
  model.width_px = model.height_px = 0;
  if (numbers.size() == 4) {
    model.fx_px = numbers[0];
    model.fy_px = numbers[1];
    model.cx_px = numbers[2];
    model.cy_px = numbers[3];
  } else if ((numbers.size() == 9 || numbers.size() == 16) && isMatrix(numbers, columns)) {
    model.fx_px = numbers[0];
    model.cx_px = numbers[2];
    model.fy_px = numbers[columns + 1];
    model.cy_px = numbers[columns + 2];
  } else if (numbers.size() > 1) {
    root.fail("holds " + std::to_string(numbers.size()) +
              " numbers alone, which are neither 'fx fy cx cy' nor a camera matrix; write 'fx: …', 'fy: …', 'cx: …', "
              "'cy: …' and what else is known (width, height, k1, k2, p1, p2, k3), one a line");
  } else {
    return std::nullopt;
  }
  camera.depth_units_per_m = 0.0;
  return camera;
}

}  // namespace wardslam::sources
