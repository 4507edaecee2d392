#include "camera/closed_route.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace wardslam::synth {
namespace {

using Eigen::Vector2d;

/// Straight on for `straight_m`, then a bend by `turn_rad`.
struct Piece {
  Vector2d begin_m;
  double heading_rad;
  double straight_m;
  double turn_rad;
  double radius_m;
};

double headingOf(const Vector2d& way) { return std::atan2(way.y(), way.x()); }

/// One piece per corner; the first begins in the middle of the last side.
std::vector<Piece> piecesOf(const std::vector<Vector2d>& corners_m, const std::vector<double>& radii_m) {
  const std::size_t n = corners_m.size();
  if (n < 3) throw std::invalid_argument("a closed route needs three corners");
  Vector2d here_m = (corners_m[n - 1] + corners_m[0]) / 2;
  double heading = headingOf(corners_m[0] - here_m);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d after = (corners_m[(i + 1) % n] - corners_m[i]).normalized();
    const double turn = std::remainder(headingOf(after) - heading, 2 * M_PI);
    const double cut_m = radii_m[i] * std::tan(std::abs(turn) / 2);  // of both sides, for the bend
    const double straight_m = (corners_m[i] - here_m).norm() - cut_m;
    if (straight_m < 0) throw std::invalid_argument("a side of the route is too short for its bends");
    pieces.push_back({here_m, heading, straight_m, turn, radii_m[i]});
    here_m = corners_m[i] + cut_m * after;
    heading += turn;
  }
  return pieces;
}

Vector2d direction(double heading_rad) { return {std::cos(heading_rad), std::sin(heading_rad)}; }

ClosedRoute::Place placeOn(const Piece& piece, double s_m) {
  const Vector2d ahead = direction(piece.heading_rad);
  if (s_m <= piece.straight_m) return {piece.begin_m + s_m * ahead, piece.heading_rad};
  const double side = piece.turn_rad > 0 ? 1.0 : -1.0;
  const double turned = side * (s_m - piece.straight_m) / piece.radius_m;
  const Vector2d towardsCentre = side * Vector2d(-ahead.y(), ahead.x());
  const Vector2d centre_m = piece.begin_m + piece.straight_m * ahead + piece.radius_m * towardsCentre;
  const Vector2d fromCentre = -(Eigen::Rotation2Dd(turned) * towardsCentre);
  return {centre_m + piece.radius_m * fromCentre, piece.heading_rad + turned};
}

}  // namespace

ClosedRoute::ClosedRoute(const std::vector<Vector2d>& corners_m, double radius_m)
    : ClosedRoute(corners_m, std::vector<double>(corners_m.size(), radius_m)) {}

ClosedRoute::ClosedRoute(const std::vector<Vector2d>& corners_m, const std::vector<double>& radii_m) {
  auto pieces = piecesOf(corners_m, radii_m);
  const Piece& last = pieces.back();
  const double heading = last.heading_rad + last.turn_rad;
  const Vector2d home_m = pieces.front().begin_m;
  const double cut_m = last.radius_m * std::tan(std::abs(last.turn_rad) / 2);
  const Vector2d lastBend_m = corners_m.back() + cut_m * direction(heading);
  turn_rad_ = heading - pieces.front().heading_rad;
  pieces.push_back({lastBend_m, heading, (home_m - lastBend_m).norm(), 0.0, 1.0});

  double total_m = 0.0;
  std::vector<double> begins_m;
  for (const Piece& piece : pieces) {
    begins_m.push_back(total_m);
    total_m += piece.straight_m + piece.radius_m * std::abs(piece.turn_rad);
  }
  const auto count = static_cast<std::size_t>(std::round(total_m / step_m_));
  step_m_ = total_m / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double s_m = static_cast<double>(i) * step_m_;
    const auto next = std::upper_bound(begins_m.begin(), begins_m.end(), s_m);
    const auto k = static_cast<std::size_t>(next - begins_m.begin()) - 1;
    places_.push_back(placeOn(pieces[k], s_m - begins_m[k]));
  }
}

ClosedRoute::Place ClosedRoute::at(double s_m) const {
  const auto count = static_cast<long>(places_.size());
  const auto headingAt = [&](long i) {
    const long round = (i >= 0 ? i : i - count + 1) / count;
    return places_[static_cast<std::size_t>(i - round * count)].heading_rad + static_cast<double>(round) * turn_rad_;
  };
  const auto eased = [&](long i) {
    const auto half = static_cast<long>(kEasing_m / 2 / step_m_);
    double sum = 0.0;
    for (long k = i - half; k <= i + half; ++k) sum += headingAt(k);
    return sum / static_cast<double>(2 * half + 1);
  };
  const double index = s_m / step_m_;
  const auto i = static_cast<long>(std::floor(index));
  const double w = index - static_cast<double>(i);
  const auto pointAt = [&](long k) { return places_[static_cast<std::size_t>((k % count + count) % count)].p_m; };
  return {(1 - w) * pointAt(i) + w * pointAt(i + 1), (1 - w) * eased(i) + w * eased(i + 1)};
}

}  // namespace wardslam::synth
