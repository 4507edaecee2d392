#include <stdexcept>
#include <string>

#include "archive_bytes.h"
#include "semantic_map_content.h"
#include "semantic_map_encoding.h"
#include "wardslam/core/errors.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"

namespace wardslam::mrpt_plugin {
namespace {

constexpr std::uint8_t kVersion = 0;
constexpr std::size_t kMostOptions_bytes = 1U << 16U;
constexpr std::size_t kMostContent_bytes = 0xFFFFFFFFU;

template <class Options>
Options readOptionsFrom(mrpt::serialization::CArchive& in) {
  Options options;
  core::readOptions(core::ConfigNode::fromText(readText(in, kMostOptions_bytes), "its options"), options);
  return options;
}

std::runtime_error damaged(const std::string& what) {
  return std::runtime_error("CSemanticMap: the file is damaged here: " + what);
}

}  // namespace

std::uint8_t CSemanticMap::serializeGetVersion() const { return kVersion; }

void CSemanticMap::serializeTo(mrpt::serialization::CArchive& out) const {
  out << genericMapParams << core::writeOptions(insertionOptions) << core::writeOptions(likelihoodOptions)
      << core::writeOptions(renderOptions);
  const core::Bytes bytes = encode(map());
  if (bytes.size() > kMostContent_bytes)
    throw std::runtime_error("CSemanticMap: too large to be written as one object");
  writeBytes(out, bytes);
}

void CSemanticMap::serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version) {
  if (version > kVersion) {
    throw std::runtime_error("CSemanticMap: written by a newer WardSLAM, in version " + std::to_string(version) +
                             " of its format; this one reads up to version " + std::to_string(kVersion) +
                             ": update it");
  }
  try {
    mrpt::maps::TMapGenericParams generic;
    in >> generic;
    const auto insertion = readOptionsFrom<SemanticInsertionOptions>(in);
    const auto likelihood = readOptionsFrom<SemanticLikelihoodOptions>(in);
    const auto render = readOptionsFrom<SemanticRenderOptions>(in);
    content_ = std::make_unique<SemanticMapContent>(
        decodeSemanticMap(readBytes(in, in.ReadAs<std::uint32_t>(), kMostContent_bytes)));
    genericMapParams = generic;
    insertionOptions = insertion;
    likelihoodOptions = likelihood;
    renderOptions = render;
  } catch (const core::BlobError& error) {
    throw damaged(error.what());
  } catch (const core::InputError& error) {
    throw damaged(error.what());
  }
}

}  // namespace wardslam::mrpt_plugin
