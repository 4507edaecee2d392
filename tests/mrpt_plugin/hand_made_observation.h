#pragma once

#include <vector>

#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"

namespace wardslam::mrpt_plugin {

/// 64×48: a person (class 1, instance 3) left of column 20, a chair (57, instance 9) from column 40 on. Three key
/// points with depth, on the wall, the chair and the person, and one on the wall without.
inline CObservationSemanticRGBD handMadeObservation() {
  CObservationSemanticRGBD o;
  o.sensorLabel = "RGBD_SEM";
  o.timestamp = mrpt::Clock::fromDouble(1234567890.25);
  o.cameraPose = mrpt::poses::CPose3D(0.1, 0.2, 1.3, 0.5, -0.1, 0.2);
  o.camera = {64, 48, 50.0, 51.0, 31.5, 23.5, 0.01, -0.02, 0.001, 0.002, 0.003, {0.002, 0.004, 0.5}};

  o.segmentation.classIds = cv::Mat(48, 64, CV_8UC1, cv::Scalar(0));
  o.segmentation.instanceIds = cv::Mat(48, 64, CV_16UC1, cv::Scalar(0));
  const cv::Rect person(0, 0, 20, 48);
  const cv::Rect chair(40, 0, 24, 48);
  o.segmentation.classIds(person).setTo(1);
  o.segmentation.classIds(chair).setTo(57);
  o.segmentation.instanceIds(person).setTo(3);
  o.segmentation.instanceIds(chair).setTo(9);
  o.segmentation.instances = {{3, 1, 0.75F, person}, {9, 57, 0.5F, chair}};
  o.classes = {{1, "person"}, {57, "chair"}};
  o.labelBits = cv::Mat(48, 64, CV_8UC1, cv::Scalar(0));
  o.labelBits(person).setTo(5);  // dynamic, person
  o.labelBits(chair).setTo(10);  // movable, thing

  const auto keypoint = [](float x, float y, float depth_m, core::Motion motion) {
    return core::Keypoint{{x, y}, {x + 0.25F, y - 0.25F}, depth_m, 0.0F, 0.7F, 12.5F, 1.2F, motion, 0.875F};
  };
  o.features.keypoints = {keypoint(30, 24, 2.0F, core::Motion::Static), keypoint(50, 10, 1.5F, core::Motion::Static),
                          keypoint(10, 40, 1.0F, core::Motion::Dynamic), keypoint(35, 5, 0.0F, core::Motion::Static)};
  o.features.descriptors = cv::Mat(4, 32, CV_8UC1);
  cv::randu(o.features.descriptors, 0, 256);
  o.states = {KeypointState::Static, KeypointState::Movable, KeypointState::Dynamic, KeypointState::Static};
  o.descriptorSide = 5;
  return o;
}

}  // namespace wardslam::mrpt_plugin
