#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

// The two entry points that Python calls (training/depthnet/generator.py).
extern "C" int generate_scenes(uint64_t seed, int count, int views, int capacity, float* primitives, int* counts,
                               float* cameras, int threads);
extern "C" int raycast(const float* primitives, const int* counts, int capacity, const float* cameras, int scenes,
                       int width, int height, float* depth, uint8_t* cls, uint8_t* instance, uint8_t* material,
                       void* stream);

namespace wardslam::training {

inline constexpr int kCapacity = 1600;
inline constexpr int kFloats = 28;        // of a primitive
inline constexpr int kCameraFloats = 16;  // R_world_cam (rows), centre [m], fx, fy, cx, cy [px of 640 x 480]

/// Scenes of seeds `seed`, `seed` + 1, ... with a camera in each.
struct Scenes {
  std::vector<float> primitives, cameras;
  std::vector<int> counts;
  int overran = 0;

  Scenes(uint64_t seed, int count, int threads = 2)
      : primitives(std::size_t(count) * kCapacity * kFloats),
        cameras(std::size_t(count) * kCameraFloats),
        counts(std::size_t(count)) {
    overran = generate_scenes(seed, count, 1, kCapacity, primitives.data(), counts.data(), cameras.data(), threads);
  }
  [[nodiscard]] int count() const { return static_cast<int>(counts.size()); }
  /// Primitive k of scene s.
  [[nodiscard]] const float* primitive(int s, int k) const {
    return &primitives[(std::size_t(s) * kCapacity + std::size_t(k)) * kFloats];
  }
  [[nodiscard]] const float* camera(int s) const { return &cameras[std::size_t(s) * kCameraFloats]; }
};

/// What the ray caster makes of scenes: depth [m], class, instance, material per pixel.
struct Images {
  int width, height;
  std::vector<float> depth_m;
  std::vector<uint8_t> cls, instance, material;

  Images(const std::vector<float>& primitives, const std::vector<int>& counts, int capacity,
         const std::vector<float>& cameras, int width_px, int height_px)
      : width(width_px), height(height_px) {
    const std::size_t pixels = counts.size() * std::size_t(width) * std::size_t(height);
    depth_m.resize(pixels), cls.resize(pixels), instance.resize(pixels), material.resize(pixels);
    raycast(primitives.data(), counts.data(), capacity, cameras.data(), static_cast<int>(counts.size()), width, height,
            depth_m.data(), cls.data(), instance.data(), material.data(), nullptr);
  }
  [[nodiscard]] std::size_t at(int u, int v, int scene = 0) const {
    return (std::size_t(scene) * std::size_t(height) + std::size_t(v)) * std::size_t(width) + std::size_t(u);
  }
};

}  // namespace wardslam::training
