#include "furniture/odd_machine.h"

#include "furniture/furniture.h"

namespace wardslam::synth {

Surfaces makeOddMachine(cv::RNG& rng) {
  Assembly machine(rng);
  machine.add(Material::Plastic, box({0.6F, 0.5F, 0.34F}).transform(at(0, 0, 0.33F)));
  machine.add(Material::ChairFabric, box({0.44F, 0.42F, 0.3F}).transform(at(0.02F, 0, 0.65F, 0.2F)));
  machine.add(Material::Plastic, ellipsoid({0.2F, 0.22F, 0.24F}).transform(at(0.04F, 0, 0.95F)));
  machine.add(Material::Metal, rod({-0.12F, 0.1F, 0.7F}, {-0.12F, 0.1F, 1.55F}, 0.03F, 0.025F));
  machine.add(Material::Metal, rod({-0.12F, 0.1F, 1.53F}, {0.42F, -0.08F, 1.42F}, 0.025F, 0.02F));
  machine.add(Material::Rubber, rod({0.42F, -0.08F, 1.46F}, {0.46F, -0.1F, 1.18F}, 0.05F, 0.11F, 14));
  for (const float y : {-0.2F, 0.0F, 0.2F})
    machine.add(Material::Blanket, rod({0.24F, y, 0.5F}, {0.34F, 0.6F * y, 0.92F}, 0.022F, 0.03F));
  machine.addExact(Material::Screens, panel({-0.2F, -0.12F, 0.86F}, {0, 0.24F, 0}, {-0.06F, 0, 0.18F}));
  for (const float y : {-0.2F, 0.2F}) {
    machine.add(Material::Metal, rod({-0.28F, y, 0.5F}, {-0.38F, y, 1.0F}, 0.014F, 0.014F));
    for (const float x : {-0.24F, 0.24F})
      machine.add(Material::Rubber, rod({x, y - 0.03F, 0.08F}, {x, y + 0.03F, 0.08F}, 0.08F, 0.08F, 12));
  }
  machine.add(Material::Rubber, rod({-0.38F, -0.21F, 1.0F}, {-0.38F, 0.21F, 1.0F}, 0.018F, 0.018F));
  return machine.take();
}

}  // namespace wardslam::synth
