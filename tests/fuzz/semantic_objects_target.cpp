#include <cstdlib>
#include <sstream>

#include "fuzz_input.h"
#include "semantic_content.h"
#include "semantic_map_encoding.h"
#include "wardslam/core/blob.h"
#include "wardslam/query/map_query.h"

// What our classes of MRPT hold: the first byte says which, the rest is its content.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wardslam;
  if (size == 0) return 0;
  const core::Bytes content(data + 1, data + size);
  fuzz::mayRefuse<core::BlobError>([&] {
    if (data[0] % 2 == 0) {
      const auto map = mrpt_plugin::decodeSemanticMap(content);
      const query::MapQuery query(map);
      (void)query.objects();
      return;
    }
    mrpt_plugin::CObservationSemanticRGBD observation;
    mrpt_plugin::decodeContent(core::pack(core::BlobKind::Observation, 1, content), observation);
    (void)mrpt_plugin::encodeContent(observation);  // what was read can be written
    constexpr std::size_t kFewKeypoints = 100;
    if (observation.features.size() < kFewKeypoints) (void)observation.semanticDescriptors();
    std::ostringstream text;
    observation.getDescriptionAsText(text);
  });
  return 0;
}
