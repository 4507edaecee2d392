#include <mrpt/opengl/CBox.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CText.h>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/exchange/map_drawing.h"
#include "wardslam/viewer/map_scene.h"

namespace wardslam::viewer {
namespace {

using mapping::SemanticMap;
using Scene = mrpt::opengl::COpenGLScene;

constexpr float kLineWidth_px = 2.0F;
const mrpt::img::TColor kZoneColor(0, 120, 0);
const mrpt::img::TColor kWayColor(200, 0, 0);

mrpt::math::TPoint3D toMrptPoint(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

void addText(Scene& scene, const std::string& text, const Eigen::Vector3d& p_map_m, const mrpt::img::TColor& color) {
  const auto label = mrpt::opengl::CText::Create(text);
  label->setColor_u8(color);
  label->setLocation(toMrptPoint(p_map_m));
  scene.insert(label);
}

void addZone(Scene& scene, const mapping::Zone& zone) {
  const auto outline = mrpt::opengl::CSetOfLines::Create();
  outline->setName("zone " + zone.name);
  outline->setColor_u8(kZoneColor);
  outline->setLineWidth(kLineWidth_px);
  const std::size_t corners = zone.polygon_m.size();
  for (std::size_t i = 0; i < corners; ++i) {
    const Eigen::Vector2d& from = zone.polygon_m[i];
    const Eigen::Vector2d& to = zone.polygon_m[(i + 1) % corners];
    outline->appendLine(from.x(), from.y(), 0.0, to.x(), to.y(), 0.0);
  }
  scene.insert(outline);
  if (corners > 0) addText(scene, zone.name, {zone.polygon_m[0].x(), zone.polygon_m[0].y(), 0.0}, kZoneColor);
}

void addWay(Scene& scene, const SemanticMap& map) {
  const auto way = mrpt::opengl::CSetOfLines::Create();
  way->setName("way of the camera");
  way->setColor_u8(kWayColor);
  way->setLineWidth(kLineWidth_px);
  const mapping::MappedKeyframe* previous = nullptr;
  for (const auto& [id, keyframe] : map.keyframes) {
    if (previous != nullptr) {
      const Eigen::Vector3d from = previous->T_map_cam.translation();
      const Eigen::Vector3d to = keyframe.T_map_cam.translation();
      way->appendLine(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
    }
    previous = &keyframe;
  }
  scene.insert(way);
}

}  // namespace

std::shared_ptr<mrpt::opengl::COpenGLScene> makeScene(const SemanticMap& map) {
  auto scene = std::make_shared<Scene>();
  scene->insert(exchange::drawCloud(map));
  for (const auto& [id, object] : map.objects) {
    if (object.state == mapping::ObjectState::Gone) continue;
    scene->insert(exchange::drawBox(object));
    scene->insert(exchange::drawName(object, map.labels));
  }
  for (const auto& zone : map.zones) addZone(*scene, zone);
  addWay(*scene, map);
  return scene;
}

void exportScene(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  const auto scene = makeScene(map);
  core::replaceAtomically(file, [&scene](const std::filesystem::path& partial) {
    if (!scene->saveToFile(partial.string())) throw core::InputError(partial.string() + ": cannot be written");
  });
}

}  // namespace wardslam::viewer
