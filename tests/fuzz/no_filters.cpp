// In place of the room of filters, which what reads a configuration does not need, and what writes one asks for this.
#include "wardslam/filters/filter_chain.h"

namespace wardslam::filters {

std::string FilterChain::parameters(int /*indent*/) const { return {}; }

}  // namespace wardslam::filters
