#pragma once

#include <mrpt/opengl/TLightParameters.h>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::core {

/// White light that shines on no surface in particular (`ambient`) and from the light's direction (`diffuse`), 0..1;
/// nothing shines back. Colours before MRPT 2.14, factors of one colour from there on.
inline void setWhiteLight(mrpt::opengl::TLightParameters& light, float ambient, float diffuse) {
#if MRPT_VERSION >= WARDSLAM_MRPT_VERSION(2, 14, 0)
  light.color = {1.0F, 1.0F, 1.0F};
  light.ambient = ambient;
  light.diffuse = diffuse;
  light.specular = 0.0F;
#else
  light.ambient = {ambient, ambient, ambient, 1.0F};
  light.diffuse = {diffuse, diffuse, diffuse, 1.0F};
  light.specular = {0.0F, 0.0F, 0.0F, 1.0F};
#endif
}

}  // namespace wardslam::core
