#pragma once

#include "support/textured_room_scan.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/pixel_label.h"
#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"

namespace wardslam::mrpt_plugin {

/// A camera that stands still in TexturedRoom: somebody stands in columns 0…79 of its images, a chair in 200…279.
struct AnnotatedRoom {
  static constexpr core::ClassId kPerson = 1;
  static constexpr core::ClassId kChair = 57;
  static inline const cv::Rect kPerson_px{0, 0, 80, 240};
  static inline const cv::Rect kChair_px{200, 60, 80, 120};

  /// z up, at the height of 1 m; its camera looks ahead.
  static mrpt::poses::CPose3D robotPose() { return {1.0, 2.0, 1.0, 0.5, 0.0, 0.0}; }

  [[nodiscard]] mrpt::obs::CObservation3DRangeScan::Ptr scan(int image) const {
    auto scan = test::observe(room, 0);
    scan->timestamp = core::toMrptTime(1000.0 + image);
    scan->sensorLabel = "RGBD";
    return scan;
  }

  [[nodiscard]] static CObservationSemanticRGBD semantic(int image) {
    CObservationSemanticRGBD semantic;
    semantic.timestamp = core::toMrptTime(1000.0 + image);
    semantic.sensorLabel = "RGBD_SEM";
    semantic.camera = test::TexturedRoom::camera320x240();
    semantic.segmentation.classIds = cv::Mat(240, 320, CV_8UC1, cv::Scalar(0));
    semantic.segmentation.instanceIds = cv::Mat(240, 320, CV_16UC1, cv::Scalar(0));
    add(semantic, {1, kPerson, 1.0F, kPerson_px}, core::PixelLabel::Dynamic);
    add(semantic, {2, kChair, 1.0F, kChair_px}, core::PixelLabel::Movable);
    semantic.classes = {{kPerson, "person"}, {kChair, "chair"}};
    return semantic;
  }

  /// Several looks at the same.
  void insertInto(CSemanticMap& map, int images = 3) const {
    for (int image = 0; image < images; ++image) {
      map.insertObservation(*scan(image), robotPose());
      map.insertObservation(semantic(image), robotPose());
    }
  }

  /// How many points of the cloud the camera sees in these columns and rows.
  [[nodiscard]] static int pointsIn(const mapping::SemanticMap& map, const cv::Rect& region_px) {
    const auto camera = test::TexturedRoom::camera320x240();
    int count = 0;
    for (const auto& [id, tile] : map.cloud) {
      for (const auto& point : tile.points) {
        const Eigen::Vector3f p_m = point.p_cam_m;
        const cv::Point px(static_cast<int>(camera.fx_px * p_m.x() / p_m.z() + camera.cx_px),
                           static_cast<int>(camera.fy_px * p_m.y() / p_m.z() + camera.cy_px));
        count += region_px.contains(px) ? 1 : 0;
      }
    }
    return count;
  }

  test::TexturedRoom room;

 private:
  static void add(CObservationSemanticRGBD& semantic, const core::Instance& instance, core::PixelLabel label) {
    if (semantic.labelBits.empty()) semantic.labelBits = cv::Mat(240, 320, CV_8UC1, cv::Scalar(0));
    semantic.segmentation.classIds(instance.box_px).setTo(instance.classId);
    semantic.segmentation.instanceIds(instance.box_px).setTo(instance.id);
    semantic.segmentation.instances.push_back(instance);
    semantic.labelBits(instance.box_px).setTo(core::bitOf(label));
  }
};

}  // namespace wardslam::mrpt_plugin
