#include "wardslam/mapping/floor_finder.h"

#include <pcl/ModelCoefficients.h>
#include <pcl/console/print.h>
#include <pcl/filters/extract_indices.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <algorithm>
#include <cmath>

#include "wardslam/mapping/depth_points.h"

namespace wardslam::mapping {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr int kSamplesAcross = 107;
constexpr double kMaxDepth_m = 5.0;         // beyond, the noise of a Kinect hides what is level
constexpr double kPlaneTolerance_m = 0.03;  // noise at 4 m, and a floor that is not quite flat
constexpr double kBeneath_m = 0.10;         // under the floor only stray measurements are
constexpr double kMaxShareBeneath = 0.02;
constexpr double kMaxTilt_rad = 35.0 * M_PI / 180.0;
constexpr std::size_t kMinPoints = 200;  // of a plane
constexpr int kMaxPlanes = 3;            // table, bed, floor

/// PCL prints where it finds no plane, which here is an answer like another.
class QuietPcl {
 public:
  QuietPcl() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
  ~QuietPcl() { pcl::console::setVerbosityLevel(before_); }
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;

 private:
  pcl::console::VERBOSITY_LEVEL before_ = pcl::console::getVerbosityLevel();
};

Cloud::Ptr pointsOf(const cv::Mat& depth_m, const core::CameraModel& camera, const Eigen::Isometry3d& T_level_cam) {
  auto cloud = pcl::make_shared<Cloud>();
  for (const DepthPoint& point : depthPoints(depth_m, camera, std::max(1, depth_m.cols / kSamplesAcross))) {
    if (point.p_cam_m.z() > kMaxDepth_m) continue;
    const Eigen::Vector3f p = (T_level_cam * point.p_cam_m).cast<float>();
    cloud->emplace_back(p.x(), p.y(), p.z());
  }
  return cloud;
}

/// The plane through most points among those whose normal is within kMaxTilt_rad of z; the normal points up.
std::optional<Eigen::Hyperplane<double, 3>> largestLevelPlane(const Cloud::Ptr& cloud, pcl::PointIndices& inliers) {
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setModelType(pcl::SACMODEL_PERPENDICULAR_PLANE);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setAxis(Eigen::Vector3f::UnitZ());
  segmentation.setEpsAngle(kMaxTilt_rad);
  segmentation.setDistanceThreshold(kPlaneTolerance_m);
  segmentation.setOptimizeCoefficients(true);
  segmentation.setMaxIterations(500);
  segmentation.setInputCloud(cloud);
  pcl::ModelCoefficients plane;
  segmentation.segment(inliers, plane);
  if (inliers.indices.size() < kMinPoints) return std::nullopt;
  Eigen::Vector3d normal(plane.values[0], plane.values[1], plane.values[2]);
  double offset_m = plane.values[3];
  if (normal.z() < 0.0) {
    normal = -normal;
    offset_m = -offset_m;
  }
  return Eigen::Hyperplane<double, 3>(normal.normalized(), offset_m / normal.norm());
}

bool nothingIsBeneath(const Cloud& cloud, const Eigen::Hyperplane<double, 3>& plane) {
  const auto beneath = std::count_if(cloud.begin(), cloud.end(), [&](const pcl::PointXYZ& p) {
    return plane.signedDistance(p.getVector3fMap().cast<double>()) < -kBeneath_m;
  });
  return static_cast<double>(beneath) <= kMaxShareBeneath * static_cast<double>(cloud.size());
}

}  // namespace

std::optional<Eigen::Isometry3d> levelWithFloor(const cv::Mat& depth_m, const core::CameraModel& camera,
                                                const Eigen::Isometry3d& T_level_cam_guess) {
  const QuietPcl quiet;
  const Cloud::Ptr all = pointsOf(depth_m, camera, T_level_cam_guess);
  Cloud::Ptr rest = all;
  for (int i = 0; i < kMaxPlanes && rest->size() >= kMinPoints; ++i) {
    const auto inliers = pcl::make_shared<pcl::PointIndices>();
    const auto plane = largestLevelPlane(rest, *inliers);
    if (!plane) return std::nullopt;
    const double cameraHeight_m = plane->signedDistance(Eigen::Vector3d(T_level_cam_guess.translation()));
    if (cameraHeight_m > kBeneath_m && nothingIsBeneath(*all, *plane)) {
      const auto upright = Eigen::Quaterniond::FromTwoVectors(plane->normal(), Eigen::Vector3d::UnitZ());
      Eigen::Isometry3d T_floor_cam = Eigen::Isometry3d::Identity();
      T_floor_cam.linear() = upright.toRotationMatrix() * T_level_cam_guess.linear();
      T_floor_cam.translation() = T_level_cam_guess.translation();
      T_floor_cam.translation().z() = cameraHeight_m;
      return T_floor_cam;
    }
    const auto others = pcl::make_shared<Cloud>();
    pcl::ExtractIndices<pcl::PointXYZ> extract;
    extract.setInputCloud(rest);
    extract.setIndices(inliers);
    extract.setNegative(true);
    extract.filter(*others);
    rest = others;
  }
  return std::nullopt;
}

}  // namespace wardslam::mapping
