#include "place.h"

#include <algorithm>

#include "floor_scene.h"
#include "hospital/hospital_scene.h"
#include "ward_scene.h"
#include "wardslam/core/errors.h"

namespace wardslam::synth {

const std::vector<Place>& places() {
  static const std::vector<Place> all = {
      {"ward", "one room", wardSetting},
      {"floor", "two rooms and a corridor, one round of 41 m a minute", floorSetting},
      {"hospital", "a storey of more than 1,500 m2, a round of more than 500 m", hospitalSetting},
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
