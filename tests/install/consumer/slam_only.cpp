#include <wardslam/pipeline/slam_system.h>

/// Links what SLAM needs and nothing else; the test looks at which libraries that brings along.
int main() {
  const wardslam::pipeline::SlamOptions options;
  return options.file.empty() && wardslam::pipeline::SlamOptions::noFilters().exists() ? 0 : 1;
}
