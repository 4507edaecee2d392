#include <mrpt/serialization/CSerializable.h>

#include <algorithm>
#include <string>

#include "fuzz_input.h"
#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"
#include "wardslam/sources/input_damage.h"
#include "wardslam/sources/rawlog_reader.h"

// A rawlog that begins with an observation of ours. Objects of MRPT's own classes are its business: they take sizes of
// images and lists at their word.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wardslam;
  static const bool isRegistered = [] {
    mrpt::rtti::registerClass(CLASS_ID_NAMESPACE(CObservationSemanticRGBD, wardslam::mrpt_plugin));
    return true;
  }();
  static_cast<void>(isRegistered);
  const std::string name = "wardslam::mrpt_plugin::CObservationSemanticRGBD";
  std::string bytes(1, static_cast<char>(0x80U | name.size()));
  bytes += name;
  bytes.append(reinterpret_cast<const char*>(data), size);
  const auto file =
      fuzz::scratch().write("recording.rawlog", reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  fuzz::mayRefuse<sources::InputDamage>([&] {
    sources::RawlogReader reader(file);
    (void)sources::observationsIn(reader.read());
  });
  return 0;
}
