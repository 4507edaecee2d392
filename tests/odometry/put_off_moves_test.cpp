#include "put_off_moves.h"

#include <gmock/gmock.h>

namespace wardslam::odometry {
namespace {

using Eigen::Vector3d;

/// Of points 1 to 6 along x, a metre apart and seen from a metre above; the first five of them are moved.
class PutOffMovesTest : public testing::Test {
 protected:
  PutOffMovesTest() {
    for (PointId id = 1; id <= 6; ++id) {
      points_[id].p_map_m = start(id);
      points_[id].viewedFrom_map_m = start(id) + Vector3d::UnitZ();
    }
  }

  static Vector3d start(PointId id) { return {static_cast<double>(id), 0, 0}; }

  /// Everything is `shift_m` farther, and on its side: what was above is before.
  void turn(const Vector3d& shift_m) {
    auto update = std::make_shared<MapUpdate>();
    for (PointId id = 1; id <= 5; ++id) update->p_map_m[id] = start(id) + shift_m;
    moves_.add(update, Eigen::AngleAxisd(-M_PI / 2, Vector3d::UnitX()).toRotationMatrix());  // z becomes y
  }

  [[nodiscard]] std::size_t moved() const {
    std::size_t count = 0;
    for (const auto& [id, point] : points_) count += point.p_map_m.isApprox(start(id)) ? 0 : 1;
    return count;
  }

  std::map<PointId, MapPoint> points_;
  PutOffMoves moves_;
};

TEST_F(PutOffMovesTest, MoveAPointOnceWhenItIsAskedFor) {
  turn({0, 0, 9});
  for (int i = 0; i < 2; ++i) moves_.settle(3, points_.at(3));
  EXPECT_EQ(moved(), 1U);
  EXPECT_TRUE(points_.at(3).p_map_m.isApprox(Vector3d(3, 0, 9)));
  EXPECT_TRUE(points_.at(3).viewedFrom_map_m.isApprox(Vector3d(3, 1, 9)));
}

TEST_F(PutOffMovesTest, MoveTheOthersLittleByLittle) {
  turn({0, 0, 9});
  moves_.settleSome(points_, 2);
  EXPECT_EQ(moved(), 2U);
  moves_.settle(1, points_.at(1));
  moves_.settle(5, points_.at(5));
  EXPECT_EQ(moved(), 3U);
  moves_.settleSome(points_, 2);
  EXPECT_EQ(moved(), 5U);
  EXPECT_FALSE(moves_.empty());
  moves_.settleSome(points_, 2);
  EXPECT_TRUE(moves_.empty());
  for (PointId id = 1; id <= 5; ++id) {
    EXPECT_TRUE(points_.at(id).p_map_m.isApprox(start(id) + Vector3d(0, 0, 9))) << id;
    EXPECT_TRUE(points_.at(id).viewedFrom_map_m.isApprox(start(id) + Vector3d(0, 1, 9))) << id;
  }
  EXPECT_TRUE(points_.at(6).viewedFrom_map_m.isApprox(start(6) + Vector3d::UnitZ()));
}

TEST_F(PutOffMovesTest, AreMadeInTheirOrder) {
  turn({0, 0, 9});
  moves_.settleSome(points_, 2);
  turn({0, 0, 7});
  moves_.settle(2, points_.at(2));
  while (!moves_.empty()) moves_.settleSome(points_, 2);
  for (PointId id = 1; id <= 5; ++id) {
    EXPECT_TRUE(points_.at(id).p_map_m.isApprox(start(id) + Vector3d(0, 0, 7))) << id;
    EXPECT_TRUE(points_.at(id).viewedFrom_map_m.isApprox(start(id) + Vector3d(0, 0, 6))) << id << ": turned twice";
  }
}

TEST_F(PutOffMovesTest, LeaveAloneWhatCameLater) {
  turn({0, 0, 9});
  moves_.skip(4);
  while (!moves_.empty()) moves_.settleSome(points_, 100);
  EXPECT_TRUE(points_.at(4).p_map_m.isApprox(start(4)));
  EXPECT_EQ(moved(), 4U);
}

}  // namespace
}  // namespace wardslam::odometry
