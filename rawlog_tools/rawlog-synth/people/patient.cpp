#include "people/patient.h"

#include "furniture/furniture.h"
#include "people/person.h"

namespace wardslam::synth {

Surfaces makePatient(int variant) {
  const Material outfit = Material::OutfitPatient;
  const Look looks[] = {{1.66F, 1.0F, HairStyle::Long, false, Garment::Shirt, false, outfit},
                        {1.74F, 1.1F, HairStyle::Short, false, Garment::Shirt, false, outfit},
                        {1.62F, 0.95F, HairStyle::Bun, false, Garment::Shirt, false, outfit}};
  const Look& look = looks[variant % 3];
  Mesh body = posePerson(look, Posture{0.0, 0.0, 0.25});
  // On the back: what was up points to the head end, the front up.
  Eigen::Isometry3f T = Eigen::Isometry3f::Identity();
  T.linear() << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  T.translation() << 0.22F + look.height_m, 0.0F, 0.75F;
  return {{outfit, body.transform(T)}};
}

Surfaces makeCoveredBody(cv::RNG& rng) {
  Assembly cover(rng);
  cover.add(Material::Blanket, ellipsoid({0.66F, 0.38F, 0.29F}, 6, 14).transform(at(1.42F, 0, 0.62F)));
  cover.add(Material::Blanket, ellipsoid({0.17F, 0.28F, 0.36F}, 6, 12).transform(at(1.86F, 0, 0.58F)));
  return cover.take();
}

}  // namespace wardslam::synth
