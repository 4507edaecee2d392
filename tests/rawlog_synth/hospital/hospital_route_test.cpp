#include "hospital/hospital_route.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "hospital/hospital_scene.h"

namespace wardslam::synth {
namespace {

constexpr RouteKind kAll[] = {RouteKind::Tour, RouteKind::Wards, RouteKind::Round, RouteKind::Corridor,
                              RouteKind::Lobby};

TEST(HospitalRoute, TheTourIsLongerThan500Metres) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const HospitalRoute tour(planHospital(seed), {}, seed);
    EXPECT_GT(tour.length_m(), 500.0);
    EXPECT_LT(tour.length_m(), 900.0);
    const double speed_mps = tour.length_m() / tour.round_s();
    EXPECT_GT(speed_mps, 0.6);
    EXPECT_LT(speed_mps, 0.9);
  }
}

TEST(HospitalRoute, ShorterOnesAreAsLongAsTold) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const HospitalPlan plan = planHospital(seed);
    const auto length_m = [&](RouteKind kind) { return HospitalRoute(plan, {kind, 0}, seed).length_m(); };
    EXPECT_NEAR(length_m(RouteKind::Wards), 240.0, 40.0);
    EXPECT_NEAR(length_m(RouteKind::Round), 137.0, 12.0);
    EXPECT_NEAR(length_m(RouteKind::Corridor), 122.0, 10.0);
    EXPECT_NEAR(length_m(RouteKind::Lobby), 25.0, 9.0);
  }
}

TEST(HospitalRoute, IsSmoothAndNoFasterThanARobot) {
  const HospitalPlan plan = planHospital(1);
  for (const RouteKind kind : kAll) {
    const HospitalRoute route(plan, {kind, 0}, 1);
    constexpr double kStep_s = 1.0 / 30;
    for (double t = 0; t < route.round_s() + 1.0; t += kStep_s) {
      const Eigen::Isometry3d step = route.T_world_cam(t).inverse() * route.T_world_cam(t + kStep_s);
      ASSERT_LT(step.translation().norm() / kStep_s, 1.0) << t;
      ASSERT_LT(Eigen::AngleAxisd(step.linear()).angle() / kStep_s, 1.1) << t;
    }
    EXPECT_TRUE(route.T_world_cam(0.0).isApprox(route.T_world_cam(route.round_s()), 1e-6));
  }
}

TEST(HospitalRoute, TheTourComesBackToMostRooms) {
  const HospitalPlan plan = planHospital(1);
  const HospitalRoute tour(plan, {}, 1);
  std::map<std::size_t, int> entered;
  std::size_t last = plan.rooms.size();
  for (double t = 0; t < tour.round_s(); t += 0.5) {
    const std::size_t room = plan.roomAt(tour.at(t).p_m);
    ASSERT_LT(room, plan.rooms.size());
    if (room != last) ++entered[room];
    last = room;
  }
  int wards = 0;
  int again = 0;
  for (const auto& [room, times] : entered) {
    wards += plan.rooms[room].kind == RoomKind::Ward ? 1 : 0;
    again += times > 1 ? 1 : 0;
  }
  EXPECT_EQ(wards, 6);
  EXPECT_GE(again, 5);
}

TEST(HospitalRoute, AnotherRobotStartsElsewhereAndDrivesInAnotherOrder) {
  const HospitalPlan plan = planHospital(1);
  std::set<long> starts;
  for (int robot = 0; robot < 4; ++robot) {
    const HospitalRoute route(plan, {RouteKind::Tour, robot}, 1);
    EXPECT_GT(route.length_m(), 500.0);
    const Eigen::Vector2d p = route.at(0.0).p_m;
    starts.insert(std::lround(p.x() * 10) * 1000 + std::lround(p.y() * 10));
  }
  EXPECT_EQ(starts.size(), 4U);
}

/// How near the camera comes to anything that stands there, up to a little above it.
double nearest_m(const Scene& scene, const HospitalRoute& route) {
  std::vector<Eigen::Vector3d> way;
  for (double t = 0; t < route.round_s(); t += 0.1) way.emplace_back(route.T_world_cam(t).translation());
  double nearest_m = 100.0;
  for (const Thing& thing : scene.things) {
    for (const Surface& surface : thing.surfaces) {
      const auto& vertices = surface.mesh.vertices;
      for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
        // From above, a triangle's box tells enough: furniture's are small, walls' are flat.
        Eigen::AlignedBox3f box;
        for (std::size_t k = 0; k < 3; ++k) box.extend(vertices[i + k].p_m);
        if (box.min().z() > 1.4F || box.max().z() < 0.05F) continue;
        for (const Eigen::Vector3d& p : way) {
          const Eigen::Vector3f q(static_cast<float>(p.x()), static_cast<float>(p.y()), box.center().z());
          if (std::abs(q.x() - box.center().x()) > box.sizes().x() / 2 + 0.4F) continue;
          nearest_m = std::min(nearest_m, static_cast<double>(box.exteriorDistance(q)));
        }
      }
    }
  }
  return nearest_m;
}

TEST(HospitalRoute, KeepsClearOfWallsAndThingsOnAnyDay) {
  for (const auto& [seed, day, robot] : {std::tuple(1U, 0, 0), {2U, 3, 1}, {3U, 8, 2}}) {
    const SceneOptions options{seed, true};
    const Hospital hospital = makeHospital(options, {day, {RouteKind::Tour, robot}});
    const Scene scene = buildHospital(hospital, seed);
    EXPECT_GT(nearest_m(scene, hospital.route), 0.3) << "seed " << seed;
    EXPECT_GT(nearest_m(scene, HospitalRoute(hospital.plan, {RouteKind::Corridor, 0}, seed)), 0.3);
    EXPECT_GT(nearest_m(scene, HospitalRoute(hospital.plan, {RouteKind::Lobby, 0}, seed)), 0.3);
  }
}

}  // namespace
}  // namespace wardslam::synth
