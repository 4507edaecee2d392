#include "inverse_lens.h"

#include <Eigen/Dense>
#include <algorithm>

namespace wardslam::sources {
namespace {

constexpr int kColumns = 24;
constexpr int kRows = 18;

using Coefficients = Eigen::Matrix<double, 5, 1>;
using Terms = Eigen::Matrix<double, 2, 5>;

/// By what each coefficient, in the order k1 k2 p1 p2 k3, shifts a point of the plane at distance 1.
Terms termsAt(const Eigen::Vector2d& p) {
  const double r2 = p.squaredNorm();
  Terms terms;
  terms.col(0) = p * r2;
  terms.col(1) = p * r2 * r2;
  terms.col(2) = Eigen::Vector2d(2.0 * p.x() * p.y(), r2 + 2.0 * p.y() * p.y());
  terms.col(3) = Eigen::Vector2d(r2 + 2.0 * p.x() * p.x(), 2.0 * p.x() * p.y());
  terms.col(4) = p * r2 * r2 * r2;
  return terms;
}

}  // namespace

std::optional<double> setInverseLens(core::CameraModel& camera, const std::array<double, 5>& inverse) {
  const Eigen::Map<const Coefficients> given(inverse.data());
  Eigen::Matrix<double, Eigen::Dynamic, 5> terms(2 * kColumns * kRows, 5);
  Eigen::VectorXd shifts(2 * kColumns * kRows);
  for (int i = 0; i < kColumns * kRows; ++i) {
    const Eigen::Vector2d seen(((i % kColumns) * camera.width_px / (kColumns - 1.0) - camera.cx_px) / camera.fx_px,
                               ((i / kColumns) * camera.height_px / (kRows - 1.0) - camera.cy_px) / camera.fy_px);
    const Eigen::Vector2d ideal = seen + termsAt(seen) * given;
    terms.middleRows<2>(2 * i) = termsAt(ideal);
    shifts.segment<2>(2 * i) = seen - ideal;
  }
  const Coefficients found = terms.colPivHouseholderQr().solve(shifts);
  if (!found.allFinite()) return std::nullopt;
  camera.k1 = found[0];
  camera.k2 = found[1];
  camera.p1 = found[2];
  camera.p2 = found[3];
  camera.k3 = found[4];
  return (terms * found - shifts).cwiseAbs().maxCoeff() * std::max(camera.fx_px, camera.fy_px);
}

}  // namespace wardslam::sources
