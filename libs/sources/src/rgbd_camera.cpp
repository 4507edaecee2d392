#include "wardslam/sources/rgbd_camera.h"

#include <algorithm>
#include <vector>

#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/options.h"

namespace wardslam::sources {

RgbdCamera readRgbdCamera(const std::filesystem::path& file) {
  const auto node = core::ConfigNode::fromFile(file);
  RgbdCamera camera;
  core::readOptions(node, camera);  // first, as a key may be missing because it is misspelt
  for (const char* key : {"width", "height", "fx", "fy", "cx", "cy"}) {
    if (!node.child(key).exists()) node.fail(std::string("the key '") + key + "' is missing from this camera file");
  }
  return camera;
}

std::string listCameraFiles() {
  std::vector<std::string> files;
  try {
    for (const auto& entry : std::filesystem::directory_iterator(core::findDataFile("cameras"))) {
      if (entry.path().extension() == ".yaml") files.push_back(entry.path().lexically_normal().string());
    }
  } catch (const core::InputError&) {
    return "(the folder config/cameras was not found)";
  }
  std::sort(files.begin(), files.end());
  std::string list;
  for (const std::string& name : files) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace wardslam::sources
