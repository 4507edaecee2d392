#include "places/place.h"

#include <algorithm>

#include "hospital/hospital_scene.h"
#include "places/floor_scene.h"
#include "places/ward_scene.h"
#include "wardslam/core/errors.h"

namespace wardslam::synth {

const std::vector<Place>& places() {
  using Options = const PlaceOptions&;
  using Mount = const CameraMount&;
  static const std::vector<Place> all = {
      {"ward", "one room", [](Options options, Mount mount) { return wardSetting(options.scene, mount); }},
      {"floor", "two rooms and a corridor, one round of 41 m a minute",
       [](Options options, Mount mount) { return floorSetting(options.scene, mount); }},
      {"hospital", "a storey of more than 1,500 m2, a round of more than 500 m",
       [](Options options, Mount mount) { return hospitalSetting(options.scene, options.hospital, mount); }},
  };
  return all;
}

Setting buildPlace(const PlaceOptions& options, const CameraMount& mount) {
  const auto place =
      std::find_if(places().begin(), places().end(), [&](const Place& p) { return p.name == options.name; });
  if (place == places().end()) throw core::InputError(options.name + ": no such place; see --scene in --help");
  return place->build(options, mount);
}

}  // namespace wardslam::synth
