#include "wardslam/mapping/floor_finder.h"

#include <pcl/filters/extract_indices.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_perpendicular_plane.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "quiet_pcl.h"
#include "wardslam/mapping/depth_points.h"

namespace wardslam::mapping {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr int kSamplesAcross = 107;
constexpr double kMaxDepth_m = 5.0;         // beyond, the noise of a Kinect hides what is level
constexpr double kPlaneTolerance_m = 0.03;  // noise at 4 m, and a floor that is not quite flat
constexpr double kBeneath_m = 0.10;         // under the floor only stray measurements are
constexpr double kMaxShareBeneath = 0.02;
constexpr std::size_t kMinPoints = 200;     // of a plane
constexpr int kMaxPlanes = 3;               // table, bed, floor
constexpr double kAboutTolerance_m = 0.05;  // of a plane that is only expected
constexpr double kMaxMisfit = 4.0;          // more than noise explains: a plane through things, not along one

// What is the same for all pixels of an image, so that no number of them averages it out.
constexpr double kUneven_m = 0.004;
constexpr double kBias_rad = 0.002;
constexpr double kBias_m = 0.004;

Cloud::Ptr pointsOf(const std::vector<DepthPoint>& points, const Eigen::Matrix3d& R_level_cam) {
  auto cloud = pcl::make_shared<Cloud>();
  for (const DepthPoint& point : points) {
    if (point.p_cam_m.z() > kMaxDepth_m) continue;
    const Eigen::Vector3f p = (R_level_cam * point.p_cam_m).cast<float>();
    cloud->emplace_back(p.x(), p.y(), p.z());
  }
  return cloud;
}

/// The plane through most points among those whose normal is about z; the normal points up.
std::optional<Eigen::Hyperplane<double, 3>> largestLevelPlane(const Cloud::Ptr& cloud, double maxTilt_rad,
                                                              pcl::PointIndices& inliers) {
  const auto model = pcl::make_shared<pcl::SampleConsensusModelPerpendicularPlane<pcl::PointXYZ>>(cloud);
  model->setAxis(Eigen::Vector3f::UnitZ());
  model->setEpsAngle(maxTilt_rad);
  pcl::RandomSampleConsensus<pcl::PointXYZ> search(model, kPlaneTolerance_m);
  search.setMaxIterations(500);
  if (!search.computeModel()) return std::nullopt;
  search.getInliers(inliers.indices);
  Eigen::VectorXf found;
  search.getModelCoefficients(found);
  Eigen::VectorXf plane;
  model->optimizeModelCoefficients(inliers.indices, found, plane);
  model->selectWithinDistance(plane, kPlaneTolerance_m, inliers.indices);
  if (inliers.indices.size() < kMinPoints) return std::nullopt;
  Eigen::Vector3d normal = plane.head<3>().cast<double>();
  double offset_m = plane[3];
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

/// As seen from a camera at the origin.
bool isAsExpected(const Cloud& all, const Eigen::Hyperplane<double, 3>& plane, const GroundExpectation& expected) {
  const double height_m = plane.offset();
  if (height_m < kBeneath_m) return false;
  if (!expected.height_m) return nothingIsBeneath(all, plane);
  return std::abs(height_m - *expected.height_m) <= expected.heightTolerance_m;
}

/// In level coordinates about the camera, where the plane is about z = -height.
std::optional<Eigen::Hyperplane<double, 3>> findPlane(const Cloud::Ptr& all, const GroundExpectation& expected) {
  const QuietPcl quiet;
  Cloud::Ptr rest = all;
  for (int i = 0; i < kMaxPlanes && rest->size() >= kMinPoints; ++i) {
    const auto inliers = pcl::make_shared<pcl::PointIndices>();
    auto plane = largestLevelPlane(rest, expected.maxTilt_rad, *inliers);
    if (!plane) return std::nullopt;
    if (isAsExpected(*all, *plane, expected)) return plane;
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

struct Fit {
  core::GroundPlane plane;
  std::size_t points = 0;
  double misfit = 0.0;  ///< Mean square of what is left, in standard deviations.
};

/// Weighted least squares over the points within tolerance: the shifts of the normal along the tangents, and of the
/// height, with their covariance.
Fit refit(const core::GroundPlane& plane, const std::vector<DepthPoint>& points, const core::DepthNoise& noise,
          double tolerance_m) {
  const auto tangents = plane.tangents();
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double squares = 0.0;
  Fit fit{plane, 0, 0.0};
  for (const DepthPoint& point : points) {
    const double depth_m = point.p_cam_m.z();
    const double height_m = plane.heightOf_m(point.p_cam_m);
    if (depth_m > kMaxDepth_m || std::abs(height_m) > tolerance_m) continue;
    const double sigma_m = noise.sigma_m(depth_m) * plane.normal_cam.dot(point.p_cam_m) / depth_m;
    const double weight = 1.0 / (sigma_m * sigma_m + kUneven_m * kUneven_m);
    Eigen::Vector3d jacobian;
    jacobian << tangents.transpose() * point.p_cam_m, 1.0;
    information += weight * jacobian * jacobian.transpose();
    right -= weight * height_m * jacobian;
    squares += weight * height_m * height_m;
    ++fit.points;
  }
  if (fit.points < kMinPoints) return fit;
  const Eigen::Vector3d shift = information.ldlt().solve(right);
  const Eigen::Vector3d normal = plane.normal_cam + tangents * shift.head<2>();
  fit.plane.normal_cam = normal.normalized();
  fit.plane.height_m = (plane.height_m + shift.z()) / normal.norm();
  fit.misfit = (squares - shift.dot(right)) / static_cast<double>(fit.points);
  fit.plane.covariance = std::max(1.0, fit.misfit) * information.inverse();
  fit.plane.covariance.diagonal() += Eigen::Vector3d(kBias_rad, kBias_rad, kBias_m).cwiseAbs2();
  return fit;
}

/// The plane that starts from there, where the image has one that is as expected.
std::optional<core::GroundPlane> fitFrom(const core::GroundPlane& start, const std::vector<DepthPoint>& points,
                                         const core::DepthNoise& noise, const GroundExpectation& expected) {
  Fit fit = refit(start, points, noise, kAboutTolerance_m);
  if (fit.points < kMinPoints) return std::nullopt;
  fit = refit(fit.plane, points, noise, kPlaneTolerance_m);
  if (fit.points < kMinPoints || fit.misfit > kMaxMisfit) return std::nullopt;
  if (fit.plane.normal_cam.dot(expected.up_cam) < std::cos(expected.maxTilt_rad)) return std::nullopt;
  const double off_m = expected.height_m ? fit.plane.height_m - *expected.height_m : 0.0;
  if (std::abs(off_m) > expected.heightTolerance_m) return std::nullopt;
  return fit.plane;
}

}  // namespace

std::optional<core::GroundPlane> findGround(const cv::Mat& depth_m, const core::CameraModel& camera,
                                            const GroundExpectation& expected) {
  const auto points = depthPoints(depth_m, camera, std::max(1, depth_m.cols / kSamplesAcross));
  core::GroundPlane plane;
  if (expected.height_m) {  // most floor goes on as it was
    plane.normal_cam = expected.up_cam;
    plane.height_m = *expected.height_m;
    if (auto found = fitFrom(plane, points, camera.depthNoise, expected)) return found;
  }
  const Eigen::Matrix3d R_level_cam =
      Eigen::Quaterniond::FromTwoVectors(expected.up_cam, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto found = findPlane(pointsOf(points, R_level_cam), expected);
  if (!found) return std::nullopt;
  plane.normal_cam = R_level_cam.transpose() * found->normal();
  plane.height_m = found->offset();
  return fitFrom(plane, points, camera.depthNoise, expected);
}

std::optional<Eigen::Isometry3d> levelWithFloor(const cv::Mat& depth_m, const core::CameraModel& camera,
                                                const Eigen::Isometry3d& T_level_cam_guess) {
  GroundExpectation expected;
  expected.up_cam = T_level_cam_guess.linear().transpose() * Eigen::Vector3d::UnitZ();
  const auto ground = findGround(depth_m, camera, expected);
  if (!ground) return std::nullopt;
  const Eigen::Vector3d normal_level = T_level_cam_guess.linear() * ground->normal_cam;
  const auto upright = Eigen::Quaterniond::FromTwoVectors(normal_level, Eigen::Vector3d::UnitZ());
  Eigen::Isometry3d T_floor_cam = Eigen::Isometry3d::Identity();
  T_floor_cam.linear() = upright.toRotationMatrix() * T_level_cam_guess.linear();
  T_floor_cam.translation() = T_level_cam_guess.translation();
  T_floor_cam.translation().z() = ground->height_m;
  return T_floor_cam;
}

}  // namespace wardslam::mapping
