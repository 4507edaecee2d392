#include "hospital/hospital_textures.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "furniture/hospital_furniture.h"
#include "textures/paint.h"
#include "textures/texture_painters.h"

namespace wardslam::synth {
namespace {

constexpr float kPixels_per_m = 125.0F;
constexpr float kCeilingPixels_per_m = 80.0F;

int pixels(float length_m, float pixels_per_m = kPixels_per_m) { return cvRound(length_m * pixels_per_m); }

/// Every building its own colours, all of them those of a hospital.
struct Colours {
  cv::Scalar floor;
  cv::Scalar corridor;
  cv::Scalar ward;
};

Colours choose(cv::RNG& rng) {
  const cv::Scalar floors[] = {{182, 192, 196}, {150, 170, 178}, {178, 176, 158}, {166, 184, 168}};
  const cv::Scalar walls[] = {{214, 200, 176}, {196, 208, 184}, {178, 206, 222}, {190, 196, 218}, {206, 190, 200}};
  const int corridor = rng.uniform(0, 5);
  const int ward = (corridor + rng.uniform(1, 5)) % 5;
  return {floors[rng.uniform(0, 4)], walls[corridor], walls[ward]};
}

void paintTiles(cv::Mat& image, int tile_px, double contrast, const cv::Scalar& joint, cv::RNG& rng) {
  for (int y = 0; y < image.rows; y += tile_px) {
    for (int x = 0; x < image.cols; x += tile_px) {
      cv::Mat tile = image(cv::Rect(x, y, tile_px, tile_px) & cv::Rect({0, 0}, image.size()));
      cv::add(tile, cv::Scalar::all(rng.uniform(-contrast, contrast)), tile);
      cv::rectangle(tile, cv::Rect({0, 0}, tile.size()), joint, 1);
    }
  }
}

cv::Mat paintVinyl(const cv::Scalar& colour, cv::RNG& rng) {
  const int size = pixels(kFloorTexture_m);
  cv::Mat image = paint::plain({size, size}, colour);
  paint::shade(image, paint::noise(image.size(), {50, 50}, 3, rng), 8);
  for (int i = 0; i < 15000; ++i) {  // chips
    const cv::Point centre(rng.uniform(0, size), rng.uniform(0, size));
    cv::ellipse(image, centre, {rng.uniform(1, 5), rng.uniform(1, 4)}, rng.uniform(0.0, 180.0), 0, 360,
                colour * rng.uniform(0.6, 1.25) + paint::randomColour(rng, -12, 12), cv::FILLED, cv::LINE_AA);
  }
  paintTiles(image, pixels(kFloorTile_m), 8.0, colour * 0.8, rng);
  paint::scuff(image, 500, 0.2 * kPixels_per_m, rng);
  cv::GaussianBlur(image, image, {3, 3}, 0);
  return image;
}

cv::Mat paintPanels(cv::RNG& rng) {
  const float s = kCeilingPixels_per_m;
  const int size = pixels(kCeilingTexture_m, s);
  cv::Mat image = paint::plain({size, size}, {212, 218, 220});
  paint::shade(image, paint::noise(image.size(), {5, 5}, 2, rng), 8);
  paintTiles(image, pixels(0.6F, s), 8.0, {165, 170, 168}, rng);
  for (float x = 0.6F; x < kCeilingTexture_m; x += 2.4F) {
    for (float y = 0.6F; y < kCeilingTexture_m; y += 1.8F) {
      const cv::Rect lamp(pixels(x, s), pixels(y, s), pixels(1.2F, s), pixels(0.6F, s));
      cv::rectangle(image, lamp, cv::Scalar::all(255), cv::FILLED);
      cv::rectangle(image, lamp, cv::Scalar(170, 174, 176), 2);
    }
  }
  return image;
}

/// Two colours with a rail's height between them, and marks of use.
cv::Mat paintDado(float height_m, const cv::Scalar& lower, cv::RNG& rng) {
  cv::Mat image = paint::plain({pixels(kWallTexture_m), pixels(height_m)}, {212, 226, 232});
  image.rowRange(image.rows - pixels(0.95F), image.rows).setTo(lower);
  paint::shade(image, paint::noise(image.size(), {150, 150}, 2, rng), 7);
  paint::shade(image, paint::noise(image.size(), {8, 8}, 2, rng), 8);
  paint::scuff(image, 420, 0.12 * kPixels_per_m, rng);
  image.rowRange(image.rows - pixels(0.1F), image.rows).setTo(cv::Scalar(112, 120, 122));  // skirting
  return image;
}

cv::Mat paintTiledWall(float height_m, cv::RNG& rng) {
  cv::Mat image = paint::plain({pixels(kWallTexture_m), pixels(height_m)}, {222, 224, 220});
  cv::Mat tiled = image.rowRange(image.rows - pixels(2.0F), image.rows);
  tiled.setTo(cv::Scalar(216, 208, 196));
  paintTiles(tiled, pixels(0.2F), 9.0, {170, 172, 168}, rng);
  paint::shade(image, paint::noise(image.size(), {40, 40}, 2, rng), 5);
  return image;
}

/// White, and next to nothing on it.
cv::Mat paintBare(float height_m, cv::RNG& rng) {
  cv::Mat image = paint::plain({pixels(kWallTexture_m, 32), pixels(height_m, 32)}, {232, 234, 234});
  paint::shade(image, paint::noise(image.size(), {90, 90}, 1, rng), 1.2);
  return image;
}

cv::Mat paintView(cv::RNG& rng) {
  cv::Mat view = paint::plain({2048, 384}, {235, 225, 205});
  for (int y = 0; y < view.rows; ++y) {
    const double t = static_cast<double>(y) / view.rows;
    view.row(y).setTo(cv::Scalar(250 - 10 * t, 225 + 15 * t, 190 + 45 * t));
  }
  paint::shade(view, paint::noise(view.size(), {160, 50}, 4, rng), 12);
  const int horizon = view.rows * 3 / 5;
  for (int x = 0; x < view.cols;) {
    const int width = rng.uniform(70, 190);
    const int top = horizon - rng.uniform(view.rows / 12, view.rows / 3);
    cv::rectangle(view, {x, top}, {x + width, view.rows},
                  cv::Scalar::all(rng.uniform(150, 205)) + paint::randomColour(rng, -22, 22), cv::FILLED);
    for (int wy = top + 8; wy < view.rows; wy += 20) {
      for (int wx = x + 6; wx + 9 < x + width; wx += 18)
        cv::rectangle(view, cv::Rect(wx, wy, 9, 12), paint::randomColour(rng, 95, 140), cv::FILLED);
    }
    x += width + rng.uniform(0, 90);
  }
  for (int i = 0; i < 320; ++i) {
    const cv::Point centre(rng.uniform(0, view.cols), rng.uniform(view.rows * 7 / 10, view.rows));
    cv::circle(view, centre, rng.uniform(6, 22),
               cv::Scalar(rng.uniform(60, 110), rng.uniform(110, 175), rng.uniform(75, 130)), cv::FILLED, cv::LINE_AA);
  }
  return view;
}

cv::Mat paintDoorLeaf(cv::RNG& rng) {
  cv::Mat leaf = paint::plain({320, 512}, cv::Scalar(140, 170, 186) + paint::randomColour(rng, -24, 24));
  paint::shade(leaf, paint::noise(leaf.size(), {10, 120}, 3, rng), 12);
  leaf.rowRange(440, 512).setTo(cv::Scalar(176, 180, 182));  // kick plate
  const cv::Rect glass(200, 60, 70, 170);
  leaf(glass).setTo(cv::Scalar(196, 188, 172));
  cv::rectangle(leaf, glass, cv::Scalar(80, 90, 96), 4);
  cv::rectangle(leaf, cv::Rect(278, 236, 24, 60), cv::Scalar(205, 205, 205), cv::FILLED);
  cv::rectangle(leaf, cv::Rect({0, 0}, leaf.size()), cv::Scalar(96, 104, 110), 5);
  return leaf;
}

cv::Mat paintSigns(const std::vector<std::string>& texts, cv::RNG& rng) {
  const cv::Size cell(360, 120);
  cv::Mat image = paint::plain({kSignColumns * cell.width, kSignRows * cell.height}, cv::Scalar::all(240));
  const cv::Scalar ground = paint::randomColour(rng, 40, 120);
  const int cells = std::min(static_cast<int>(texts.size()), kSignColumns * kSignRows);
  for (int i = 0; i < cells; ++i) {
    cv::Mat sign = image(cv::Rect({i % kSignColumns * cell.width, i / kSignColumns * cell.height}, cell));
    const std::string& text = texts[static_cast<std::size_t>(i)];
    sign.setTo(text == "EXIT" ? cv::Scalar(60, 140, 20) : ground);
    paint::title(sign, text, cv::Scalar::all(250));
  }
  return image;
}

cv::Mat paintRed(cv::RNG& rng) {
  cv::Mat image = paint::plain({128, 128}, {40, 36, 190});
  paint::shade(image, paint::noise(image.size(), {20, 20}, 2, rng), 12);
  return image;
}

const OutfitColours kPatient{{222, 216, 190}, {214, 206, 190}, {200, 200, 200},
                             {170, 196, 232}, {120, 128, 136}, OutfitColours::Pattern::Scrubs};

}  // namespace

std::map<Material, cv::Mat> paintHospitalTextures(float height_m, const std::vector<std::string>& signs,
                                                  std::uint32_t seed) {
  std::map<Material, cv::Mat> textures = paintTextures(RoomShape{}, seed);
  for (const Material wall : {Material::WallNorth, Material::WallSouth, Material::WallEast, Material::WallWest})
    textures.erase(wall);
  cv::RNG choice((static_cast<std::uint64_t>(seed) << 32U) + 977);
  const Colours colours = choose(choice);
  const auto paint = [&](Material material, auto painter) {
    cv::RNG rng((static_cast<std::uint64_t>(seed) << 32U) + 1000 + static_cast<std::uint64_t>(material));
    textures[material] = painter(rng);
  };
  paint(Material::Floor, [&](cv::RNG& rng) { return paintVinyl(colours.floor, rng); });
  paint(Material::Ceiling, paintPanels);
  paint(Material::CorridorWall, [&](cv::RNG& rng) { return paintDado(height_m, colours.corridor, rng); });
  paint(Material::RoomsWall, [&](cv::RNG& rng) { return paintDado(height_m, colours.ward, rng); });
  paint(Material::TiledWall, [&](cv::RNG& rng) { return paintTiledWall(height_m, rng); });
  paint(Material::BareWall, [&](cv::RNG& rng) { return paintBare(height_m, rng); });
  paint(Material::WindowView, paintView);
  paint(Material::DoorLeaf, paintDoorLeaf);
  paint(Material::Signs, [&](cv::RNG& rng) { return paintSigns(signs, rng); });
  paint(Material::Red, paintRed);
  paint(Material::OutfitPatient, [](cv::RNG& rng) { return paintOutfit(kPatient, rng); });
  return textures;
}

}  // namespace wardslam::synth
