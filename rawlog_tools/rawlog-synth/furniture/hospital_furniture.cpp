#include "furniture/hospital_furniture.h"

#include <cmath>

#include "furniture/furniture.h"

namespace wardslam::synth {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

Mesh boxAt(const Vector3f& centre, const Vector3f& size) {
  return box(size).transform(at(centre.x(), centre.y(), centre.z()));
}

Mesh bar(const Vector3f& a, const Vector3f& b, float radius) {
  return rod(a, b, radius, radius, 6).mapUv({0, 0}, {0.15F, (b - a).norm()});
}

/// A tyre with its hub, upright along x, around the point.
void addTyre(Assembly& assembly, const Vector3f& centre, float radius_m, int segments) {
  Mesh tyre;
  constexpr float kTwoPi = 6.2831853F;
  for (int i = 0; i < segments; ++i) {
    const auto pointAt = [&](int k) {
      const float angle = kTwoPi * static_cast<float>(k) / static_cast<float>(segments);
      return Vector3f(centre + radius_m * Vector3f(std::cos(angle), 0, std::sin(angle)));
    };
    tyre.append(rod(pointAt(i), pointAt(i + 1), 0.018F, 0.018F, 5));
  }
  assembly.add(Material::Rubber, tyre);
  for (int i = 0; i < 4; ++i) {  // spokes
    const float angle = 0.785F * static_cast<float>(i);
    const Vector3f spoke = (radius_m - 0.01F) * Vector3f(std::cos(angle), 0, std::sin(angle));
    assembly.add(Material::Metal, bar(centre - spoke, centre + spoke, 0.005F));
  }
}

Vector2f signCell() { return {1.0F / kSignColumns, 1.0F / kSignRows}; }

Mesh signPanel(int cell, const Vector3f& origin, const Vector3f& u, const Vector3f& v) {
  const Vector2f place(static_cast<float>(cell % kSignColumns), static_cast<float>(cell / kSignColumns));
  return panel(origin, u, v).mapUv(place.cwiseProduct(signCell()), signCell());
}

}  // namespace

Surfaces makeWheelchair(cv::RNG& rng) {
  Assembly chair(rng);
  for (const float y : {-0.3F, 0.3F}) {
    addTyre(chair, {-0.08F, y, 0.3F}, 0.28F, 16);
    addTyre(chair, {0.36F, 0.85F * y, 0.09F}, 0.07F, 8);
    const float inner = 0.83F * y;
    chair.add(Material::Metal, bar({-0.24F, inner, 0.3F}, {-0.26F, inner, 0.93F}, 0.013F));
    chair.add(Material::Metal, bar({-0.26F, inner, 0.93F}, {-0.4F, inner, 0.95F}, 0.016F));
    chair.add(Material::Metal, bar({-0.25F, inner, 0.7F}, {0.2F, inner, 0.7F}, 0.013F));
    chair.add(Material::Rubber, boxAt({0.0F, inner, 0.73F}, {0.3F, 0.05F, 0.04F}));
    chair.add(Material::Metal, bar({0.2F, inner, 0.7F}, {0.22F, inner, 0.44F}, 0.013F));
    chair.add(Material::Metal, bar({-0.24F, inner, 0.45F}, {0.24F, inner, 0.45F}, 0.013F));
    chair.add(Material::Metal, bar({0.24F, inner, 0.45F}, {0.5F, inner, 0.14F}, 0.013F));
    chair.add(Material::Plastic, boxAt({0.52F, 0.7F * y, 0.13F}, {0.2F, 0.14F, 0.02F}));
  }
  chair.add(Material::ChairFabric, boxAt({0.0F, 0, 0.49F}, {0.44F, 0.46F, 0.06F}));
  chair.add(Material::ChairFabric, boxAt({-0.24F, 0, 0.7F}, {0.04F, 0.46F, 0.42F}));
  return chair.take();
}

Surfaces makeFoldingScreen(cv::RNG& rng) {
  Assembly screen(rng);
  const float turns[] = {0.45F, 0.0F, -0.45F};
  for (int i = 0; i < 3; ++i) {
    const float y = -0.56F + 0.56F * static_cast<float>(i);
    const Isometry3f wing = at(i == 1 ? 0.0F : -0.12F, y, 0, turns[i]);
    screen.add(Material::Linen, box({0.015F, 0.52F, 1.35F}).transform(wing * at(0, 0, 0.98F)));
    for (const float side : {-0.27F, 0.27F}) {
      screen.add(Material::Metal, bar({0, side, 0.06F}, {0, side, 1.7F}, 0.014F).transform(wing));
      screen.add(Material::Metal, bar({-0.18F, side, 0.05F}, {0.18F, side, 0.05F}, 0.014F).transform(wing));
    }
    screen.add(Material::Metal, bar({0, -0.27F, 1.69F}, {0, 0.27F, 1.69F}, 0.014F).transform(wing));
  }
  return screen.take();
}

Surfaces makeShelf(float width_m, cv::RNG& rng) {
  Assembly shelf(rng);
  constexpr float kDepth_m = 0.42F;
  for (const float side : {-0.5F, 0.5F}) {
    for (const float x : {0.03F, kDepth_m}) {
      const float y = side * width_m;
      shelf.add(Material::Metal, boxAt({x, y, 0.95F}, {0.03F, 0.03F, 1.9F}));
    }
  }
  const Material kinds[] = {Material::Linen, Material::Wood, Material::Plastic, Material::Blanket};
  for (int level = 0; level < 5; ++level) {
    const float z = 0.12F + 0.43F * static_cast<float>(level);
    shelf.add(Material::Metal, boxAt({kDepth_m / 2, 0, z}, {kDepth_m, width_m, 0.025F}));
    for (float y = -width_m / 2 + 0.05F; y + 0.3F < width_m / 2 && level < 4;) {
      const Vector3f size(rng.uniform(0.26F, 0.36F), rng.uniform(0.18F, 0.34F), rng.uniform(0.16F, 0.34F));
      shelf.add(kinds[rng.uniform(0, 4)], boxAt({kDepth_m / 2, y + size.y() / 2, z + 0.013F + size.z() / 2}, size));
      y += size.y() + rng.uniform(0.02F, 0.16F);
    }
  }
  return shelf.take();
}

Surfaces makeCounter(float width_m, cv::RNG& rng) {
  Assembly counter(rng);
  counter.add(Material::Wood, boxAt({0.0F, 0, 0.52F}, {0.08F, width_m, 1.04F}));
  counter.add(Material::Plastic, boxAt({-0.06F, 0, 1.06F}, {0.34F, width_m + 0.04F, 0.04F}));
  counter.add(Material::Wood, boxAt({-0.42F, 0, 0.73F}, {0.76F, width_m, 0.04F}));
  for (const float side : {-0.5F, 0.5F})
    counter.add(Material::Wood, boxAt({-0.4F, side * (width_m - 0.04F), 0.37F}, {0.78F, 0.04F, 0.74F}));
  for (float y = -width_m / 2 + 0.7F; y < width_m / 2 - 0.3F; y += 1.5F) {
    counter.add(Material::Rubber, boxAt({-0.45F, y, 0.96F}, {0.04F, 0.52F, 0.32F}));
    counter.add(Material::Rubber, boxAt({-0.43F, y, 0.78F}, {0.06F, 0.1F, 0.1F}));
    counter.addExact(Material::Screens, panel({-0.475F, y + 0.24F, 0.82F}, {0, -0.48F, 0}, {0, 0, 0.28F}));
    counter.add(Material::Linen, boxAt({-0.1F, y + 0.5F, 1.1F}, {0.22F, 0.3F, rng.uniform(0.01F, 0.06F)}));
  }
  return counter.take();
}

Surfaces makeToilet(cv::RNG& rng) {
  Assembly toilet(rng);
  toilet.add(Material::BareWall, loft({{0, 0.14F, 0.11F, 0.32F},
                                       {0.2F, 0.17F, 0.13F, 0.33F},
                                       {0.4F, 0.27F, 0.19F, 0.38F},
                                       {0.41F, 0.0F, 0.0F, 0.38F}},
                                      14));
  toilet.add(Material::Plastic, boxAt({0.38F, 0, 0.42F}, {0.4F, 0.36F, 0.03F}));
  toilet.add(Material::BareWall, boxAt({0.09F, 0, 0.6F}, {0.18F, 0.4F, 0.42F}));
  for (const float y : {-0.36F, 0.36F}) toilet.add(Material::Metal, bar({0, y, 0.78F}, {0.7F, y, 0.78F}, 0.017F));
  return toilet.take();
}

Surfaces makeBasin(cv::RNG& rng) {
  Assembly basin(rng);
  basin.add(Material::BareWall, loft({{0.68F, 0.08F, 0.1F, 0.2F},
                                      {0.8F, 0.2F, 0.24F, 0.22F},
                                      {0.87F, 0.22F, 0.28F, 0.22F},
                                      {0.86F, 0.17F, 0.23F, 0.23F},
                                      {0.78F, 0.0F, 0.0F, 0.22F}},
                                     14));
  basin.add(Material::BareWall, boxAt({0.06F, 0, 0.4F}, {0.12F, 0.16F, 0.8F}));
  basin.add(Material::Metal, bar({0.05F, 0, 0.87F}, {0.05F, 0, 1.02F}, 0.015F));
  basin.add(Material::Metal, bar({0.05F, 0, 1.02F}, {0.19F, 0, 1.0F}, 0.012F));
  basin.add(Material::Metal, boxAt({0.01F, 0, 1.5F}, {0.02F, 0.5F, 0.65F}));  // mirror
  basin.add(Material::Plastic, boxAt({0.06F, 0.5F, 1.35F}, {0.11F, 0.12F, 0.26F}));
  return basin.take();
}

Surfaces makeDesk(cv::RNG& rng) {
  Assembly desk(rng);
  desk.add(Material::Wood, boxAt({0.35F, 0, 0.73F}, {0.7F, 1.4F, 0.04F}));
  for (const float y : {-0.68F, 0.68F}) desk.add(Material::Metal, boxAt({0.35F, y, 0.36F}, {0.64F, 0.03F, 0.72F}));
  desk.add(Material::Rubber, boxAt({0.2F, 0, 0.97F}, {0.04F, 0.54F, 0.34F}));
  desk.add(Material::Rubber, boxAt({0.18F, 0, 0.78F}, {0.1F, 0.16F, 0.1F}));
  desk.addExact(Material::Screens,
                panel({0.225F, -0.25F, 0.82F}, {0, 0.5F, 0}, {0, 0, 0.3F}).mapUv({0.5F, 0}, {0.5F, 1}));
  desk.add(Material::Linen, boxAt({0.45F, 0.45F, 0.77F}, {0.3F, 0.22F, 0.04F}));
  return desk.take();
}

Surfaces makeDoorLeaf(float width_m, float height_m, float opening_rad, cv::RNG& rng) {
  constexpr float kThickness_m = 0.045F;
  Assembly leaf(rng);
  leaf.add(Material::Wood, boxAt({width_m / 2, 0, height_m / 2}, {width_m, kThickness_m, height_m}));
  for (const float side : {-1.0F, 1.0F}) {
    const float y = side * (kThickness_m / 2 + 0.002F);
    const float begin = side > 0 ? width_m : 0.0F;
    leaf.addExact(Material::DoorLeaf, panel({begin, y, 0}, {-side * width_m, 0, 0}, {0, 0, height_m}));
    leaf.add(Material::Metal,
             bar({width_m - 0.08F, side * 0.06F, 1.03F}, {width_m - 0.22F, side * 0.06F, 1.03F}, 0.011F));
  }
  return placed(leaf.take(), at(0, 0, 0, opening_rad));
}

Surfaces makeWindow(float width_m, float place, cv::RNG& rng) {
  constexpr float kHeight_m = 1.4F;
  Assembly window(rng);
  window.addExact(
      Material::WindowView,
      panel({0.01F, -width_m / 2, 0}, {0, width_m, 0}, {0, 0, kHeight_m}).mapUv({place, 0}, {width_m / 12, 1}));
  window.add(Material::Plastic, boxAt({0.06F, 0, -0.03F}, {0.22F, width_m + 0.1F, 0.05F}));
  window.add(Material::BareWall, boxAt({0.03F, 0, kHeight_m}, {0.06F, width_m + 0.1F, 0.07F}));
  const int panes = std::max(2, static_cast<int>(width_m / 0.9F));
  for (int i = 0; i <= panes; ++i) {
    const float y = width_m * (static_cast<float>(i) / static_cast<float>(panes) - 0.5F);
    window.add(Material::BareWall, boxAt({0.03F, y, kHeight_m / 2}, {0.06F, 0.06F, kHeight_m}));
  }
  return window.take();
}

Surfaces makeSign(int cell, float width_m, cv::RNG& rng) {
  Assembly sign(rng);
  const float height_m = width_m / kSignAspect;
  sign.add(Material::Metal, boxAt({0.008F, 0, 0}, {0.016F, width_m + 0.02F, height_m + 0.02F}));
  sign.addExact(Material::Signs,
                signPanel(cell, {0.02F, -width_m / 2, -height_m / 2}, {0, width_m, 0}, {0, 0, height_m}));
  return sign.take();
}

Surfaces makeHangingSign(int cell, float ceiling_m, cv::RNG& rng) {
  constexpr float kWidth_m = 1.1F;
  constexpr float kBottom_m = 2.25F;
  constexpr float kHeight_m = kWidth_m / kSignAspect;
  Assembly sign(rng);
  sign.add(Material::Metal, boxAt({0, 0, kBottom_m + kHeight_m / 2}, {0.05F, kWidth_m + 0.02F, kHeight_m + 0.02F}));
  for (const float y : {-0.4F, 0.4F})
    sign.add(Material::Metal, bar({0, y, kBottom_m + kHeight_m}, {0, y, ceiling_m}, 0.008F));
  for (const float side : {-1.0F, 1.0F})
    sign.addExact(Material::Signs, signPanel(cell, {side * 0.03F, -side * kWidth_m / 2, kBottom_m},
                                             {0, side * kWidth_m, 0}, {0, 0, kHeight_m}));
  return sign.take();
}

Surfaces makeExtinguisher(cv::RNG& rng) {
  Assembly extinguisher(rng);
  extinguisher.add(Material::Red, rod({0.12F, 0, 0.75F}, {0.12F, 0, 1.2F}, 0.08F, 0.08F, 12));
  extinguisher.add(Material::Rubber, rod({0.12F, 0, 1.2F}, {0.12F, 0, 1.3F}, 0.03F, 0.02F, 8));
  extinguisher.add(Material::Rubber, bar({0.12F, 0.0F, 1.28F}, {0.14F, 0.1F, 0.9F}, 0.01F));
  extinguisher.add(Material::Red, boxAt({0.01F, 0, 1.75F}, {0.02F, 0.2F, 0.2F}));
  return extinguisher.take();
}

Surfaces makeDispenser(cv::RNG& rng) {
  Assembly dispenser(rng);
  dispenser.add(Material::Plastic, boxAt({0.06F, 0, 1.2F}, {0.11F, 0.12F, 0.28F}));
  dispenser.add(Material::Metal, boxAt({0.07F, 0, 1.03F}, {0.14F, 0.1F, 0.02F}));
  return dispenser.take();
}

Surfaces makeWhiteboard(cv::RNG& rng) {
  Assembly board(rng);
  board.add(Material::Metal, boxAt({0.012F, 0, 0}, {0.024F, 1.56F, 1.06F}));
  board.addExact(Material::BareWall, panel({0.027F, -0.75F, -0.5F}, {0, 1.5F, 0}, {0, 0, 1.0F}));
  for (int i = 0; i < 5; ++i) {
    const float y = -0.6F + 0.28F * static_cast<float>(i);
    board.add(Material::Posters, boxAt({0.03F, y, rng.uniform(-0.2F, 0.25F)}, {0.004F, 0.2F, 0.28F}));
  }
  return board.take();
}

}  // namespace wardslam::synth
