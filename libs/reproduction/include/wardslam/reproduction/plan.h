#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wardslam::reproduction {

/// Where an archive of a sequence is published.
struct Archive {
  std::string url;
  double size_bytes = 0.0;  ///< 0: not known.
  std::string sha256;       ///< Empty: not known.

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("url", self.url, "of the official archive, .tgz or .zip");
    visit("size_bytes", self.size_bytes, {0.0, 1e13}, "bytes", "of the archive; 0 = not known");
    visit("sha256", self.sha256, "of the archive; empty = not known");
  }
};

/// A recording with its truth, in the layout of the TUM RGB-D benchmark.
struct Sequence {
  std::string name;
  std::string folder;
  std::string camera;
  std::string masks;
  std::string ground_truth = "groundtruth.txt";
  std::string render;
  Archive fetch;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("name", self.name, "as tables call it; published figures are found by it");
    visit("folder", self.folder, "below the folder of --data; empty = the name");
    visit("camera", self.camera,
          "calibration; relative to this file or to the installed configuration; empty = its own");
    visit("masks", self.masks, "folder of recorded masks, relative to that of the sequence; empty = there are none");
    visit("ground_truth", self.ground_truth, "true poses, relative to the folder of the sequence");
    visit("render", self.render, "arguments of rawlog-synth that make the sequence where it is absent");
    visit.group("fetch", self.fetch);
  }
};

/// How what moves is left out.
enum class Filter {
  Off,
  Geometric,  ///< By geometry alone.
  Paper,      ///< The paper's rule (P7) to the letter, and nothing of ours around it.
  On,         ///< What the program does unless told.
};

struct Variant {
  std::string name;
  Filter filter = Filter::On;
  int n = 21;
  int delta = 55;
  bool match_outliers = false;
  std::string network = "masks";
  std::string config;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("name", self.name, "as tables call it");
    visit("filter", self.filter, {"off", "geometric", "paper", "on"}, "how what moves is left out");
    visit("n", self.n, {1, 255}, "px", "side of the semantic descriptor; odd");
    visit("delta", self.delta, {0, 65024}, "px", "of movers in it that make a movable thing dynamic");
    visit("match_outliers", self.match_outliers,
          "matches whose descriptors differ in a quarter of the cells are dropped (P6)");
    visit("network", self.network,
          "masks (the sequence's own), depth (the network that comes with the program), or an ONNX file of YOLO-seg");
    visit("config", self.config, "configuration to begin with; relative to this file; empty = the defaults");
  }

  /// The parameters that the paper settles on, and no test of match outliers.
  [[nodiscard]] bool isMain() const { return n == 21 && delta == 55 && !match_outliers; }
  [[nodiscard]] bool segments() const { return filter == Filter::Paper || filter == Filter::On; }
};

/// What is to be run: every sequence with every variant, so many times.
struct Plan {
  std::string title;
  int repetitions = 1;
  int key_points_step = 20;
  int max_frames = 0;
  bool mapping = false;
  std::vector<Sequence> sequences;
  std::vector<Variant> variants;
  std::filesystem::path file;

  /// All but the two lists.
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("title", self.title, "what the tables are headed with");
    visit("repetitions", self.repetitions, {1, 1000}, "count", "runs of each sequence with each variant");
    visit("key_points_step", self.key_points_step, {0, 1000}, "count",
          "by which the key points of repetitions differ (1500, 1520, 1480, 1540, …): runs repeat to the digit, and "
          "equal runs tell nothing of scatter");
    visit("max_frames", self.max_frames, {0, 1000000}, "count", "of each sequence that are run; 0 = all");
    visit("mapping", self.mapping, "true, false: build the semantic map as well; trajectories are the same without");
  }
};

/// Throws core::InputError with file, line, key and, for unknown keys and names, the nearest that is known.
[[nodiscard]] Plan readPlan(const std::filesystem::path& file);

/// How many key points more (or less) a repetition has, counted from 0: 0, 1, -1, 2, -2, … steps.
[[nodiscard]] int keyPointsMore(const Plan& plan, int repetition);

}  // namespace wardslam::reproduction
