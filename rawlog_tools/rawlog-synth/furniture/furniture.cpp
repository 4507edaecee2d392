#include "furniture/furniture.h"

#include <array>
#include <cmath>

namespace wardslam::synth {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

Mesh boxAt(const Vector3f& centre, const Vector3f& size) {
  return box(size).transform(at(centre.x(), centre.y(), centre.z()));
}

Mesh bar(const Vector3f& a, const Vector3f& b, float radius) {
  return rod(a, b, radius, radius).mapUv({0, 0}, {0.15F, (b - a).norm()});
}

Mesh posterPanel(int poster, const Vector3f& origin, const Vector3f& u, const Vector3f& v) {
  const Vector2f cell(1.0F / kPosterColumns, 1.0F / kPosterRows);
  const int row = poster / kPosterColumns;
  const Vector2f place(static_cast<float>(poster % kPosterColumns), static_cast<float>(row));
  return panel(origin, u, v).mapUv(place.cwiseProduct(cell), cell);
}

void addWheel(Assembly& assembly, float x, float y) {
  assembly.add(Material::Rubber,
               rod({x, y - 0.02F, 0.06F}, {x, y + 0.02F, 0.06F}, 0.06F, 0.06F, 12).mapUv({0, 0}, {0.4F, 0.2F}));
}

void addBedFrame(Assembly& bed) {
  const float half = kBedWidth_m / 2;
  bed.add(Material::Metal, boxAt({kBedLength_m / 2, 0, 0.41F}, {kBedLength_m - 0.1F, kBedWidth_m - 0.08F, 0.07F}));
  bed.add(Material::Metal, boxAt({kBedLength_m / 2, 0, 0.2F}, {1.5F, 0.5F, 0.06F}));
  for (const float x : {0.35F, kBedLength_m - 0.35F}) {
    bed.add(Material::Metal, boxAt({x, 0, 0.3F}, {0.1F, 0.36F, 0.2F}));
    for (const float y : {-half + 0.1F, half - 0.1F}) {
      bed.add(Material::Metal, bar({x, 0, 0.2F}, {x, y, 0.12F}, 0.025F));
      addWheel(bed, x, y);
    }
  }
  for (const float y : {-half, half}) {  // side rails
    bed.add(Material::Metal, bar({0.45F, y, 0.8F}, {1.25F, y, 0.8F}, 0.016F));
    for (const float x : {0.45F, 0.72F, 0.98F, 1.25F})
      bed.add(Material::Metal, bar({x, y, 0.42F}, {x, y, 0.8F}, 0.013F));
  }
}

}  // namespace

void Assembly::add(Material material, Mesh mesh) {
  const Vector2f shift(rng_.uniform(0.0F, 1.0F), rng_.uniform(0.0F, 1.0F));
  addExact(material, mesh.mapUv(shift, {1, 1}));
}

void Assembly::addExact(Material material, const Mesh& mesh) {
  for (Surface& surface : surfaces_) {
    if (surface.material != material) continue;
    surface.mesh.append(mesh);
    return;
  }
  surfaces_.push_back({material, mesh});
}

Surfaces makeBed(int chart, cv::RNG& rng) {
  Assembly bed(rng);
  addBedFrame(bed);
  bed.add(Material::Wood, boxAt({0.03F, 0, 0.72F}, {0.05F, kBedWidth_m, 0.62F}));
  bed.add(Material::Wood, boxAt({kBedLength_m - 0.03F, 0, 0.63F}, {0.05F, kBedWidth_m, 0.46F}));
  bed.add(Material::Linen, boxAt({kBedLength_m / 2, 0, 0.53F}, {kBedLength_m - 0.16F, kBedWidth_m - 0.1F, 0.16F}));
  const float lean = rng.uniform(-0.15F, 0.15F);
  bed.add(Material::Linen, ellipsoid({0.2F, 0.33F, 0.1F}).transform(at(0.34F, 0.02F, 0.66F, lean)));
  const float fold = rng.uniform(0.7F, 1.0F);  // how far the blanket is drawn up
  const float end = kBedLength_m - 0.08F;
  bed.add(Material::Blanket, boxAt({(fold + end) / 2, 0, 0.52F}, {end - fold, kBedWidth_m - 0.02F, 0.22F}));
  bed.add(Material::Linen, boxAt({fold, 0, 0.53F}, {0.16F, kBedWidth_m - 0.01F, 0.225F}));
  bed.add(Material::Blanket, ellipsoid({0.5F, 0.36F, 0.1F}).transform(at(1.35F, 0, 0.62F, lean)));
  bed.addExact(Material::Posters,
               posterPanel(chart, {kBedLength_m + 0.005F, -0.13F, 0.48F}, {0, 0.26F, 0}, {0, 0, 0.32F}));
  return bed.take();
}

Surfaces makeChair(cv::RNG& rng) {
  Assembly chair(rng);
  chair.add(Material::ChairFabric, boxAt({0, 0, 0.46F}, {0.46F, 0.48F, 0.07F}));
  chair.add(Material::ChairFabric, boxAt({-0.22F, 0, 0.77F}, {0.05F, 0.48F, 0.36F}));
  for (const float y : {-0.23F, 0.23F}) {
    chair.add(Material::Metal, bar({0.21F, y, 0}, {0.21F, y, 0.66F}, 0.014F));
    chair.add(Material::Metal, bar({-0.25F, y, 0}, {-0.22F, y, 0.95F}, 0.014F));
    chair.add(Material::Wood, boxAt({0, y, 0.67F}, {0.46F, 0.05F, 0.03F}));
  }
  return chair.take();
}

Surfaces makeBedsideCabinet(cv::RNG& rng) {
  Assembly cabinet(rng);
  cabinet.add(Material::Plastic, boxAt({0, 0, 0.43F}, {0.44F, 0.46F, 0.7F}));
  cabinet.add(Material::Wood, boxAt({0, 0, 0.8F}, {0.48F, 0.5F, 0.04F}));
  for (const float z : {0.2F, 0.44F, 0.67F}) {
    cabinet.add(Material::Wood, boxAt({0.225F, 0, z}, {0.02F, 0.42F, 0.2F}));
    cabinet.add(Material::Metal, bar({0.26F, -0.07F, z + 0.03F}, {0.26F, 0.07F, z + 0.03F}, 0.01F));
  }
  for (const float x : {-0.17F, 0.17F}) {
    for (const float y : {-0.18F, 0.18F}) addWheel(cabinet, x, y);
  }
  cabinet.add(Material::Blanket, boxAt({-0.05F, 0.1F, 0.84F}, {0.2F, 0.15F, 0.04F}));  // a book
  cabinet.add(Material::ChairFabric, rod({0.1F, -0.1F, 0.82F}, {0.1F, -0.1F, 1.0F}, 0.035F, 0.035F, 12));
  cabinet.add(Material::Plastic, rod({0.1F, -0.1F, 1.0F}, {0.1F, -0.1F, 1.06F}, 0.03F, 0.012F, 12));
  return cabinet.take();
}

Surfaces makeIvStand(cv::RNG& rng) {
  Assembly stand(rng);
  stand.add(Material::Metal, bar({0, 0, 0.1F}, {0, 0, 1.95F}, 0.016F));
  for (int i = 0; i < 5; ++i) {
    const float angle = 1.2566F * static_cast<float>(i);
    const Vector3f foot(0.3F * std::cos(angle), 0.3F * std::sin(angle), 0.08F);
    stand.add(Material::Metal, bar({0, 0, 0.16F}, foot, 0.014F));
    addWheel(stand, foot.x(), foot.y());
  }
  for (const float side : {-1.0F, 1.0F}) {
    stand.add(Material::Metal, bar({0, 0, 1.93F}, {0, side * 0.18F, 1.99F}, 0.008F));
    Mesh bag = loft({{0, 0.01F, 0.02F}, {0.05F, 0.025F, 0.06F}, {0.22F, 0.02F, 0.065F}, {0.25F, 0.002F, 0.06F}});
    stand.add(Material::Linen, bag.mapUv({0, 0}, {0.3F, 0.3F}).transform(at(0, side * 0.18F, 1.7F)));
  }
  stand.add(Material::Plastic, boxAt({0.06F, 0, 1.2F}, {0.14F, 0.2F, 0.26F}));
  stand.addExact(Material::Screens,
                 panel({0.14F, -0.07F, 1.2F}, {0, 0.14F, 0}, {0, 0, 0.09F}).mapUv({0, 0}, {0.5F, 1}));
  return stand.take();
}

Surfaces makeTable(cv::RNG& rng) {
  Assembly table(rng);
  table.add(Material::Wood, boxAt({0, 0, 0.73F}, {0.9F, 0.9F, 0.04F}));
  table.add(Material::Metal, bar({0, 0, 0.03F}, {0, 0, 0.72F}, 0.04F));
  table.add(Material::Metal, rod({0, 0, 0}, {0, 0, 0.03F}, 0.28F, 0.26F, 16));
  table.add(Material::ChairFabric, rod({0.2F, 0.2F, 0.75F}, {0.2F, 0.2F, 0.84F}, 0.04F, 0.045F, 12));
  table.addExact(Material::Posters, posterPanel(11, {-0.3F, -0.1F, 0.758F}, {0, -0.21F, 0}, {0.28F, 0, 0}));
  return table.take();
}

Surfaces makePlant(cv::RNG& rng) {
  Assembly plant(rng);
  plant.add(Material::Wood, rod({0, 0, 0}, {0, 0, 0.4F}, 0.16F, 0.21F, 16).mapUv({0, 0}, {1, 0.4F}));
  plant.add(Material::Wood, bar({0, 0, 0.4F}, {0, 0, 1.1F}, 0.02F));
  for (int i = 0; i < 11; ++i) {
    const float angle = 2.4F * static_cast<float>(i);
    const float height = 0.7F + 0.09F * static_cast<float>(i);
    const Eigen::Isometry3f T = at(0.2F * std::cos(angle), 0.2F * std::sin(angle), height, angle);
    plant.add(Material::Leaves, ellipsoid({0.24F, 0.1F, 0.13F}, 6, 10).transform(T));
  }
  return plant.take();
}

Surfaces makeTrashBin(cv::RNG& rng) {
  Assembly bin(rng);
  bin.add(Material::Plastic, boxAt({0, 0, 0.33F}, {0.38F, 0.42F, 0.66F}));
  bin.add(Material::ChairFabric, boxAt({0, 0, 0.69F}, {0.4F, 0.44F, 0.06F}));
  return bin.take();
}

Surfaces makeTrolley(cv::RNG& rng) {
  Assembly trolley(rng);
  for (const float z : {0.24F, 0.56F, 0.88F}) trolley.add(Material::Metal, boxAt({0, 0, z}, {0.8F, 0.5F, 0.03F}));
  for (const float x : {-0.38F, 0.38F}) {
    for (const float y : {-0.23F, 0.23F}) {
      trolley.add(Material::Metal, bar({x, y, 0.1F}, {x, y, 0.98F}, 0.016F));
      addWheel(trolley, x, y);
    }
  }
  for (const float y : {-0.23F, 0.23F}) {
    trolley.add(Material::Metal, bar({-0.38F, y, 0.94F}, {kTrolleyHandleX_m, y, kTrolleyHandleZ_m}, 0.013F));
    trolley.add(Material::Metal, bar({-0.38F, y, 0.96F}, {0.38F, y, 0.96F}, 0.01F));
  }
  trolley.add(Material::Rubber, bar({kTrolleyHandleX_m, -0.23F, kTrolleyHandleZ_m},
                                    {kTrolleyHandleX_m, 0.23F, kTrolleyHandleZ_m}, 0.018F));
  trolley.add(Material::Linen, boxAt({-0.12F, 0.02F, 0.99F}, {0.34F, 0.36F, 0.18F}));
  trolley.add(Material::Plastic, boxAt({0.22F, -0.06F, 0.98F}, {0.2F, 0.26F, 0.16F}));
  trolley.add(Material::Linen, boxAt({0.1F, 0, 0.66F}, {0.5F, 0.4F, 0.17F}));
  trolley.add(Material::Wood, boxAt({-0.1F, 0, 0.35F}, {0.44F, 0.36F, 0.18F}));
  trolley.add(Material::Metal, boxAt({0.25F, 0.1F, 0.36F}, {0.16F, 0.2F, 0.2F}));
  return trolley.take();
}

Surfaces makeCurtain(float length_m, float railLength_m, float ceiling_m, cv::RNG& rng) {
  constexpr float kRail_m = 2.25F;
  constexpr float kHem_m = 0.25F;
  Assembly curtain(rng);
  Mesh cloth = drape({0, 0, kRail_m}, {length_m, 0, kRail_m}, kRail_m - kHem_m, 0.16F, 0.05F);
  const Vector2f place(rng.uniform(0.0F, 1.0F), 0.0F);
  curtain.addExact(Material::Curtain, cloth.mapUv(place, {0.6F * length_m, 0.995F}));
  curtain.add(Material::Metal, bar({0, 0, kRail_m}, {railLength_m, 0, kRail_m}, 0.014F));
  for (const float x : {0.05F, railLength_m - 0.05F})
    curtain.add(Material::Metal, bar({x, 0, kRail_m}, {x, 0, ceiling_m}, 0.01F));
  return curtain.take();
}

Surfaces makePicture(int poster, float width_m, cv::RNG& rng) {
  Assembly picture(rng);
  const float height_m = 1.25F * width_m;
  picture.add(Material::Wood, boxAt({0.01F, 0, 0}, {0.02F, width_m + 0.04F, height_m + 0.04F}));
  picture.addExact(Material::Posters,
                   posterPanel(poster, {0.03F, -width_m / 2, -height_m / 2}, {0, width_m, 0}, {0, 0, height_m}));
  return picture.take();
}

Surfaces makePatientMonitor(cv::RNG& rng) {
  Assembly monitor(rng);
  monitor.add(Material::Plastic, boxAt({0.12F, 0, 0}, {0.12F, 0.4F, 0.32F}));
  monitor.add(Material::Metal, bar({0, 0, 0}, {0.1F, 0, 0}, 0.03F));
  monitor.addExact(Material::Screens,
                   panel({0.19F, -0.18F, -0.13F}, {0, 0.36F, 0}, {0, 0, 0.26F}).mapUv({0, 0}, {0.5F, 1}));
  return monitor.take();
}

Surfaces makeTelevision(cv::RNG& rng) {
  Assembly television(rng);
  television.add(Material::Rubber, boxAt({0.06F, 0, 0}, {0.07F, 1.1F, 0.66F}));
  television.add(Material::Metal, boxAt({0.02F, 0, 0}, {0.04F, 0.3F, 0.3F}));
  television.addExact(Material::Screens,
                      panel({0.105F, -0.54F, -0.32F}, {0, 1.08F, 0}, {0, 0, 0.64F}).mapUv({0.5F, 0}, {0.5F, 1}));
  return television.take();
}

Surfaces makeOutletPanel(cv::RNG& rng) {
  Assembly outlets(rng);
  outlets.add(Material::Plastic, boxAt({0.03F, 0, 0}, {0.06F, 1.3F, 0.2F}));
  const std::array<Material, 3> plugs = {Material::Rubber, Material::Blanket, Material::ChairFabric};
  for (int i = 0; i < 6; ++i) {
    const float y = -0.5F + 0.2F * static_cast<float>(i);
    outlets.add(plugs[static_cast<std::size_t>(i) % plugs.size()], boxAt({0.065F, y, 0}, {0.02F, 0.09F, 0.09F}));
  }
  return outlets.take();
}

}  // namespace wardslam::synth
