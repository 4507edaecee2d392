#include "mask_survey.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>

#include "mask_file.h"
#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLookedAt = 24;
constexpr std::size_t kNamedInSentence = 8;

/// What the masks looked at so far hold.
class Survey {
 public:
  explicit Survey(const LabelMap& labels) : labels_(labels) {}

  void add(const fs::path& file) {
    const MaskFile mask = readMaskFile(file);
    if (mask.values.empty()) return;  // one that is damaged does not mean that all are
    if (!mask.encoding.empty()) encodings_.insert(mask.encoding);
    std::array<bool, 256> present{};
    for (int y = 0; y < mask.values.rows; ++y) {
      const auto* row = mask.values.ptr<std::uint8_t>(y);
      for (int x = 0; x < mask.values.cols; ++x) present[row[x]] = true;
    }
    for (int value = 0; value < 256; ++value) {
      if (present.at(static_cast<std::size_t>(value))) judge(value);
    }
  }

  [[nodiscard]] bool holdsNoNames() const { return !nameless_.empty() && !hasNamed_; }
  [[nodiscard]] const std::set<std::string>& encodings() const { return encodings_; }

  /// "38, 75, 113"
  [[nodiscard]] std::string nameless() const {
    std::string text;
    std::size_t count = 0;
    for (const int value : nameless_) {
      if (++count > kNamedInSentence) return text + ", …";
      text += (text.empty() ? "" : ", ") + std::to_string(value);
    }
    return text;
  }
  [[nodiscard]] int anyNameless() const { return *nameless_.begin(); }
  [[nodiscard]] bool isBlackAndWhite() const { return nameless_ == std::set<int>{255}; }

 private:
  void judge(int value) {
    const core::ClassId id = labels_.classOf(value);
    if (id == 0) return;  // nothing, or what a label file leaves out
    if (labels_.labels().name(id).empty()) {
      nameless_.insert(value);
    } else {
      hasNamed_ = true;
    }
  }

  const LabelMap& labels_;
  std::set<int> nameless_;
  bool hasNamed_ = false;
  std::set<std::string> encodings_;
};

[[noreturn]] void failNameless(const fs::path& folder, const Survey& survey) {
  if (survey.isBlackAndWhite()) {
    throw core::InputError(
        folder.string() + ": its masks are black and white (0 and 255), and no class has the number " +
        "255; write what white is into a file, 'classes: {255: person}', and give it with --classes " +
        "FILE ('classes: {0: person}' where black is the person)");
  }
  throw core::InputError(folder.string() + ": its masks hold the grey values " + survey.nameless() + ", and no class " +
                         "has any of these numbers; write what they mean into a file, like 'classes: {" +
                         std::to_string(survey.anyNameless()) + ": person}', and give it with --classes FILE");
}

}  // namespace

std::vector<std::string> surveyMasks(const fs::path& folder, const StampedFiles& files, const LabelMap& labels) {
  const MaskFile first = readMaskFile(files.firstFile());
  // One file of the wrong kind means all are; one that is damaged does not.
  if (first.values.empty() && !readUnchanged(files.firstFile()).empty()) throw core::InputError(first.trouble);

  Survey survey(labels);
  const std::size_t step = std::max<std::size_t>(1, files.size() / kLookedAt);
  for (std::size_t i = 0; i < files.size(); i += step) survey.add(files.file(i));
  for (std::size_t i = 0; i < files.size() && step > 1 && survey.holdsNoNames(); ++i) survey.add(files.file(i));
  if (survey.holdsNoNames()) failNameless(folder, survey);

  std::vector<std::string> notes;
  if (!files.clock().isSeconds())
    notes.push_back(folder.string() + ": the name of a mask " + files.clock().sentencePart());
  for (const std::string& encoding : survey.encodings()) notes.push_back(folder.string() + ": masks " + encoding);
  if (const std::string nameless = survey.nameless(); !nameless.empty()) {
    notes.push_back(folder.string() + ": the grey values " + nameless +
                    " name no class and are taken for 0; say what " + "they mean with --classes FILE");
  }
  return notes;
}

}  // namespace wardslam::segmentation
