#include "people/people.h"
#include "scene/classes.h"

namespace wardslam::synth {

void addPeople(Scene& scene, std::uint16_t firstId, const PeopleWays& ways) {
  const auto add = [&](const char* name, const Walker& walk, const Look& look, PushingTime pushing = {}) {
    scene.actors.push_back(
        std::make_unique<PersonActor>(Label{firstId++, name, kPerson, "person"}, walk, look, pushing));
  };
  add("nurse", ways.nurse, {1.7F, 0.95F, HairStyle::Bun, false, Garment::Tunic, false, Material::OutfitNurse});
  add("porter", ways.porter, {1.82F, 1.1F, HairStyle::Short, false, Garment::Shirt, false, Material::OutfitPorter},
      ways.porterPushes);
  add("visitor", ways.visitor, {1.74F, 1.0F, HairStyle::Long, false, Garment::Shirt, false, Material::OutfitVisitor});
}

}  // namespace wardslam::synth
