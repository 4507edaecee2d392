#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "wardslam/segmentation/label_map.h"
#include "wardslam/segmentation/network.h"
#include "wardslam/segmentation/segmenter.h"

namespace wardslam::segmentation {

struct DepthOptions {
  std::string model = "networks/depth_hospital.onnx";
  double person_measured = 0.3;
  double person_unmeasured = 0.8;
  int min_region_px = 100;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// A network that tells the class of every pixel from the depth image alone (depthChannels()), such as the one that
/// comes with the program. It works in the dark. Instances are told apart by depth, and their confidence is the mean
/// probability of their pixels.
///
/// Events, both with an empty result: "segmentation.no_depth" where less than a twentieth of the image was measured,
/// "segmentation.network_failed" where the network could not be run.
class DepthSegmenter : public Segmenter {
 public:
  /// Loads the network and runs it once. The model is looked for as given, then among the installed data.
  /// `classesFile`: label file; empty: the one beside the network that has its name (.yaml). Throws core::InputError
  /// when a file is missing, damaged or not that of a depth network, or the labels do not fit.
  explicit DepthSegmenter(const DepthOptions& options, const std::filesystem::path& classesFile = {},
                          Backend backend = Backend::OpenCv);

  /// With a network that is open already; `source` is for error messages.
  DepthSegmenter(const DepthOptions& options, OpenedNetwork opened, const NetworkSource& source,
                 const std::filesystem::path& classesFile);

  [[nodiscard]] Result segment(const SegmenterInput& input) override;
  [[nodiscard]] const core::LabelSpace& labelSpace() const override { return labels_.labels(); }

 private:
  [[nodiscard]] core::Segmentation see(const SegmenterInput& input);

  DepthOptions options_;
  std::unique_ptr<Network> network_;
  cv::Size input_px_;
  std::vector<int> scoresShape_;
  LabelMap labels_;
  int person_ = -1;  ///< The network's class of people; -1: it knows none.
};

template <class Self, class Visitor>
void DepthOptions::describe(Self& self, Visitor& visit) {
  visit("model", self.model,
        "ONNX file of a network that sees depth alone; the one that comes with the program, or like");
  visit("person_measured", self.person_measured, {0.01, 1.0}, "",
        "probability from which a pixel shows a person, where the camera measured depth");
  visit("person_unmeasured", self.person_unmeasured, {0.01, 1.0}, "",
        "and where it did not: there, the network guesses");
  visit("min_region", self.min_region_px, {1, 1000000}, "px",
        "smallest region of one class that counts as an instance");
}

}  // namespace wardslam::segmentation
