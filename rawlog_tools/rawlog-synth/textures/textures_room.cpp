#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "textures/paint.h"
#include "textures/texture_painters.h"

namespace wardslam::synth {
namespace {

constexpr float kFloorPixels_per_m = 220.0F;
constexpr float kCeilingPixels_per_m = 110.0F;
constexpr float kWallPixels_per_m = 220.0F;
constexpr float kChips_per_m2 = 11000.0F / 57.6F;

int pixels(float length_m, float pixels_per_m) { return cvRound(length_m * pixels_per_m); }

/// 1 in the middle, `edge` at the border, over `width_px`: corners of a room get less light.
cv::Mat dimBorder(cv::Size size_px, int width_px, float edge) {
  cv::Mat pattern(size_px, CV_32FC1, cv::Scalar(edge));
  pattern(cv::Rect(width_px, width_px, size_px.width - 2 * width_px, size_px.height - 2 * width_px)).setTo(1.0F);
  cv::blur(pattern, pattern, cv::Size(2 * width_px + 1, 2 * width_px + 1));
  return pattern;
}

cv::Mat softShadows(cv::Size size_px, const RoomShape& room) {
  cv::Mat pattern(size_px, CV_32FC1, cv::Scalar(1.0F));
  for (const cv::Rect2f& footprint : room.footprints_m) {
    const float s = kFloorPixels_per_m;
    const cv::Rect area(cvRound(footprint.x * s), cvRound((room.width_m - footprint.y - footprint.height) * s),
                        cvRound(footprint.width * s), cvRound(footprint.height * s));
    pattern(area & cv::Rect({0, 0}, size_px)).setTo(0.6F);
  }
  const int spread = cvRound(0.16F * kFloorPixels_per_m) | 1;
  cv::GaussianBlur(pattern, pattern, cv::Size(2 * spread + 1, 2 * spread + 1), spread / 2.0);
  return pattern;
}

void paintTileJoints(cv::Mat& image, int tile_px, cv::RNG& rng) {
  for (int y = 0; y < image.rows; y += tile_px) {
    for (int x = 0; x < image.cols; x += tile_px) {
      cv::Mat tile = image(cv::Rect(x, y, tile_px, tile_px) & cv::Rect(0, 0, image.cols, image.rows));
      cv::add(tile, cv::Scalar::all(rng.uniform(-9.0, 9.0)), tile);
      cv::rectangle(image, cv::Rect(x, y, tile_px, tile_px), cv::Scalar(150, 154, 152), 2);
    }
  }
}

void paintScenery(cv::Mat view, cv::RNG& rng) {
  for (int y = 0; y < view.rows; ++y) {
    const double t = static_cast<double>(y) / view.rows;
    view.row(y).setTo(cv::Scalar(250 - 10 * t, 225 + 15 * t, 190 + 45 * t));
  }
  paint::shade(view, paint::noise(view.size(), {120, 40}, 4, rng), 14);
  const int horizon = view.rows * 3 / 5;
  for (int x = 0; x < view.cols;) {  // houses
    const int width = rng.uniform(view.cols / 14, view.cols / 6);
    const int top = horizon - rng.uniform(view.rows / 12, view.rows / 3);
    cv::rectangle(view, {x, top}, {x + width, view.rows},
                  cv::Scalar::all(rng.uniform(150, 205)) + paint::randomColour(rng, -22, 22), cv::FILLED);
    for (int wy = top + 6; wy < view.rows; wy += 16) {
      for (int wx = x + 5; wx + 7 < x + width; wx += 14) {
        cv::rectangle(view, cv::Rect(wx, wy, 7, 9), paint::randomColour(rng, 95, 140), cv::FILLED);
      }
    }
    x += width + rng.uniform(0, view.cols / 20);
  }
  for (int i = 0; i < 240; ++i) {  // trees
    const cv::Point centre(rng.uniform(0, view.cols), rng.uniform(view.rows * 7 / 10, view.rows));
    cv::circle(view, centre, rng.uniform(5, 18),
               cv::Scalar(rng.uniform(80, 120), rng.uniform(140, 195), rng.uniform(95, 150)), cv::FILLED, cv::LINE_AA);
  }
}

void paintWindow(cv::Mat& wall, cv::RNG& rng) {
  const float s = kWallPixels_per_m;
  const cv::Rect opening(wall.cols / 2 - pixels(1.9F, s), wall.rows - pixels(2.3F, s), pixels(3.8F, s),
                         pixels(1.4F, s));
  paintScenery(wall(opening), rng);
  cv::rectangle(wall, opening, cv::Scalar(235, 238, 238), 12);
  for (int i = 1; i < 4; ++i) {
    const int x = opening.x + opening.width * i / 4;
    cv::line(wall, {x, opening.y}, {x, opening.y + opening.height}, cv::Scalar(228, 232, 232), 12);
  }
}

void paintDoor(cv::Mat& wall, cv::RNG& rng) {
  const float s = kWallPixels_per_m;
  const cv::Rect door(wall.cols / 2 - pixels(0.7F, s), wall.rows - pixels(2.15F, s), pixels(1.4F, s), pixels(2.15F, s));
  cv::Mat leaf = wall(door);
  leaf.setTo(cv::Scalar(140, 170, 186));
  paint::shade(leaf, paint::noise(leaf.size(), {14, 160}, 3, rng), 12);
  cv::rectangle(wall, door, cv::Scalar(120, 124, 128), 14);
  cv::line(wall, {door.x + door.width / 2, door.y}, {door.x + door.width / 2, wall.rows}, cv::Scalar(90, 100, 110), 4);
  for (const int side : {0, 1}) {
    const cv::Rect glass(door.x + door.width / 10 + side * door.width / 2, door.y + door.height / 8,
                         door.width * 3 / 10, door.height * 3 / 10);
    wall(glass).setTo(cv::Scalar(190, 180, 160));
    cv::rectangle(wall, glass, cv::Scalar(80, 90, 96), 5);
    cv::rectangle(wall, cv::Rect(door.x + door.width / 2 - 30 + side * 46, door.y + door.height / 2, 14, 60),
                  cv::Scalar(200, 200, 200), cv::FILLED);
    paint::printLines(wall(cv::Rect(glass.x, glass.y + glass.height + 30, glass.width, 40)), 12, {60, 70, 80}, rng);
  }
}

}  // namespace

cv::Mat paintFloor(const RoomShape& room, cv::RNG& rng) {
  cv::Mat image = paint::plain({pixels(room.length_m, kFloorPixels_per_m), pixels(room.width_m, kFloorPixels_per_m)},
                               {182, 192, 196});
  paint::shade(image, paint::noise(image.size(), {90, 90}, 3, rng), 9);
  paint::shade(image, paint::noise(image.size(), {11, 11}, 2, rng), 11);
  const int chips = cvRound(kChips_per_m2 * room.length_m * room.width_m);
  for (int i = 0; i < chips; ++i) {  // of the vinyl
    const cv::Point centre(rng.uniform(0, image.cols), rng.uniform(0, image.rows));
    cv::ellipse(image, centre, {rng.uniform(2, 7), rng.uniform(2, 5)}, rng.uniform(0.0, 180.0), 0, 360,
                cv::Scalar::all(rng.uniform(95, 245)) + paint::randomColour(rng, -14, 14), cv::FILLED, cv::LINE_AA);
  }
  paintTileJoints(image, pixels(0.6F, kFloorPixels_per_m), rng);
  paint::scuff(image, 260, 0.18 * kFloorPixels_per_m, rng);
  cv::GaussianBlur(image, image, {3, 3}, 0);
  paint::light(image, softShadows(image.size(), room));
  paint::light(image, dimBorder(image.size(), pixels(0.5F, kFloorPixels_per_m), 0.72F));
  return image;
}

cv::Mat paintCeiling(const RoomShape& room, cv::RNG& rng) {
  const float s = kCeilingPixels_per_m;
  cv::Mat image = paint::plain({pixels(room.length_m, s), pixels(room.width_m, s)}, {212, 218, 220});
  paint::shade(image, paint::noise(image.size(), {5, 5}, 2, rng), 9);
  paintTileJoints(image, pixels(0.6F, s), rng);
  paint::light(image, dimBorder(image.size(), pixels(0.6F, s), 0.8F));
  for (float x = 1.2F; x + 1.2F < room.length_m; x += 2.4F) {
    for (float y = 1.8F; y + 1.8F < room.width_m; y += 1.8F) {
      const cv::Rect lamp(pixels(x, s), pixels(y, s), pixels(1.2F, s), pixels(0.6F, s));
      cv::rectangle(image, lamp, cv::Scalar::all(255), cv::FILLED);
      for (int i = 1; i < 6; ++i) {
        const int gx = lamp.x + lamp.width * i / 6;
        cv::line(image, {gx, lamp.y}, {gx, lamp.y + lamp.height}, cv::Scalar(215, 220, 222), 2);
      }
      cv::rectangle(image, lamp, cv::Scalar(170, 174, 176), 3);
    }
  }
  return image;
}

cv::Mat paintWall(float length_m, float height_m, WallFeature feature, const cv::Scalar& lowerColour, cv::RNG& rng) {
  const float s = kWallPixels_per_m;
  cv::Mat image = paint::plain({pixels(length_m, s), pixels(height_m, s)}, {212, 226, 232});
  const int railTop = image.rows - pixels(0.95F, s);
  image.rowRange(railTop, image.rows).setTo(lowerColour);
  paint::shade(image, paint::noise(image.size(), {260, 260}, 2, rng), 7);
  paint::shade(image, paint::noise(image.size(), {12, 12}, 2, rng), 8);
  paint::scuff(image, cvRound(45 * length_m), 0.12 * s, rng);
  image.rowRange(image.rows - pixels(0.1F, s), image.rows).setTo(cv::Scalar(112, 120, 122));  // skirting
  if (feature == WallFeature::Window) paintWindow(image, rng);
  if (feature == WallFeature::Door) paintDoor(image, rng);
  paint::light(image, dimBorder(image.size(), pixels(0.35F, s), 0.74F));
  return image;
}

}  // namespace wardslam::synth
