#include "wardslam/viewer/map_window.h"

#include <mrpt/gui/CDisplayWindow3D.h>
#include <mrpt/opengl/COpenGLScene.h>

#include <chrono>
#include <thread>

#include "display.h"
#include "wardslam/viewer/map_scene.h"

namespace wardslam::viewer {

void showMap(const mapping::SemanticMap& map, const std::string& title) {
  requireDisplay();
  mrpt::gui::CDisplayWindow3D window(title, 1200, 900);
  window.get3DSceneAndLock() = viewer::makeScene(map);
  window.unlockAccess3DScene();
  window.setCameraElevationDeg(50.0F);
  window.setCameraZoom(12.0F);
  window.forceRepaint();
  while (window.isOpen()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

}  // namespace wardslam::viewer
