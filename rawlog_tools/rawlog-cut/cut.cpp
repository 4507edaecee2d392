#include "cut.h"

#include <mrpt/serialization/CSerializable.h>

#include <iostream>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "image_names.h"
#include "recording/rawlog_writer.h"
#include "support/progress.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/external_images.h"
#include "wardslam/sources/input_damage.h"
#include "wardslam/sources/rawlog_reader.h"

namespace wardslam::rawlog_cut {
namespace {

namespace fs = std::filesystem;

void requireOther(const fs::path& output, const fs::path& input) {
  std::error_code absent;
  if (!fs::equivalent(output, input, absent)) return;
  throw core::InputError(output.string() + ": is the input, which is never changed; give another -o");
}

std::string quoted(const std::map<std::string, std::size_t>& labels) {
  std::string text;
  for (const auto& [label, count] : labels) text += (text.empty() ? "'" : ", '") + label + "'";
  return text.empty() ? "none" : text;
}

void requireKnown(const std::set<std::string>& labels, const Tally& read, const fs::path& input) {
  for (const std::string& label : labels) {
    if (read.observations.count(label) > 0) continue;
    throw core::InputError(input.string() + ": no sensor is labelled '" + label + "'; its labels are " +
                           quoted(read.observations));
  }
}

/// The images beside a rawlog, of which the output gets those it names.
class Images {
 public:
  Images(const fs::path& input, const fs::path& output)
      : from_(sources::findImageFolder(input)),
        to_(output.parent_path() / (output.stem().string() + "_Images")),
        partial_(to_.string() + ".partial") {
    if (!from_) return;
    if (fs::exists(to_)) {
      throw core::InputError(to_.string() + ": is there already, and would pass for the images of " + output.string() +
                             "; give another -o");
    }
    names_.emplace(*from_);
  }
  ~Images() {
    std::error_code ignored;
    if (from_) fs::remove_all(partial_, ignored);
  }
  Images(const Images&) = delete;
  Images& operator=(const Images&) = delete;

  void lookIn(const std::vector<std::uint8_t>& object) {
    if (names_) names_->lookIn(object);
  }

  void commit() {
    if (!names_ || names_->named().empty()) return;
    try {
      for (const std::string& name : names_->named()) copy(name);
      fs::rename(partial_, to_);
    } catch (const fs::filesystem_error& error) {
      throw core::InputError(to_.string() + ": cannot be made, the images of the output: " + error.code().message());
    }
  }

 private:
  void copy(const std::string& name) const {
    fs::create_directories((partial_ / name).parent_path());
    std::error_code otherFileSystem;
    fs::create_hard_link(*from_ / name, partial_ / name, otherFileSystem);
    if (otherFileSystem) fs::copy_file(*from_ / name, partial_ / name, fs::copy_options::overwrite_existing);
  }

  std::optional<fs::path> from_;
  fs::path to_;
  fs::path partial_;
  std::optional<ImageNames> names_;
};

/// The work of one cut.
class Cut {
 public:
  explicit Cut(const CutJob& job)
      : job_(job), reader_(job.input), judge_(job.selection), images_(job.input, job.output), writer_(job.output) {}

  CutReport perform(const apps::InterruptionGuard& interruption) {
    try {
      workThrough(interruption);
    } catch (const sources::InputDamage& damage) {
      // Of a rawlog that is cut off nothing more can be had; behind an unknown object there may be hours.
      if (damage.event() == "sources.rawlog_unknown_class")
        throw core::InputError(job_.input.string() + ": " + damage.what());
      report_.trouble = damage.what();
    }
    requireSense();
    commit();
    return report_;
  }

 private:
  void workThrough(const apps::InterruptionGuard& interruption) {
    apps::Progress progress(std::cerr, apps::standardErrorIsTerminal(), "object", std::nullopt);
    while (const auto object = reader_.read()) {
      if (interruption.requested()) throw core::InputError("interrupted; no rawlog was written");
      report_.read.add(object);
      take(object);
      progress.update(reader_.objects(), reader_.fraction());
    }
  }

  void take(const mrpt::serialization::CSerializable::Ptr& object) {
    const Verdict verdict = judge_.judge(*object);
    if (verdict == Verdict::Nothing) return;
    report_.written.add(object);
    if (verdict == Verdict::Whole) {
      writer_.write(reader_.bytes());
      images_.lookIn(reader_.bytes());
      return;
    }
    std::vector<std::uint8_t> bytes;
    mrpt::serialization::ObjectToOctetVector(object.get(), bytes);
    writer_.write(bytes);
    images_.lookIn(bytes);
  }

  void requireSense() const {
    if (report_.read.objects == 0) throw core::InputError(job_.input.string() + ": is empty or not a rawlog");
    requireKnown(job_.selection.keep, report_.read, job_.input);
    requireKnown(job_.selection.remove, report_.read, job_.input);
    if (report_.written.observations.empty()) {
      throw core::InputError(job_.input.string() + ": no observation of it would be left; no rawlog was written");
    }
  }

  void commit() {
    static_cast<void>(writer_.checkpoint());
    const fs::path partial = job_.output.string() + ".partial";
    try {
      requireAsWritten(partial, report_.written, judge_);
      images_.commit();
    } catch (...) {
      std::error_code ignored;
      fs::remove(partial, ignored);
      throw;
    }
    writer_.commit();
  }

  const CutJob& job_;
  sources::RawlogReader reader_;
  Judge judge_;
  Images images_;
  recording::RawlogWriter writer_;
  CutReport report_;
};

}  // namespace

CutReport cutRawlog(const CutJob& job, const apps::InterruptionGuard& interruption) {
  requireOther(job.output, job.input);
  return Cut(job).perform(interruption);
}

void requireAsWritten(const fs::path& rawlog, const Tally& written, Judge& judge) {
  const auto fail = [&](const std::string& what) {
    throw core::InputError(rawlog.string() + ": does not read back as it was written (" + what +
                           "); it was removed, write it to another disk");
  };
  Tally read;
  try {
    sources::RawlogReader reader(rawlog);
    while (const auto object = reader.read()) {
      read.add(object);
      if (judge.judge(*object) != Verdict::Whole) fail("it holds what was to be left out");
    }
  } catch (const sources::InputDamage& damage) {
    fail(damage.what());
  }
  if (!(read == written)) {
    fail(std::to_string(read.objects) + " objects in place of " + std::to_string(written.objects));
  }
}

}  // namespace wardslam::rawlog_cut
