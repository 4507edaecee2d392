#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

/// Brushes of the procedural textures. Images are CV_8UC3, colours BGR.
namespace wardslam::synth::paint {

/// Smooth noise of unit amplitude, CV_32FC1: bumps of about `cell_px`, octaves of half the size and amplitude added.
[[nodiscard]] cv::Mat noise(cv::Size size_px, cv::Size2f cell_px, int octaves, cv::RNG& rng);

[[nodiscard]] cv::Mat plain(cv::Size size_px, const cv::Scalar& colour);

/// Adds amplitude * pattern (CV_32FC1) to every channel.
void shade(cv::Mat& image, const cv::Mat& pattern, double amplitude);

/// Multiplies every channel with the pattern (CV_32FC1).
void light(cv::Mat& image, const cv::Mat& pattern);

/// Short marks of use: thin strokes a little darker or brighter than what is below.
void scuff(cv::Mat& image, int count, double length_px, cv::RNG& rng);

/// Lines of dashes that look like print.
void printLines(const cv::Mat& image, int lineHeight_px, const cv::Scalar& colour, cv::RNG& rng);

/// Writes the text as large as fits, centred.
void title(cv::Mat image, const std::string& text, const cv::Scalar& colour);

[[nodiscard]] cv::Scalar randomColour(cv::RNG& rng, int low, int high);

}  // namespace wardslam::synth::paint
