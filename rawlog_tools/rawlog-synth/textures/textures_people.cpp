#include <opencv2/imgproc.hpp>

#include "textures/paint.h"
#include "textures/texture_painters.h"

namespace wardslam::synth {
namespace {

constexpr int kSize_px = 1024;

cv::Mat part(cv::Mat& image, const cv::Rect2f& uv) {
  const cv::Size2f size(image.size());
  return image(cv::Rect(cvRound(uv.x * size.width), cvRound(uv.y * size.height), cvRound(uv.width * size.width),
                        cvRound(uv.height * size.height)));
}

void cloth(cv::Mat area, const cv::Scalar& colour, cv::RNG& rng) {
  area.setTo(colour);
  paint::shade(area, paint::noise(area.size(), {static_cast<float>(area.cols) / 8, 60}, 3, rng), 14);  // folds
  paint::shade(area, paint::noise(area.size(), {6, 6}, 1, rng), 6);
}

/// What has neither badge nor print.
void paintPrivateShirt(cv::Mat area, const OutfitColours& colours) {
  const int w = area.cols;
  const int h = area.rows;
  const cv::Scalar dark = colours.shirt * 0.6;
  const auto both = [&](int halfWidth, int from, int to, const cv::Scalar& colour) {  // across the seam at the front
    cv::rectangle(area, cv::Rect(0, from, halfWidth, to - from), colour, cv::FILLED);
    cv::rectangle(area, cv::Rect(w - halfWidth, from, halfWidth, to - from), colour, cv::FILLED);
  };
  switch (colours.pattern) {
    case OutfitColours::Pattern::Coat:
      both(w / 14, h / 3, h, colours.trousers * 0.5 + cv::Scalar(110, 90, 60));  // the shirt below
      both(4, 0, h / 3, dark);
      for (const int x : {w / 8, w - w / 8 - 60}) cv::rectangle(area, cv::Rect(x, h / 4, 60, 70), dark, 3);
      break;
    case OutfitColours::Pattern::Gown:
      for (int y = 12; y < h; y += 36) {
        for (int x = (y / 36) % 2 * 18; x < w; x += 36) cv::circle(area, {x, y}, 4, dark, cv::FILLED, cv::LINE_AA);
      }
      break;
    case OutfitColours::Pattern::Checked:
      for (int y = 0; y < h; y += 48) cv::rectangle(area, cv::Rect(0, y, w, 10), dark, cv::FILLED);
      for (int x = 0; x < w; x += 48) cv::rectangle(area, cv::Rect(x, 0, 10, h), dark, cv::FILLED);
      both(3, 0, h, colours.shirt * 0.4);
      break;
    default:
      both(10, h * 17 / 20, h, dark);  // the neck of it
      break;
  }
  cv::rectangle(area, cv::Rect(0, 0, w, 8), dark, cv::FILLED);
}

/// v = 0 is the hem, v = 1 the neck; the front lies around u = 0 (and 1), the back around u = 0.5.
void paintShirt(cv::Mat area, const OutfitColours& colours, cv::RNG& rng) {
  cloth(area, colours.shirt, rng);
  const int w = area.cols;
  const int h = area.rows;
  const cv::Scalar dark = colours.shirt * 0.55;
  const cv::Scalar pale = colours.shirt * 0.4 + cv::Scalar::all(150);
  switch (colours.pattern) {
    case OutfitColours::Pattern::Striped:
      for (int y = 0; y < h; y += 56) cv::rectangle(area, cv::Rect(0, y, w, 22), pale, cv::FILLED);
      break;
    case OutfitColours::Pattern::Scrubs:
      for (int i = 0; i < 70; ++i) {
        cv::circle(area, {rng.uniform(0, w), rng.uniform(0, h)}, rng.uniform(3, 7), pale, cv::FILLED, cv::LINE_AA);
      }
      [[fallthrough]];
    case OutfitColours::Pattern::Polo:
      cv::rectangle(area, cv::Rect(0, 0, w, 16), dark, cv::FILLED);
      cv::rectangle(area, cv::Rect(w / 2 - 70, h * 11 / 20, 140, 60), pale, cv::FILLED);  // print on the back
      paint::printLines(area(cv::Rect(w / 2 - 60, h * 11 / 20 + 8, 120, 44)), 16, dark, rng);
      break;
    case OutfitColours::Pattern::Plain:
    case OutfitColours::Pattern::Coat:
    case OutfitColours::Pattern::Gown:
    case OutfitColours::Pattern::Checked:
      paintPrivateShirt(area, colours);
      return;
  }
  cv::rectangle(area, cv::Rect(26, h * 13 / 20, 34, 44), cv::Scalar::all(242), cv::FILLED);  // name badge
  paint::printLines(area(cv::Rect(28, h * 13 / 20 + 16, 30, 26)), 8, {120, 60, 40}, rng);
  cv::rectangle(area, cv::Rect(w - 70, h / 4, 50, 60), dark, 3);  // pocket
  cv::line(area, {1, h / 3}, {1, h}, dark, 4);
}

/// v = 0 is the chin, v = 1 the crown; the face lies around u = 0.5.
void paintFace(cv::Mat area, const OutfitColours& colours, cv::RNG& rng) {
  cloth(area, colours.skin, rng);
  const int w = area.cols;
  const int h = area.rows;
  for (const int side : {-1, 1}) {
    const cv::Point eye(w / 2 + side * w * 7 / 100, h * 53 / 100);
    cv::ellipse(area, eye, {w / 38, h / 48}, 0, 0, 360, cv::Scalar::all(245), cv::FILLED, cv::LINE_AA);
    cv::circle(area, eye, w / 72, {60, 50, 40}, cv::FILLED, cv::LINE_AA);
    const cv::Point brow(eye.x, eye.y + h / 15);
    cv::line(area, brow - cv::Point(w / 26, 0), brow + cv::Point(w / 26, side * -4), colours.hair, h / 70, cv::LINE_AA);
    const cv::Point cheek(w / 2 + side * w / 9, h * 36 / 100);
    cv::circle(area, cheek, w / 26, colours.skin * 0.94 + cv::Scalar(0, 0, 14), cv::FILLED, cv::LINE_AA);
  }
  cv::ellipse(area, {w / 2, h * 27 / 100}, {w / 22, h / 55}, 0, 0, 360, {110, 110, 190}, cv::FILLED, cv::LINE_AA);
}

}  // namespace

cv::Mat paintOutfit(const OutfitColours& colours, cv::RNG& rng) {
  cv::Mat image = paint::plain({kSize_px, kSize_px}, colours.skin);
  paintShirt(part(image, outfit::kShirt), colours, rng);
  cloth(part(image, outfit::kTrousers), colours.trousers, rng);
  cloth(part(image, outfit::kSleeve), colours.shirt, rng);
  paintFace(part(image, outfit::kFace), colours, rng);
  cloth(part(image, outfit::kSkin), colours.skin, rng);
  cloth(part(image, outfit::kHair), colours.hair, rng);
  paint::shade(image, paint::noise(image.size(), {9, 9}, 1, rng), 4);
  cloth(part(image, outfit::kShoes), colours.shoes, rng);
  return image;
}

}  // namespace wardslam::synth
