#include <array>
#include <opencv2/imgproc.hpp>
#include <string>

#include "textures/paint.h"
#include "textures/texture_painters.h"

namespace wardslam::synth {
namespace {

constexpr int kSize_px = 512;
constexpr std::size_t kPosters = std::size_t{kPosterColumns} * kPosterRows;
const cv::Size kSquare(kSize_px, kSize_px);

const std::array<std::string, kPosters> kTitles = {"WASH YOUR HANDS", "STOP THE FLU", "VISITING HOURS", "WARD B",
                                                   "BED 1",           "BED 2",        "BED 3",          "BED 4",
                                                   "BED 5",           "PAIN SCALE",   "FIRE EXIT",      "MENU",
                                                   "FALL RISK",       "BLOOD DRIVE",  "YOUR TEAM",      "QUIET PLEASE"};

void paintFigure(cv::Mat area, cv::RNG& rng) {
  const int kind = rng.uniform(0, 3);
  const int dots = kind == 0 ? 14 : 4;
  for (int i = 0; i < dots; ++i) {
    const cv::Point centre(rng.uniform(area.cols / 6, area.cols * 5 / 6),
                           rng.uniform(area.rows / 6, area.rows * 5 / 6));
    const int radius = rng.uniform(area.rows / 14, area.rows / 5);
    const cv::Scalar colour = paint::randomColour(rng, 40, 220);
    if (kind == 1) {
      cv::rectangle(area, cv::Rect(centre.x - radius, centre.y - radius / 2, 2 * radius, radius), colour, cv::FILLED);
    } else {
      cv::circle(area, centre, radius, colour, kind == 2 ? 5 : cv::FILLED, cv::LINE_AA);
    }
  }
}

void paintPoster(cv::Mat poster, const std::string& title, cv::RNG& rng) {
  poster.setTo(paint::randomColour(rng, 215, 250));
  const int band = poster.rows / 5;
  cv::Mat head = poster.rowRange(0, band);
  head.setTo(paint::randomColour(rng, 20, 150));
  paint::title(head, title, cv::Scalar::all(250));
  const int margin = poster.cols / 12;
  const int middle = poster.rows * 13 / 20;
  paintFigure(poster(cv::Rect(margin, band, poster.cols - 2 * margin, middle - band)), rng);
  paint::printLines(poster(cv::Rect(margin, middle, poster.cols - 2 * margin, poster.rows - middle - margin)), 14,
                    {70, 60, 60}, rng);
  cv::rectangle(poster, cv::Rect(0, 0, poster.cols, poster.rows), cv::Scalar::all(60), 6);
}

void paintMonitor(cv::Mat screen, cv::RNG& rng) {
  screen.setTo(cv::Scalar(30, 24, 20));
  const std::array<cv::Scalar, 4> colours = {cv::Scalar(80, 230, 80), cv::Scalar(60, 220, 240),
                                             cv::Scalar(240, 180, 70), cv::Scalar(90, 90, 240)};
  for (int trace = 0; trace < 4; ++trace) {
    const int y0 = screen.rows * (2 * trace + 1) / 8;
    const int period = rng.uniform(30, 60);
    cv::Point last(10, y0);
    for (int x = 12; x < screen.cols * 7 / 10; x += 3) {
      const int beat = x % period;
      const cv::Point next(x, y0 - (beat < 6 ? 34 : beat < 10 ? -14 : rng.uniform(0, 4)));
      cv::line(screen, last, next, colours[static_cast<std::size_t>(trace)], 2, cv::LINE_AA);
      last = next;
    }
    cv::putText(screen, std::to_string(rng.uniform(36, 160)), {screen.cols * 3 / 4, y0 + 20}, cv::FONT_HERSHEY_DUPLEX,
                1.2, colours[static_cast<std::size_t>(trace)], 2, cv::LINE_AA);
  }
  cv::rectangle(screen, cv::Rect(0, 0, screen.cols, screen.rows), cv::Scalar(214, 218, 220), 22);
}

void paintTelevision(cv::Mat screen, cv::RNG& rng) {
  screen.setTo(cv::Scalar(170, 120, 60));
  paint::shade(screen, paint::noise(screen.size(), {80, 60}, 4, rng), 60);
  paintFigure(screen, rng);
  cv::Mat ticker = screen.rowRange(screen.rows * 4 / 5, screen.rows);
  ticker.setTo(cv::Scalar(40, 30, 120));
  paint::printLines(ticker, 26, cv::Scalar::all(240), rng);
  cv::rectangle(screen, cv::Rect(0, 0, screen.cols, screen.rows), cv::Scalar(28, 28, 28), 26);
}

}  // namespace

cv::Mat paintWood(cv::RNG& rng) {
  cv::Mat image = paint::plain(kSquare, {128, 170, 204});
  paint::shade(image, paint::noise(kSquare, {230, 18}, 3, rng), 20);
  paint::shade(image, paint::noise(kSquare, {16, 16}, 2, rng), 9);
  paint::scuff(image, 40, 60, rng);
  return image;
}

cv::Mat paintMetal(cv::RNG& rng) {
  cv::Mat image = paint::plain(kSquare, {190, 192, 192});
  paint::shade(image, paint::noise(kSquare, {60, 12}, 3, rng), 20);
  paint::scuff(image, 60, 50, rng);
  return image;
}

cv::Mat paintPlastic(cv::RNG& rng) {
  cv::Mat image = paint::plain(kSquare, {218, 224, 224});
  paint::shade(image, paint::noise(kSquare, {40, 40}, 3, rng), 10);
  for (int i = 0; i < 14; ++i) {  // stickers
    const cv::Rect label(rng.uniform(0, 430), rng.uniform(0, 460), rng.uniform(30, 80), rng.uniform(16, 46));
    image(label).setTo(paint::randomColour(rng, 60, 230));
    paint::printLines(image(label), 8, {50, 50, 50}, rng);
  }
  paint::scuff(image, 50, 60, rng);
  return image;
}

cv::Mat paintRubber(cv::RNG& rng) {
  cv::Mat image = paint::plain(kSquare, {58, 56, 54});
  paint::shade(image, paint::noise(kSquare, {24, 24}, 3, rng), 16);
  return image;
}

cv::Mat paintLinen(cv::RNG& rng) {
  cv::Mat image = paint::plain(kSquare, {226, 230, 232});
  paint::shade(image, paint::noise(kSquare, {90, 40}, 3, rng), 14);  // creases
  paint::shade(image, paint::noise(kSquare, {9, 9}, 2, rng), 7);
  for (int y = 20; y < kSize_px; y += 64) cv::line(image, {0, y}, {kSize_px, y + 6}, {206, 190, 178}, 3, cv::LINE_AA);
  return image;
}

cv::Mat paintBlanket(cv::RNG& rng) {
  cv::Mat image = paint::plain(kSquare, {178, 168, 116});
  for (int y = 0; y < kSize_px; y += 32) {
    for (int x = 0; x < kSize_px; x += 32) {
      if ((x + y) / 32 % 2 == 0) image(cv::Rect(x, y, 32, 32)).setTo(cv::Scalar(196, 190, 148));
      cv::circle(image, {x + 16, y + 16}, rng.uniform(3, 9), paint::randomColour(rng, 110, 215), cv::FILLED,
                 cv::LINE_AA);
    }
  }
  paint::shade(image, paint::noise(kSquare, {100, 60}, 3, rng), 16);
  paint::shade(image, paint::noise(kSquare, {8, 8}, 2, rng), 9);
  return image;
}

cv::Mat paintCurtain(cv::RNG& rng) {
  const cv::Size size(1024, 1024);
  cv::Mat image = paint::plain(size, {158, 150, 70});
  image.rowRange(0, 160).setTo(cv::Scalar(216, 220, 214));  // mesh at the top
  for (int y = 0; y < 160; y += 16) cv::line(image, {0, y}, {size.width, y}, {190, 196, 190}, 3);
  for (int i = 0; i < 420; ++i) {
    const cv::Point centre(rng.uniform(0, size.width), rng.uniform(180, size.height));
    const int radius = rng.uniform(6, 20);
    const cv::Scalar colour(rng.uniform(120, 215), rng.uniform(130, 215), rng.uniform(50, 190));
    cv::ellipse(image, centre, {radius, radius / 2}, rng.uniform(0.0, 180.0), 0, 360, colour, cv::FILLED, cv::LINE_AA);
  }
  paint::shade(image, paint::noise(size, {30, 500}, 3, rng), 16);
  paint::shade(image, paint::noise(size, {10, 10}, 2, rng), 7);
  return image;
}

cv::Mat paintChairFabric(cv::RNG& rng) {
  cv::Mat image = paint::plain(kSquare, {156, 112, 62});
  for (int i = 0; i < 900; ++i) {
    const cv::Point centre(rng.uniform(0, kSize_px), rng.uniform(0, kSize_px));
    cv::circle(image, centre, rng.uniform(2, 6),
               cv::Scalar(rng.uniform(130, 220), rng.uniform(90, 190), rng.uniform(40, 150)), cv::FILLED, cv::LINE_AA);
  }
  paint::shade(image, paint::noise(kSquare, {60, 60}, 4, rng), 18);
  return image;
}

cv::Mat paintPosters(cv::RNG& rng) {
  const cv::Size cell(384, 480);
  cv::Mat image = paint::plain({kPosterColumns * cell.width, kPosterRows * cell.height}, {255, 255, 255});
  for (int i = 0; i < kPosterColumns * kPosterRows; ++i) {
    const cv::Rect area({i % kPosterColumns * cell.width, i / kPosterColumns * cell.height}, cell);
    paintPoster(image(area), kTitles[static_cast<std::size_t>(i)], rng);
  }
  return image;
}

cv::Mat paintScreens(cv::RNG& rng) {
  cv::Mat image = paint::plain({2 * kSize_px, 384}, {0, 0, 0});
  paintMonitor(image.colRange(0, kSize_px), rng);
  paintTelevision(image.colRange(kSize_px, 2 * kSize_px), rng);
  return image;
}

cv::Mat paintLeaves(cv::RNG& rng) {
  cv::Mat image = paint::plain(kSquare, {52, 96, 48});
  for (int i = 0; i < 500; ++i) {
    const cv::Point centre(rng.uniform(0, kSize_px), rng.uniform(0, kSize_px));
    const cv::Scalar colour(rng.uniform(30, 90), rng.uniform(80, 190), rng.uniform(30, 110));
    cv::ellipse(image, centre, {rng.uniform(10, 34), rng.uniform(4, 10)}, rng.uniform(0.0, 180.0), 0, 360, colour,
                cv::FILLED, cv::LINE_AA);
  }
  return image;
}

}  // namespace wardslam::synth
