#include "wardslam/exchange/map_drawing.h"

#include <mrpt/opengl/CBox.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CText.h>

#include <string>

#include "wardslam/core/mrpt_compat.h"
#include "wardslam/mapping/cloud_in_map.h"
#include "wardslam/mapping/semantic_color.h"

namespace wardslam::exchange {
namespace {

constexpr std::uint8_t kOpaque = 255;
constexpr float kLineWidth_px = 2.0F;
constexpr std::array<std::uint8_t, 3> kNoClass_rgb{128, 128, 128};

mrpt::math::TPoint3D toMrptPoint(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

mrpt::img::TColor colorOf(const mapping::MapObject& object) {
  const auto& [red, green, blue] = object.color_rgb;
  return {red, green, blue};
}

std::array<std::uint8_t, 3> colorOf(const mapping::SemanticPoint& point, CloudColor color) {
  if (color == CloudColor::Image) return point.color_rgb;
  return point.classId == 0 ? kNoClass_rgb : mapping::semanticColor(point.classId);
}

}  // namespace

std::shared_ptr<mrpt::opengl::CPointCloudColoured> drawCloud(const mapping::SemanticMap& map, CloudColor color,
                                                             float pointSize_px) {
  auto cloud = mrpt::opengl::CPointCloudColoured::Create();
  cloud->setName("cloud");
  cloud->setPointSize(pointSize_px);
  mapping::forEachCloudPoint(map, [&](const Eigen::Vector3f& p_m, const mapping::SemanticPoint& point) {
    const auto [red, green, blue] = colorOf(point, color);
    cloud->insertPoint({p_m.x(), p_m.y(), p_m.z(), red, green, blue, kOpaque});
  });
  return cloud;
}

std::shared_ptr<mrpt::opengl::CBox> drawBox(const mapping::MapObject& object) {
  const Eigen::Vector3d half_m = object.orientedBox.size_m / 2;
  auto box =
      mrpt::opengl::CBox::Create(toMrptPoint(-half_m), toMrptPoint(half_m), /*is_wireframe=*/true, kLineWidth_px);
  box->setName("object " + std::to_string(object.id));
  box->setPose(core::toMrpt(object.orientedBox.T_map_box));
  box->setColor_u8(colorOf(object));
  box->setBoxBorderColor(colorOf(object));
  return box;
}

std::shared_ptr<mrpt::opengl::CText> drawName(const mapping::MapObject& object, const core::LabelSpace& labels) {
  Eigen::Vector3d top_m = object.centroid_m;
  top_m.z() = object.box_m.max().z();
  auto text = mrpt::opengl::CText::Create(labels.name(object.classId) + " #" + std::to_string(object.id));
  text->setColor_u8(colorOf(object));
  text->setLocation(toMrptPoint(top_m));
  return text;
}

}  // namespace wardslam::exchange
