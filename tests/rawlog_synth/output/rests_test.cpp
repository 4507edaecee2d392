#include "output/rests.h"

#include <gtest/gtest.h>

#include <limits>

namespace wardslam::synth {
namespace {

/// Stands at x = 1 m for 10 s, is pushed, and stands at x = 5 m from 20 s on.
class PushedOnce : public Actor {
 public:
  explicit PushedOnce(std::uint16_t id) : Actor({id, "trolley_" + std::to_string(id), 102, "trolley"}) {}
  [[nodiscard]] Surfaces surfacesAt(double) const override { return {}; }
  [[nodiscard]] bool isMovingAt(double t_s) const override { return t_s > 10 && t_s < 20; }
  [[nodiscard]] double atRestFrom_s() const override { return 20; }
  [[nodiscard]] std::vector<RestInterval> restsUntil(double t_s) const override {
    constexpr double kForGood_s = std::numeric_limits<double>::infinity();
    const Eigen::AlignedBox3f cube(Eigen::Vector3f(0.5F, 0, 0), Eigen::Vector3f(1.5F, 1, 1));
    std::vector<RestInterval> rests = {{0, t_s <= 10 ? kForGood_s : 10, cube}};
    if (t_s > 20) rests.push_back({20, kForGood_s, cube.translated(Eigen::Vector3f(4, 0, 0))});
    return rests;
  }
};

constexpr auto kHeader = "instance_id,name,class_id,class_name,from_s,until_s,cx,cy,cz,xmin,ymin,zmin,xmax,ymax,zmax\n";

TEST(Rests, AreListedWithTheirTimesByInstance) {
  Scene scene;
  scene.actors.push_back(std::make_unique<PushedOnce>(std::uint16_t{9}));
  scene.actors.push_back(std::make_unique<PushedOnce>(std::uint16_t{7}));
  const std::string first = ",102,trolley,0.000,10.000,1.000,0.500,0.500,0.500,0.000,0.000,1.500,1.000,1.000\n";
  const std::string second = ",102,trolley,20.000,,5.000,0.500,0.500,4.500,0.000,0.000,5.500,1.000,1.000\n";
  EXPECT_EQ(restsText(scene, 30), kHeader + ("7,trolley_7" + first) + "7,trolley_7" + second + "9,trolley_9" + first +
                                      "9,trolley_9" + second);
}

TEST(Rests, ThatLastHaveNoEnd) {
  Scene scene;
  scene.actors.push_back(std::make_unique<PushedOnce>(std::uint16_t{7}));
  EXPECT_EQ(restsText(scene, 5), std::string(kHeader) +
                                     "7,trolley_7,102,trolley,0.000,,1.000,0.500,0.500,0.500,0.000,"
                                     "0.000,1.500,1.000,1.000\n");
  EXPECT_EQ(restsText({}, 5), kHeader);
}

}  // namespace
}  // namespace wardslam::synth
