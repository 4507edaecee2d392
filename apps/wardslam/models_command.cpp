#include "models_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "models/fetch.h"
#include "models/model_manifest.h"
#include "models/transfer_progress.h"
#include "support/interruption.h"
#include "support/progress.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/digest.h"
#include "wardslam/core/errors.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;

struct ModelsArguments {
  fs::path manifest;
  fs::path folder;
  std::string name;  ///< Of a network or, for verify, of a file.
};

ModelManifest openManifest(const ModelsArguments& arguments) {
  return ModelManifest::fromFile(arguments.manifest.empty() ? core::findDataFile("models.yaml") : arguments.manifest);
}

fs::path folderOf(const ModelsArguments& arguments) {
  return arguments.folder.empty() ? defaultModelFolder() : arguments.folder;
}

void list(const ModelsArguments& arguments) {
  const auto manifest = openManifest(arguments);
  for (const auto& model : manifest.models()) {
    std::cout << model.name << ": " << model.title << "\n  licence  " << model.licence << "\n  home     "
              << model.homepage << "\n  use      " << model.use << "\n";
    for (const auto& file : model.files) {
      std::cout << "  file     " << file.name << ", "
                << (file.size_bytes ? sizeText(*file.size_bytes) : "size not known") << ", "
                << (file.checksum ? file.checksum->algorithm + " known" : "no checksum known") << "\n";
    }
    std::cout << "\n";
  }
  std::cout << "Nothing of this is part of WardSLAM. `wardslam models fetch NAME` downloads one.\n";
}

void fetchOne(const ModelFile& wanted, const fs::path& folder, const InterruptionGuard& interruption) {
  Fetched fetched;
  {
    TransferProgress progress(std::cerr, standardErrorIsTerminal(), wanted.name);
    fetched = fetchFile(wanted, folder, [&](const DownloadState& state) {
      progress.update(state);
      return !interruption.requested();
    });
  }
  std::cout << fetched.file.string() << ": " << (fetched.wasThere ? "was there already, " : "fetched, ")
            << (fetched.verification == Verification::Matches ? wanted.checksum->algorithm + " as expected"
                                                              : "not verified as no checksum is known")
            << "\n";
}

void fetch(const ModelsArguments& arguments) {
  const auto manifest = openManifest(arguments);
  const Model& model = manifest.find(arguments.name);
  const fs::path folder = folderOf(arguments);
  std::cout << model.title << ", licence " << model.licence << ", from " << model.homepage << "\n" << std::flush;
  const InterruptionGuard interruption;
  for (const auto& file : model.files) fetchOne(file, folder, interruption);
  std::cout << "To use it: " << model.use << "\n";
}

/// Tells what was found; throws where that is not a clear yes.
void verifyOne(const ModelFile& expected, const fs::path& file) {
  if (verifyFile(expected, file) == Verification::Matches) {
    std::cout << file.string() << ": " << expected.checksum->algorithm << " as expected\n";
    return;
  }
  throw core::InputError(file.string() + ": no checksum known; its sha256 is " + core::digestOfFile(file));
}

void verify(const ModelsArguments& arguments) {
  const auto manifest = openManifest(arguments);
  if (manifest.contains(arguments.name)) {
    for (const auto& file : manifest.find(arguments.name).files) verifyOne(file, folderOf(arguments) / file.name);
    return;
  }
  const fs::path file = arguments.name;
  if (!fs::exists(file)) (void)manifest.find(arguments.name);  // tells what names there are
  const ModelFile* expected = manifest.findFile(file.filename().string());
  verifyOne(expected != nullptr ? *expected : ModelFile(), file);
}

CLI::App* addVerb(CLI::App& command, const char* name, const char* help, void (*run)(const ModelsArguments&),
                  const std::shared_ptr<ModelsArguments>& arguments) {
  CLI::App* verb = command.add_subcommand(name, help);
  verb->add_option("--manifest", arguments->manifest, "list of networks (YAML) in place of the installed one");
  verb->callback([arguments, run] { run(*arguments); });
  return verb;
}

}  // namespace

void addModelsCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("models", "List, fetch or verify networks from their official sources");
  command->require_subcommand(1);
  auto arguments = std::make_shared<ModelsArguments>();
  addVerb(*command, "list", "What there is, with licence and size", list, arguments);

  CLI::App* fetching = addVerb(*command, "fetch", "Download one; continues where it broke off", fetch, arguments);
  fetching->add_option("NAME", arguments->name, "as `wardslam models list` shows it")->required();
  fetching->add_option("--to", arguments->folder, "folder for its files; ~/.local/share/wardslam/models without");

  CLI::App* verifying = addVerb(*command, "verify", "Compare size and checksum with the list", verify, arguments);
  verifying->add_option("FILE|NAME", arguments->name, "a file, or the name of a network that was fetched")->required();
  verifying->add_option("--in", arguments->folder, "folder where fetched files lie");
}

}  // namespace wardslam::apps
