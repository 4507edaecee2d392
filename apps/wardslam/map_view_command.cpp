#include "map_view_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <opencv2/core.hpp>

#include "picture_file.h"
#include "stored_map.h"
#include "wardslam/viewer/map_window.h"
#include "wardslam/viewer/perspective_picture.h"
#include "wardslam/viewer/plan_picture.h"

namespace wardslam::apps {
namespace {

struct ViewArguments {
  std::filesystem::path file;
  std::filesystem::path picture;
};

/// The plan, and below it the view from above one corner.
cv::Mat drawBoth(const mapping::SemanticMap& map) {
  const cv::Mat plan = viewer::drawPlan(map);
  const cv::Mat perspective = viewer::drawPerspective(map);
  cv::Mat picture(plan.rows + perspective.rows, std::max(plan.cols, perspective.cols), CV_8UC3, cv::Scalar::all(255));
  plan.copyTo(picture(cv::Rect({(picture.cols - plan.cols) / 2, 0}, plan.size())));
  perspective.copyTo(picture(cv::Rect({(picture.cols - perspective.cols) / 2, plan.rows}, perspective.size())));
  return picture;
}

void view(const ViewArguments& arguments) {
  const auto map = readStoredMap(arguments.file, storage::CloudPart::Include);
  if (arguments.picture.empty()) {
    viewer::showMap(map, arguments.file.filename().string());
    return;
  }
  writePng(arguments.picture, drawBoth(map));
}

}  // namespace

void addMapViewCommand(CLI::App& mapCommand) {
  CLI::App* command = mapCommand.add_subcommand("view", "Look at the map, in a window or as a picture");
  const auto arguments = std::make_shared<ViewArguments>();
  command->add_option("FILE", arguments->file, "a map (.wardmap)")->required();
  command->add_option("--picture", arguments->picture,
                      "write a PNG instead of opening a window: the plan, and the view from above one corner");
  command->callback([arguments] { view(*arguments); });
}

}  // namespace wardslam::apps
