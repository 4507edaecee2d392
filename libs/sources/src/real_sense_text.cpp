#include "real_sense_text.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <vector>

#include "wardslam/bags/bag_damage.h"
#include "wardslam/core/rigid_transform.h"

namespace wardslam::sources {
namespace {

constexpr double kLargestImage_px = 65536.0;

[[noreturn]] void fail(const std::string& text) {
  throw bags::BagDamage("sources.message_unreadable", "is a text that tells something else: " + text.substr(0, 60));
}

std::vector<std::string> parts(const std::string& text, char separator) {
  std::vector<std::string> found;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) found.push_back(part);
  return found;
}

/// The values of one text by their keys.
class Values {
 public:
  explicit Values(const std::string& text) : text_(text) {
    for (const std::string& part : parts(text, ';')) {
      if (const std::size_t sign = part.find('='); sign != std::string::npos) {
        values_.emplace(part.substr(0, sign), part.substr(sign + 1));
      }
    }
  }

  [[nodiscard]] const std::string& at(const std::string& key) const {
    const auto value = values_.find(key);
    if (value == values_.end()) fail(text_);
    return value->second;
  }

  [[nodiscard]] double number(const std::string& key) const { return realSenseNumber(at(key)); }

  [[nodiscard]] std::vector<double> numbers(const std::string& key) const {
    std::vector<double> found;
    for (const std::string& part : parts(at(key), ',')) found.push_back(realSenseNumber(part));
    return found;
  }

  [[nodiscard]] std::uint32_t size_px(const std::string& key) const {
    const double size = number(key);
    if (!(size >= 1.0 && size <= kLargestImage_px)) fail(text_);
    return static_cast<std::uint32_t>(size);
  }

 private:
  const std::string& text_;
  std::map<std::string, std::string> values_;
};

}  // namespace

bags::CameraInfo realSenseCamera(const std::string& text) {
  const Values values(text);
  bags::CameraInfo info;
  info.width_px = values.size_px("width");
  info.height_px = values.size_px("height");
  info.k = {values.number("fx"), 0, values.number("ppx"), 0, values.number("fy"), values.number("ppy"), 0, 0, 1};
  info.distortionModel = values.at("model");
  info.d = values.numbers("coeffs");
  return info;
}

Eigen::Isometry3d realSensePlace(const std::string& text) {
  constexpr double kTolerated = 0.01;  // six digits are written
  const Values values(text);
  const std::vector<double> rotation = values.numbers("rotation");
  const std::vector<double> translation_m = values.numbers("translation");
  if (rotation.size() != 9 || translation_m.size() != 3) fail(text);
  const Eigen::Matrix3d R = Eigen::Map<const Eigen::Matrix3d>(rotation.data());
  if (!core::isRotation(R, kTolerated)) fail(text);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
  T.translation() = Eigen::Map<const Eigen::Vector3d>(translation_m.data());
  return T;
}

double realSenseNumber(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != '\0' || !std::isfinite(number)) fail(text);
  return number;
}

}  // namespace wardslam::sources
