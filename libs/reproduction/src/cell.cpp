#include "wardslam/reproduction/cell.h"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "digest.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"

namespace wardslam::reproduction {
namespace {

namespace fs = std::filesystem;
using Segmenter = segmentation::SegmentationOptions::Type;

constexpr const char* kSemanticFilter = "wardslam::filters::SemanticDynamicFilter";
constexpr const char* kGeometricFilter = "wardslam::filters::GeometricMotionFilter";
constexpr const char* kLists[] = {"associations.txt", "rgb.txt",         "depth.txt",
                                  "camera.yaml",      "calibration.txt", "classes.txt"};
constexpr double kPaperOutliers = 0.25;  // 110 of 441 cells

std::string readText(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

fs::path masksOf(const Sequence& sequence, const fs::path& data) {
  return (folderOf(sequence, data) / sequence.masks).lexically_normal();
}

void chooseNetwork(pipeline::SlamOptions& options, const Plan& plan, const Cell& cell, const fs::path& data) {
  const Variant& variant = plan.variants.at(cell.variant);
  if (!variant.segments()) {
    options.segmentation.type = Segmenter::None;
  } else if (variant.network == "masks") {
    options.segmentation.type = Segmenter::RecordedMasks;
    options.segmentation.recorded_masks.folder = fs::absolute(masksOf(plan.sequences.at(cell.sequence), data)).string();
  } else if (variant.network == "depth") {
    options.segmentation.type = Segmenter::Depth;
  } else {
    options.segmentation.type = Segmenter::Yolo;
    options.segmentation.yolo.model = fs::absolute(core::findDataFile(variant.network, plan.file)).string();
  }
}

void set(pipeline::SlamOptions& options, const std::string& key, const std::string& value) {
  if (options.setFilterParameter(kSemanticFilter, key, value)) return;
  throw core::InputError(options.file.string() + ": has no " + kSemanticFilter + ", which the plan has to set '" + key +
                         "' of");
}

/// Nothing of ours around the paper's rule: masks as they are, no wider, for the image they are of.
void takeThePaperToTheLetter(pipeline::SlamOptions& options) {
  options.keepOnlyFilters(kSemanticFilter);
  options.segmentation.refinement.refine_contours = masks::ContourRefinementOptions::Refine::Never;
  set(options, "rule", "paper");
  set(options, "bridge_s", "0");
  set(options, "margin_px", "0");
}

void chooseFilters(pipeline::SlamOptions& options, const Variant& variant) {
  switch (variant.filter) {
    case Filter::Off:
      options.filters = pipeline::SlamOptions::noFilters();
      return;
    case Filter::Geometric:
      options.keepOnlyFilters(kGeometricFilter);
      return;
    case Filter::Paper:
      takeThePaperToTheLetter(options);
      break;
    case Filter::On:
      break;
  }
  set(options, "n", std::to_string(variant.n));
  set(options, "delta", std::to_string(variant.delta));
}

std::string networkDigest(const Variant& variant, const Plan& plan) {
  if (!variant.segments() || variant.network == "masks") return "none";
  if (variant.network == "depth")
    return digestOfFile(core::findDataFile(segmentation::SegmentationOptions{}.depth.model));
  return digestOfFile(core::findDataFile(variant.network, plan.file));
}

}  // namespace

std::vector<Cell> cellsOf(const Plan& plan, const fs::path& out) {
  std::vector<Cell> cells;
  for (int repetition = 0; repetition < plan.repetitions; ++repetition) {
    for (std::size_t sequence = 0; sequence < plan.sequences.size(); ++sequence) {
      for (std::size_t variant = 0; variant < plan.variants.size(); ++variant) {
        const fs::path folder = out / "cells" / plan.sequences[sequence].name / plan.variants[variant].name;
        cells.push_back({sequence, variant, repetition, folder / std::to_string(repetition)});
      }
    }
  }
  return cells;
}

fs::path folderOf(const Sequence& sequence, const fs::path& data) { return data / sequence.folder; }

std::string whyNot(const Plan& plan, const Cell& cell, const fs::path& data) {
  const Sequence& sequence = plan.sequences.at(cell.sequence);
  if (!fs::is_directory(folderOf(sequence, data))) return "missing";
  if (!fs::exists(folderOf(sequence, data) / sequence.ground_truth)) return "no truth";
  const Variant& variant = plan.variants.at(cell.variant);
  const bool wantsMasks = variant.segments() && variant.network == "masks";
  if (wantsMasks && (sequence.masks.empty() || !fs::is_directory(masksOf(sequence, data)))) return "no masks";
  return "";
}

pipeline::SlamOptions optionsOf(const Plan& plan, const Cell& cell, const fs::path& data) {
  const Variant& variant = plan.variants.at(cell.variant);
  auto options = variant.config.empty() ? pipeline::SlamOptions{}
                                        : pipeline::readSlamOptions(core::findDataFile(variant.config, plan.file));
  options.mapping.enabled = plan.mapping;
  chooseNetwork(options, plan, cell, data);
  chooseFilters(options, variant);
  options.odometry.matcher.max_semantic_difference = variant.match_outliers ? kPaperOutliers : 1.0;
  return options;
}

std::string withKeyPoints(const std::string& configuration, int more) {
  if (more == 0) return configuration;
  YAML::Node root = YAML::Load(configuration);
  YAML::Node count = root["features"]["key_points"];
  const int key_points = count.as<int>() + more;
  if (key_points < 50) {
    throw core::InputError("key_points_step: a repetition would have " + std::to_string(key_points) +
                           " key points; 50 are the least");
  }
  count = std::to_string(key_points);
  return YAML::Dump(root) + "\n";
}

fs::path cameraOf(const Plan& plan, std::size_t sequence) {
  const std::string& camera = plan.sequences.at(sequence).camera;
  return camera.empty() ? fs::path() : core::findDataFile(camera, plan.file);
}

std::string contentsOf(const Plan& plan, std::size_t index, const fs::path& data) {
  const Sequence& sequence = plan.sequences.at(index);
  const fs::path folder = folderOf(sequence, data);
  nlohmann::ordered_json contents;
  for (const char* list : kLists) contents[list] = digestOfFile(folder / list);
  for (const char* images : {"rgb", "depth"}) contents[images] = extentOfFolder(folder / images);
  contents["ground_truth"] = digestOfFile(folder / sequence.ground_truth);
  contents["masks"] = sequence.masks.empty() ? "none" : extentOfFolder(masksOf(sequence, data));
  contents["camera"] = sequence.camera.empty() ? "its own" : digestOfFile(cameraOf(plan, index));
  return contents.dump();
}

std::string identityOf(const Plan& plan, const Cell& cell, const std::string& contents,
                       const std::string& configuration, const std::string& version) {
  nlohmann::ordered_json identity;
  identity["version"] = version;
  identity["max_frames"] = plan.max_frames;
  identity["sequence"] = nlohmann::ordered_json::parse(contents);
  identity["network"] = networkDigest(plan.variants.at(cell.variant), plan);
  identity["configuration"] = pipeline::withoutFolders(configuration);
  return identity.dump(2) + "\n";
}

std::optional<RunResult> finishedResult(const Cell& cell, const std::string& identity) {
  if (readText(cell.folder / "cell.json") != identity) return std::nullopt;
  const auto result = nlohmann::json::parse(readText(cell.folder / "result.json"), nullptr, false);
  if (!result.is_object() || !result.contains("evaluation") || !result.contains("trouble")) return std::nullopt;
  try {
    const std::string evaluation = result["evaluation"].is_null() ? "" : result["evaluation"].dump();
    return toRunResult(evaluation, readText(cell.folder / "run" / "summary.json"),
                       result["trouble"].get<std::string>());
  } catch (const std::exception&) {
    return std::nullopt;  // damaged: run it again
  }
}

void beginCell(const Cell& cell, const std::string& identity) {
  std::error_code error;
  fs::remove_all(cell.folder, error);
  fs::create_directories(cell.folder, error);
  if (error) throw core::InputError(cell.folder.string() + ": cannot be made: " + error.message());
  core::writeFileAtomically(cell.folder / "cell.json", identity);
}

RunResult finishCell(const Cell& cell, const std::string& evaluation, const std::string& trouble) {
  const RunResult result = toRunResult(evaluation, readText(cell.folder / "run" / "summary.json"), trouble);
  nlohmann::ordered_json json;
  json["evaluation"] = evaluation.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json::parse(evaluation);
  json["trouble"] = trouble;
  core::writeFileAtomically(cell.folder / "result.json", json.dump(2) + "\n");
  return result;
}

}  // namespace wardslam::reproduction
