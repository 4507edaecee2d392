#pragma once

#include "fuzz_input.h"
#include "wardslam/bags/image_decoding.h"
#include "wardslam/bags/messages.h"

namespace wardslam::fuzz {

/// Reads a message as whatever it might be; the type of its topic is damaged as easily as itself.
inline void readAsAll(const bags::Bytes& message, bags::Wire wire) {
  const auto attempt = [](const auto& read) { mayRefuse<bags::BagDamage>(read); };
  attempt([&] { (void)bags::readHeader(message, wire); });
  attempt([&] { (void)bags::decodeColor(bags::readImage(message, wire)); });
  attempt([&] { (void)bags::decodeDepth(bags::readImage(message, wire)); });
  attempt([&] { (void)bags::decodeColor(bags::readCompressedImage(message, wire)); });
  attempt([&] { (void)bags::decodeDepth(bags::readCompressedImage(message, wire)); });
  attempt([&] { (void)bags::readCameraInfo(message, wire); });
  attempt([&] { (void)bags::readTransforms(message, wire); });
  attempt([&] { (void)bags::readTransform(message, wire); });
  attempt([&] { (void)bags::readFloat32(message, wire); });
  attempt([&] { (void)bags::readText(message, wire); });
  attempt([&] { (void)bags::readOdometry(message, wire); });
  attempt([&] { (void)bags::readImu(message, wire); });
}

}  // namespace wardslam::fuzz
