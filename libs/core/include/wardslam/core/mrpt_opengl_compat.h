#pragma once

#include <type_traits>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::core {

/// Whether threads of one process may draw textures side by side, each in an OpenGL context of its own (2.5.8, Debian
/// 12). MRPT 2.14.7 (Debian 13) keeps one list of textures for the whole process, by numbers that each context gives
/// anew, and throws "Duplicated `key` with different `value`" when the second thread loads its first texture.
constexpr bool kDrawsTexturesInSeveralContexts = MRPT_VERSION < WARDSLAM_MRPT_VERSION(2, 6, 0);

/// White light that shines on all surfaces alike (`ambient`) and from where the light is (`diffuse`), 0..1; nothing
/// gleams. Light: mrpt::opengl::TLightParameters, which holds a colour for each in MRPT 2.5 (Debian 12), one colour and
/// a factor for each in 2.14 (Debian 13).
template <class Light>
void setWhiteLight(Light& light, float ambient, float diffuse) {
  if constexpr (std::is_floating_point_v<decltype(Light::ambient)>) {
    light.color = {1.0F, 1.0F, 1.0F};
    light.ambient = ambient;
    light.diffuse = diffuse;
    light.specular = 0.0F;
  } else {
    light.ambient = {ambient, ambient, ambient, 1.0F};
    light.diffuse = {diffuse, diffuse, diffuse, 1.0F};
    light.specular = {0.0F, 0.0F, 0.0F, 1.0F};
  }
}

}  // namespace wardslam::core
