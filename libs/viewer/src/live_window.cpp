#include "wardslam/viewer/live_window.h"

#include <mrpt/gui/CDisplayWindow3D.h>
#include <mrpt/img/CImage.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/stock_objects.h>

#include <chrono>
#include <cmath>

#include "display.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/mapping/depth_points.h"
#include "wardslam/viewer/annotated_picture.h"

namespace wardslam::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBetweenDrawings{200};
constexpr int kStep_px = 4;
constexpr float kPointSize_px = 3.0F;
constexpr std::uint8_t kOpaque = 255;

/// Points of every few pixels with depth, in the map frame.
void fill(mrpt::opengl::CPointCloudColoured& cloud, const core::Frame& frame, const Eigen::Isometry3d& T_map_cam) {
  cloud.clear();
  for (const auto& [pixel, p_cam_m] : mapping::depthPoints(frame.depth_m, frame.camera, kStep_px)) {
    const Eigen::Vector3f p = (T_map_cam * p_cam_m).cast<float>();
    const auto& bgr = frame.color_bgr.at<cv::Vec3b>(pixel);
    const bool moves = !frame.mayMove.empty() && frame.mayMove.at<std::uint8_t>(pixel) != 0;
    cloud.insertPoint({p.x(), p.y(), p.z(), moves ? kOpaque : bgr[2], moves ? std::uint8_t{0} : bgr[1],
                       moves ? std::uint8_t{0} : bgr[0], kOpaque});
  }
}

}  // namespace

struct LiveWindow::Window {
  Window() : window("WardSLAM", 1200, 800) {
    cloud->setPointSize(kPointSize_px);
    way->setColor_u8(mrpt::img::TColor(200, 0, 0));
    way->setLineWidth(2.0F);
    auto& scene = window.get3DSceneAndLock();
    scene->insert(cloud);
    scene->insert(way);
    scene->insert(camera);
    scene->createViewport("image")->setViewportPosition(0.01, 0.54, 0.4, 0.45);
    window.unlockAccess3DScene();
    scene->getViewport()->setCustomBackgroundColor({1.0F, 1.0F, 1.0F});
    window.setCameraElevationDeg(35.0F);
    window.setCameraZoom(7.0F);
  }

  void draw(const core::Frame& frame, const Eigen::Isometry3d& T_map_cam, const core::LabelSpace& labels) {
    const cv::Mat picture = drawAnnotated(frame, labels);
    auto& scene = window.get3DSceneAndLock();
    fill(*cloud, frame, T_map_cam);
    camera->setPose(core::toMrpt(T_map_cam));
    scene->getViewport("image")->setImageView(mrpt::img::CImage(picture, mrpt::img::DEEP_COPY));
    window.unlockAccess3DScene();
    followFromBehind(T_map_cam);
    window.repaint();
  }

  void followFromBehind(const Eigen::Isometry3d& T_map_cam) {
    constexpr double kAhead_m = 1.5;
    constexpr double kHalfTurn_deg = 180.0;
    const Eigen::Vector3d ahead = T_map_cam.linear().col(2);
    const Eigen::Vector3f looked = (T_map_cam.translation() + kAhead_m * ahead).cast<float>();
    window.setCameraPointingToPoint(looked.x(), looked.y(), looked.z());
    window.setCameraAzimuthDeg(
        static_cast<float>(std::atan2(ahead.y(), ahead.x()) * kHalfTurn_deg / M_PI + kHalfTurn_deg));
  }

  void extendWay(const Eigen::Isometry3d& T_map_cam) {
    const Eigen::Vector3d p = T_map_cam.translation();
    window.get3DSceneAndLock();
    if (way->empty()) {
      way->appendLine(p.x(), p.y(), p.z(), p.x(), p.y(), p.z());
    } else {
      way->appendLineStrip(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
    }
    window.unlockAccess3DScene();
  }

  mrpt::gui::CDisplayWindow3D window;
  mrpt::opengl::CPointCloudColoured::Ptr cloud = mrpt::opengl::CPointCloudColoured::Create();
  mrpt::opengl::CSetOfLines::Ptr way = mrpt::opengl::CSetOfLines::Create();
  mrpt::opengl::CSetOfObjects::Ptr camera = mrpt::opengl::stock_objects::CornerXYZSimple(0.3F, 2.0F);
  Clock::time_point lastDrawing;
};

LiveWindow::LiveWindow(const core::LabelSpace& labels) : labels_(labels) {
  requireDisplay();
  window_ = std::make_unique<Window>();
}

LiveWindow::~LiveWindow() = default;

void LiveWindow::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  if (!odometry.hasPose() || !window_->window.isOpen()) return;
  window_->extendWay(odometry.T_map_cam);
  if (Clock::now() - window_->lastDrawing < kBetweenDrawings) return;
  window_->draw(frame, odometry.T_map_cam, labels_);
  window_->lastDrawing = Clock::now();
}

}  // namespace wardslam::viewer
