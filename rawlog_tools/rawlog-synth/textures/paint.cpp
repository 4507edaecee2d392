#include "textures/paint.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace wardslam::synth::paint {

cv::Mat noise(cv::Size size_px, cv::Size2f cell_px, int octaves, cv::RNG& rng) {
  cv::Mat sum = cv::Mat::zeros(size_px, CV_32FC1);
  double amplitude = 1.0;
  for (int octave = 0; octave < octaves; ++octave, amplitude /= 2) {
    const auto cells = [octave](int size, float cell) {
      return std::clamp(cvRound(static_cast<float>(size << octave) / cell), 2, size);
    };
    cv::Mat coarse(cells(size_px.height, cell_px.height), cells(size_px.width, cell_px.width), CV_32FC1);
    rng.fill(coarse, cv::RNG::UNIFORM, -amplitude, amplitude);
    cv::Mat fine;
    cv::resize(coarse, fine, size_px, 0, 0, cv::INTER_CUBIC);
    sum += fine;
  }
  return sum;
}

cv::Mat plain(cv::Size size_px, const cv::Scalar& colour) { return {size_px, CV_8UC3, colour}; }

void shade(cv::Mat& image, const cv::Mat& pattern, double amplitude) {
  cv::Mat pattern3;
  cv::merge(std::vector<cv::Mat>(3, pattern * amplitude), pattern3);
  cv::add(image, pattern3, image, cv::noArray(), CV_8UC3);
}

void light(cv::Mat& image, const cv::Mat& pattern) {
  cv::Mat pattern3;
  cv::merge(std::vector<cv::Mat>(3, pattern), pattern3);
  cv::multiply(image, pattern3, image, 1.0, CV_8UC3);
}

void scuff(cv::Mat& image, int count, double length_px, cv::RNG& rng) {
  for (int i = 0; i < count; ++i) {
    const cv::Point from(rng.uniform(0, image.cols), rng.uniform(0, image.rows));
    const double angle = rng.uniform(0.0, CV_PI);
    const double length = rng.uniform(0.2, 1.0) * length_px;
    const cv::Point to = from + cv::Point(cvRound(length * std::cos(angle)), cvRound(length * std::sin(angle)));
    const cv::Vec3b below = image.at<cv::Vec3b>(from);
    const double factor = rng.uniform(0.78, 1.08);
    cv::line(image, from, to, cv::Scalar(below[0], below[1], below[2]) * factor, rng.uniform(1, 3), cv::LINE_AA);
  }
}

void printLines(const cv::Mat& image, int lineHeight_px, const cv::Scalar& colour, cv::RNG& rng) {
  for (int y = lineHeight_px / 2; y + lineHeight_px / 2 < image.rows; y += lineHeight_px) {
    for (int x = 0; x < image.cols;) {
      const int word_px = rng.uniform(lineHeight_px / 2, 3 * lineHeight_px);
      const cv::Rect word(x, y, std::min(word_px, image.cols - x), std::max(1, lineHeight_px / 2));
      if (rng.uniform(0, 6) != 0) image(word).setTo(colour);
      x += word_px + lineHeight_px / 2;
    }
  }
}

void title(cv::Mat image, const std::string& text, const cv::Scalar& colour) {
  int baseline = 0;
  const cv::Size unit = cv::getTextSize(text, cv::FONT_HERSHEY_DUPLEX, 1.0, 2, &baseline);
  const double scale = std::min(0.9 * image.cols / unit.width, 0.7 * image.rows / unit.height);
  const cv::Point origin(cvRound((image.cols - scale * unit.width) / 2),
                         cvRound((image.rows + scale * unit.height) / 2));
  cv::putText(image, text, origin, cv::FONT_HERSHEY_DUPLEX, scale, colour, std::max(1, cvRound(2 * scale)),
              cv::LINE_AA);
}

cv::Scalar randomColour(cv::RNG& rng, int low, int high) {
  const int b = rng.uniform(low, high);
  const int g = rng.uniform(low, high);
  const int r = rng.uniform(low, high);
  return cv::Scalar(b, g, r);
}

}  // namespace wardslam::synth::paint
