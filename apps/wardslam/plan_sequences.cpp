#include "plan_sequences.h"

#include <iostream>
#include <sstream>

#include "child_processes.h"
#include "models/download.h"
#include "models/fetch.h"
#include "models/transfer_progress.h"
#include "support/progress.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/reproduction/cell.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;
using reproduction::Plan;
using reproduction::Sequence;

bool isAbsent(const Sequence& sequence, const fs::path& data) {
  return !fs::exists(reproduction::folderOf(sequence, data));
}

/// Where things are made before they get their name. Beside it, so that they can be renamed.
fs::path emptyWorkshop(const fs::path& data, const std::string& name) {
  const fs::path folder = data / (name + ".partial");
  std::error_code error;
  fs::remove_all(folder, error);
  fs::create_directories(folder, error);
  if (error) throw core::InputError(folder.string() + ": cannot be made: " + error.message());
  return folder;
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// The sequence comes last: where it is, its labels are.
void moveIntoPlace(const fs::path& workshop, const Sequence& sequence, const fs::path& data) {
  const fs::path folder = reproduction::folderOf(sequence, data);
  const fs::path labels = folder.string() + "_labels";
  fs::remove_all(labels);
  if (fs::exists(workshop / "sequence_labels")) fs::rename(workshop / "sequence_labels", labels);
  core::replaceFile(workshop / "sequence", folder);
  fs::remove_all(workshop);
}

void render(const Sequence& sequence, const fs::path& data, const InterruptionGuard& interruption) {
  std::cerr << "wardslam: " << sequence.name << ": is rendered by rawlog-synth " << sequence.render << "\n";
  const fs::path workshop = emptyWorkshop(data, sequence.folder);
  auto arguments = wordsOf(sequence.render);
  arguments.insert(arguments.end(), {"--tum", "-o", (workshop / "sequence").string()});
  const std::string program = core::findProgram("rawlog-synth").string();
  const int exitCode = runToEnd(program, arguments, workshop / "out.txt", workshop / "err.txt", interruption);
  if (interruption.requested()) return;
  if (exitCode == 127) throw core::InputError(program + ": cannot be started; it renders '" + sequence.name + "'");
  if (exitCode != 0) {
    throw core::InputError(sequence.name + ": rawlog-synth fails: " + lastLine(workshop / "err.txt"));
  }
  moveIntoPlace(workshop, sequence, data);
}

/// A folder of that name may be the only thing in the archive, or the archive holds what is in it.
fs::path contentsOf(const fs::path& unpacked) {
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(unpacked)) {
    if (entry.path().filename() != "__MACOSX") entries.push_back(entry.path());
  }
  return entries.size() == 1 && fs::is_directory(entries.front()) ? entries.front() : unpacked;
}

/// Both check the checksums that are in every archive.
void unpack(const fs::path& archive, const Sequence& sequence, const fs::path& data,
            const InterruptionGuard& interruption) {
  const fs::path workshop = emptyWorkshop(data, sequence.folder);
  const fs::path unpacked = workshop / "unpacked";
  fs::create_directories(unpacked);
  const bool isZip = sequence.fetch.url.rfind(".zip") == sequence.fetch.url.size() - 4;
  const std::string program = isZip ? "unzip" : "tar";
  const std::vector<std::string> arguments = isZip ? std::vector<std::string>{"-q", archive, "-d", unpacked}
                                                   : std::vector<std::string>{"-xzf", archive, "-C", unpacked};
  const int exitCode = runToEnd(program, arguments, workshop / "out.txt", workshop / "err.txt", interruption);
  if (interruption.requested()) return;
  if (exitCode == 127)
    throw core::InputError(program + ": is not installed (package " + program + "); it unpacks " + archive.string());
  if (exitCode != 0) {
    const std::string why = lastLine(workshop / "err.txt");
    fs::remove(archive);
    fs::remove_all(workshop);
    throw core::InputError(sequence.fetch.url + ": what came is no whole archive (" + why + ") and was deleted");
  }
  core::replaceFile(contentsOf(unpacked), reproduction::folderOf(sequence, data));
  fs::remove_all(workshop);
  fs::remove(archive);
}

ModelFile asFile(const Sequence& sequence) {
  ModelFile file;
  file.name = sequence.fetch.url.substr(sequence.fetch.url.rfind('/') + 1);
  file.url = sequence.fetch.url;
  if (sequence.fetch.size_bytes > 0.0) file.size_bytes = static_cast<std::uint64_t>(sequence.fetch.size_bytes);
  if (!sequence.fetch.sha256.empty()) file.checksum = Checksum{"sha256", sequence.fetch.sha256};
  return file;
}

void fetch(const Sequence& sequence, const fs::path& data, const InterruptionGuard& interruption) {
  std::cerr << "wardslam: " << sequence.name << ": fetched from " << sequence.fetch.url << "\n";
  const ModelFile file = asFile(sequence);
  const fs::path archive = data / file.name;
  fs::create_directories(data);
  if (!fs::exists(archive)) {
    const fs::path partial = archive.string() + ".partial";
    TransferProgress progress(std::cerr, standardErrorIsTerminal(), file.name);
    download(file.url, partial, [&](const DownloadState& state) {
      progress.update(state);
      return !interruption.requested();
    });
    fs::rename(partial, archive);
  }
  try {
    (void)verifyFile(file, archive);
  } catch (const core::InputError&) {
    fs::remove(archive);
    throw;
  }
  unpack(archive, sequence, data, interruption);
}

}  // namespace

void renderAbsent(const Plan& plan, const fs::path& data, const InterruptionGuard& interruption) {
  for (const Sequence& sequence : plan.sequences) {
    if (interruption.requested()) return;
    if (!sequence.render.empty() && isAbsent(sequence, data)) render(sequence, data, interruption);
  }
}

std::vector<std::string> fetchAbsent(const Plan& plan, const fs::path& data, const InterruptionGuard& interruption) {
  std::vector<std::string> troubles;
  for (const Sequence& sequence : plan.sequences) {
    if (interruption.requested()) break;
    if (sequence.fetch.url.empty() || !isAbsent(sequence, data)) continue;
    try {
      fetch(sequence, data, interruption);
    } catch (const Unreachable& error) {
      troubles.emplace_back(error.what());
      break;  // the others are not reachable either
    } catch (const core::InputError& error) {
      troubles.emplace_back(error.what());
    }
  }
  return troubles;
}

}  // namespace wardslam::apps
