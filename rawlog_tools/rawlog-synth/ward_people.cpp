#include "ward_people.h"

#include "actors.h"
#include "ward_scene.h"

namespace wardslam::synth {
namespace {

constexpr core::ClassId kPerson = 1;

}  // namespace

Walker porterWalk() {
  // Brings the trolley along the aisle and into the gap between two beds, leaves it, rests by the window.
  return Walker({{0.0, {8.3, 3.15}},
                 {1.2, {7.6, 3.0}},
                 {2.8, {6.6, 2.85}},
                 {3.6, {6.15, 2.85}},
                 {4.6, {5.87, 3.05}},
                 {6.4, {5.8, 3.75}},
                 {8.1, {5.8, 3.75}},
                 {9.2, {6.3, 3.45}},
                 {10.5, {7.6, 3.25}},
                 {12.0, {8.4, 2.6}},
                 {30.0, {8.4, 2.6}},
                 {32.0, {6.5, 2.5}},
                 {34.0, {6.5, 2.5}},
                 {36.5, {8.4, 2.6}},
                 {50.0, {8.4, 2.6}}},
                12.0);
}

Walker nurseWalk() {
  // Overtakes the camera, crosses right in front of it, sees to a bed; later comes towards the camera.
  return Walker(
      {{-1.0, {1.0, 3.5}},   {0.0, {2.3, 3.35}},  {1.0, {3.5, 3.2}},  {2.0, {4.25, 2.75}}, {2.9, {4.1, 2.0}},
       {4.0, {3.95, 1.2}},   {12.0, {3.95, 1.2}}, {13.2, {3.9, 2.1}}, {14.4, {3.2, 2.9}},  {16.0, {3.7, 3.5}},
       {17.4, {4.85, 3.65}}, {18.1, {5.35, 3.2}}, {18.9, {6.0, 2.8}}, {19.8, {7.0, 2.75}}, {20.6, {7.5, 2.7}},
       {24.0, {7.5, 2.7}},   {25.8, {5.9, 2.4}},  {27.4, {4.2, 2.3}}, {28.8, {3.95, 1.2}}, {42.0, {3.95, 1.2}}},
      4.0);
}

Walker visitorWalk() {
  // From the table to the bed by the window and back.
  return Walker({{0.0, {7.9, 1.9}},
                 {5.5, {7.9, 1.9}},
                 {7.2, {7.9, 3.0}},
                 {8.4, {8.1, 4.0}},
                 {9.6, {8.15, 4.9}},
                 {24.0, {8.15, 4.9}},
                 {25.2, {8.1, 4.0}},
                 {26.8, {7.9, 2.9}},
                 {28.4, {7.9, 1.9}},
                 {38.0, {7.9, 1.9}}},
                0.0);
}

void addPeople(Scene& scene, std::uint16_t firstId) {
  const auto add = [&](const char* name, const Walker& walk, const Body& body, Material outfit,
                       PushingTime pushing = {}) {
    scene.actors.push_back(
        std::make_unique<PersonActor>(Label{firstId++, name, kPerson, "person"}, walk, body, outfit, pushing));
  };
  add("nurse", nurseWalk(), {1.7F, 0.95F, HairStyle::Bun, Clothing::Tunic}, Material::OutfitNurse);
  add("porter", porterWalk(), {1.82F, 1.1F, HairStyle::Short, Clothing::Shirt}, Material::OutfitPorter,
      {-10.0, kTrolleyLeft_s});
  add("visitor", visitorWalk(), {1.74F, 1.0F, HairStyle::Long, Clothing::Shirt}, Material::OutfitVisitor);
}

}  // namespace wardslam::synth
