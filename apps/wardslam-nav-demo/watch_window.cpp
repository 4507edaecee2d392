#include "watch_window.h"

#include <mrpt/gui/CDisplayWindow3D.h>
#include <mrpt/opengl/CCylinder.h>
#include <mrpt/opengl/COpenGLScene.h>

#include <cstdlib>
#include <vector>

#include "support/playback_clock.h"
#include "wardslam/core/errors.h"
#include "wardslam/viewer/map_scene.h"

namespace wardslam::nav_demo {
namespace {

constexpr float kRobotHeight_m = 0.9F;
constexpr float kPersonHeight_m = 1.7F;

mrpt::opengl::CCylinder::Ptr makeCylinder(double radius_m, float height_m, const mrpt::img::TColor& color) {
  auto cylinder = mrpt::opengl::CCylinder::Create(static_cast<float>(radius_m), static_cast<float>(radius_m), height_m);
  cylinder->setColor_u8(color);
  return cylinder;
}

void requireDisplay() {
  if (std::getenv("DISPLAY") != nullptr) return;
  throw core::InputError("there is no display to open a window on (DISPLAY is not set); write a picture instead");
}

}  // namespace

struct WatchWindow::Window {
  explicit Window(const std::string& title) : window(title, 1200, 900) {}

  mrpt::gui::CDisplayWindow3D window;
  mrpt::opengl::CCylinder::Ptr robot;
  std::vector<mrpt::opengl::CCylinder::Ptr> people;
  apps::PlaybackClock clock;
};

WatchWindow::WatchWindow(const mapping::SemanticMap& map, const Mission& mission, const SimulationOptions& options) {
  requireDisplay();
  window_ = std::make_unique<Window>("Deliver to " + mission.name);
  auto& scene = window_->window.get3DSceneAndLock();
  scene = viewer::makeScene(map);
  window_->robot = makeCylinder(options.robot.radius_m, kRobotHeight_m, {235, 90, 0});
  scene->insert(window_->robot);
  for (int i = 0; i < options.peopleCount; ++i) {
    window_->people.push_back(makeCylinder(options.people.radius_m, kPersonHeight_m, {130, 60, 150}));
    scene->insert(window_->people.back());
  }
  window_->window.unlockAccess3DScene();
  window_->window.setCameraElevationDeg(60.0F);
  window_->window.setCameraZoom(16.0F);
}

WatchWindow::~WatchWindow() = default;

bool WatchWindow::show(const Moment& moment) {
  window_->clock.waitFor(moment.t_s);
  window_->window.get3DSceneAndLock();
  const Eigen::Vector2d p = moment.T_map_robot.translation();
  window_->robot->setLocation(p.x(), p.y(), 0.0);
  for (std::size_t i = 0; i < window_->people.size(); ++i)
    window_->people[i]->setLocation(moment.people_m[i].x(), moment.people_m[i].y(), 0.0);
  window_->window.unlockAccess3DScene();
  window_->window.forceRepaint();
  return window_->window.isOpen();
}

}  // namespace wardslam::nav_demo
