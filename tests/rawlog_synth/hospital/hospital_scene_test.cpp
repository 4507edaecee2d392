#include "hospital/hospital_scene.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "life/life_actors.h"
#include "scene/classes.h"

namespace wardslam::synth {
namespace {

HospitalOptions hospitalOf(Density people) {
  HospitalOptions options;
  options.people = people;
  options.route.kind = RouteKind::Round;
  return options;
}

std::size_t lyingIn(const Scene& scene) {
  std::size_t patients = 0;
  for (const Thing& thing : scene.things) patients += thing.label.classId == kPerson ? 1 : 0;
  return patients;
}

TEST(HospitalScene, PeopleLiveThereAndKeepOffTheCamera) {
  const Setting setting = hospitalSetting({}, hospitalOf(Density::Normal), {});
  std::set<std::uint16_t> ids;
  for (const Thing& thing : setting.scene.things) ids.insert(thing.label.id);
  int people = 0;
  for (const auto& actor : setting.scene.actors) {
    EXPECT_TRUE(ids.insert(actor->label().id).second) << actor->label().name;
    const auto* person = dynamic_cast<const MemberActor*>(actor.get());
    if (person == nullptr) continue;
    ++people;
    for (double t = 0.0; t < 8.0; t += 0.2) {
      const Eigen::Vector2d camera = setting.T_world_cam(t).translation().head<2>();
      ASSERT_GT((person->bodyAt(t).p_m - camera).norm(), 0.45) << actor->label().name << " at " << t;
    }
  }
  EXPECT_GT(people, 20);
}

TEST(HospitalScene, NobodyIsThereWhereNobodyShallBe) {
  const std::pair<SceneOptions, Density> wishes[] = {{{1, true}, Density::None}, {{1, false}, Density::Busy}};
  for (const auto& [scene, people] : wishes) {
    const Setting setting = hospitalSetting(scene, hospitalOf(people), {});
    EXPECT_TRUE(setting.scene.actors.empty());
    EXPECT_EQ(lyingIn(setting.scene), 0U);
  }
}

}  // namespace
}  // namespace wardslam::synth
