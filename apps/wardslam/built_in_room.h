#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <opencv2/core.hpp>

#include "wardslam/core/camera_model.h"

namespace mrpt::obs {
class CObservation3DRangeScan;
}

namespace wardslam::apps {

/// A box of 4 x 3 x 5 m with blotched walls, and a walk through it: a scene to try the program with where there is no
/// recording. The same on every computer.
class BuiltInRoom {
 public:
  BuiltInRoom();

  /// The image of that number, 320 x 240 pixels, 30 a second, with the depth a perfect camera would measure (0.2 mm).
  [[nodiscard]] std::shared_ptr<mrpt::obs::CObservation3DRangeScan> look(int image) const;

  /// UNIX s.
  [[nodiscard]] static double stamp_s(int image);

  /// Where it was taken: a centimetre and half a degree farther than the one before. The first is the identity.
  [[nodiscard]] static Eigen::Isometry3d T_room_cam(int image);

 private:
  struct Hit {
    double depth_m = 0.0;
    std::uint8_t grey = 0;
  };
  [[nodiscard]] Hit follow(const Eigen::Isometry3d& T_room_cam, const Eigen::Vector3d& ray_cam) const;

  std::array<cv::Mat, 3> walls_;  ///< CV_8UC1, one for both walls across each axis.
};

}  // namespace wardslam::apps
