#include "wardslam/sources/rawlog_reader.h"

#include <mrpt/img/CImage.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <optional>
#include <regex>
#include <string>

#include "rawlog_input.h"
#include "wardslam/sources/external_images.h"
#include "wardslam/sources/input_damage.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;
using mrpt::serialization::CSerializable;

/// Naming two of its classes is what makes the linker keep mrpt-maps, which registers all of them when it is loaded.
void registerMapClasses() {
  mrpt::rtti::registerClass(CLASS_ID(mrpt::obs::CObservationPointCloud));
  mrpt::rtti::registerClass(CLASS_ID(mrpt::obs::CObservationRotatingScan));
}

/// The class named in MRPT's complaint about an object it cannot create.
std::optional<std::string> unregisteredClass(const std::string& complaint) {
  static const std::regex kComplaint("class '([^']*)' which is not registered");
  std::smatch match;
  if (!std::regex_search(complaint, match, kComplaint)) return std::nullopt;
  return match[1].str();
}

/// "CImage, version 10", of an object in a version that this MRPT does not know; nothing where it complains of
/// something else. `bytes` begin with the name of the object as a whole.
std::optional<std::string> newerObject(const std::string& complaint, const std::vector<std::uint8_t>& bytes) {
  static const std::regex kVersion("unknown serialization version number: '?(\\d+)");
  static const std::regex kPlace("([A-Za-z0-9_]+)(?:::serializeFrom|\\.cpp:)");
  std::smatch version;
  if (!std::regex_search(complaint, version, kVersion)) return std::nullopt;
  std::smatch place;
  std::string name = "an object";
  if (std::regex_search(complaint, place, kPlace)) {
    name = place[1].str();
  } else if (bytes.size() > 1 && bytes.size() > std::size_t{1} + (bytes[0] & 0x7FU)) {
    name.assign(bytes.begin() + 1, bytes.begin() + 1 + (bytes[0] & 0x7F));
  }
  return name + ", version " + version[1].str();
}

}  // namespace

class RawlogReader::Input {
 public:
  explicit Input(const fs::path& file) : stream(file), archive(stream) {}

  RawlogInput stream;
  mrpt::serialization::CArchiveStreamBase<RawlogInput> archive;
};

RawlogReader::RawlogReader(const fs::path& file) : input_(std::make_unique<Input>(file)) {
  registerMapClasses();
  if (const auto images = findImageFolder(file)) mrpt::img::CImage::setImagesPathBase(images->string());
}

RawlogReader::~RawlogReader() = default;

std::shared_ptr<CSerializable> RawlogReader::read() {
  if (ended_) return nullptr;
  input_->stream.forget();
  try {
    auto object = input_->archive.ReadObject();
    ++objects_;
    return object;
  } catch (const std::exception& error) {
    ended_ = true;
    if (const auto name = unregisteredClass(error.what())) {
      throw InputDamage("sources.rawlog_unknown_class", "holds an object of class " + *name +
                                                            ", which this program does not know; remove such " +
                                                            "objects with rawlog-cut and the plug-in that has it (-p)");
    }
    if (const auto object = newerObject(error.what(), bytes())) {
      throw InputDamage("sources.rawlog_newer", "was written by a newer MRPT (" + *object + "), which this one " +
                                                    "cannot read; read it on a system that has that MRPT, or record " +
                                                    "with this one");
    }
    if (input_->stream.remembered().empty()) return nullptr;  // not one byte of a further object: a proper end
    throw InputDamage("sources.rawlog_truncated", "is cut off or damaged; copy or record it again");
  }
}

const std::vector<std::uint8_t>& RawlogReader::bytes() const { return input_->stream.remembered(); }

double RawlogReader::fraction() const { return input_->stream.fraction(); }

std::vector<mrpt::obs::CObservation::Ptr> observationsIn(const CSerializable::Ptr& object) {
  if (const auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(object)) return {observation};
  const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object);
  if (!frame) return {};
  return {frame->begin(), frame->end()};
}

}  // namespace wardslam::sources
