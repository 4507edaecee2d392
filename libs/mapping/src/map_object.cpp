#include "wardslam/mapping/map_object.h"

namespace wardslam::mapping {

std::string toString(ObjectState state) {
  switch (state) {
    case ObjectState::Static:
      return "static";
    case ObjectState::Moved:
      return "moved";
    case ObjectState::Gone:
      return "gone";
  }
  return "unknown";
}

}  // namespace wardslam::mapping
