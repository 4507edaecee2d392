#pragma once

#include <type_traits>

namespace wardslam::core {

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
