#include "doctor_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>

#include "bug_report.h"
#include "computer.h"
#include "models/fetch.h"
#include "models/model_manifest.h"
#include "self_test.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/segmentation/segmenter_factory.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;

struct DoctorArguments {
  fs::path out = ".";
  fs::path model;
  fs::path run;
  fs::path bundle;
};

/// The sentence why `work` fails; else what it says.
template <class Work>
Finding attempt(const std::string& subject, const Work& work) {
  try {
    return {Finding::Kind::Good, subject, work()};
  } catch (const std::exception& error) {
    return {Finding::Kind::Trouble, subject, error.what()};
  }
}

Finding tryNetwork(const std::string& what, const segmentation::SegmentationOptions& options) {
  return attempt("network", [&] {
    static_cast<void>(segmentation::makeSegmenter(options));
    return what + " loads";
  });
}

/// The one that comes with the program, the one that is named, and what was fetched.
Findings tryNetworks(const fs::path& model) {
  Findings findings = {tryNetwork("the one that comes with the program", {})};
  if (!model.empty()) {
    segmentation::SegmentationOptions options;
    options.type = segmentation::SegmentationOptions::Type::Yolo;
    options.yolo.model = model.string();
    findings.push_back(tryNetwork(model.filename().string(), options));
  }
  const auto manifest = ModelManifest::fromFile(core::findDataFile("models.yaml"));
  for (const auto& known : manifest.models()) {
    for (const auto& file : known.files) {
      const fs::path fetched = defaultModelFolder() / file.name;
      if (!fs::exists(fetched)) continue;
      findings.push_back(attempt("network", [&] {
        const bool isKnown = verifyFile(file, fetched) == Verification::Matches;
        return file.name + (isKnown ? " is as its makers published it" : " is there; no checksum is known");
      }));
    }
  }
  return findings;
}

void print(const Finding& finding) {
  constexpr int kSubjectWidth = 16;
  const char* const mark = finding.kind == Finding::Kind::Good   ? "good     "
                           : finding.kind == Finding::Kind::Note ? "note     "
                                                                 : "TROUBLE  ";
  std::cout << mark << std::left << std::setw(kSubjectWidth) << finding.subject << finding.text << "\n" << std::flush;
}

void examine(const DoctorArguments& arguments) {
  Findings findings;
  const auto tell = [&findings](const Findings& found) {
    for (const Finding& finding : found) print(findings.emplace_back(finding));
  };
  tell(describeComputer());
  tell(describeLibraries(loadedLibraries()));
  tell(tryNetworks(arguments.model));
  tell({lookForSensors()});
  tell({tryDisk(arguments.out)});
  tell({testTheWholeProgram(fs::temp_directory_path())});
  if (!arguments.bundle.empty()) {
    writeBugReport(arguments.bundle, findings, arguments.run);
    std::cout << arguments.bundle.string() << ": to be sent with a report of a fault; it holds no pictures\n";
  }
  const auto isTrouble = [](const Finding& finding) { return finding.kind == Finding::Kind::Trouble; };
  const auto troubles = std::count_if(findings.begin(), findings.end(), isTrouble);
  if (troubles > 0) {
    throw core::InputError(std::to_string(troubles) + (troubles == 1 ? " thing does" : " things do") +
                           " not work; see TROUBLE above");
  }
}

}  // namespace

void addDoctorCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("doctor", "Find out whether all that a run needs is there and works; exit code 1 when not");
  auto arguments = std::make_shared<DoctorArguments>();
  command->add_option("--out", arguments->out, "folder whose disk is tried; the current one unless given");
  command->add_option("--model", arguments->model, "YOLO segmentation network (ONNX) to be tried, too")
      ->check(CLI::ExistingFile);
  auto* bundle = command->add_option("--bundle", arguments->bundle,
                                     "write a text to be sent with a report of a fault, without pictures");
  command->add_option("--run", arguments->run, "folder of a run; its summary and configuration go into the bundle")
      ->check(CLI::ExistingDirectory)
      ->needs(bundle);
  command->callback([arguments] { examine(*arguments); });
}

}  // namespace wardslam::apps
