#include "shown_tile.h"

namespace wardslam::mapping {

SemanticCloudTile shownOf(const Tile& tile, const Part& part, const CloudOptions& options) {
  const ObjectDatabase& objects = part.objects;
  SemanticCloudTile shown;
  for (const CloudPoint& point : tile.points) {
    if (point.sightings < options.min_sightings) continue;
    if (point.sigma_m > static_cast<float>(options.max_sigma_m)) continue;
    SemanticPoint& p = shown.points.emplace_back();
    p.p_cam_m = point.p_cam_m;
    for (std::size_t i = 0; i < 3; ++i) {
      p.color_rgb[i] = cv::saturate_cast<std::uint8_t>(point.color_rgb[static_cast<Eigen::Index>(i)]);
    }
    p.sightings = point.sightings;
    const auto record = objects.objects().find(point.object);
    if (record == objects.objects().end()) continue;
    p.classId = record->second.classId();
    if (part.table.rows().count(point.object) > 0) p.object = point.object;
  }
  return shown;
}

}  // namespace wardslam::mapping
