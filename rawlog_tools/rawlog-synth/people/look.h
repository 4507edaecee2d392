#pragma once

#include "textures/textures.h"

namespace wardslam::synth {

enum class HairStyle { Short, Bun, Long };
enum class Garment { Shirt, Tunic, Coat, Gown };

/// Who somebody is, to the eye.
struct Look {
  float height_m = 1.75F;
  float girth = 1.0F;  ///< 1 = slim, 1.4 = stout.
  HairStyle hair = HairStyle::Short;
  bool bald = false;
  Garment garment = Garment::Shirt;
  bool longSleeves = false;
  Material outfit = Material::OutfitVisitor;
};

}  // namespace wardslam::synth
