#include "output_files.h"

#include <fstream>
#include <iterator>
#include <utility>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/external_images.h"

namespace wardslam::rawlog_annotate {
namespace {

namespace fs = std::filesystem;

struct Checkpoint {
  std::size_t objects = 0;
  std::uintmax_t main_bytes = 0;
  std::uintmax_t sidecar_bytes = 0;
};

/// A checkpoint of the same job; the beginning where there is none.
Checkpoint readCheckpoint(const fs::path& file, const std::string& job) {
  std::ifstream in(file);
  Checkpoint checkpoint;
  in >> checkpoint.objects >> checkpoint.main_bytes >> checkpoint.sidecar_bytes;
  in.get();  // the end of the line
  const std::string theirs{std::istreambuf_iterator<char>(in), {}};
  return in.bad() || theirs != job ? Checkpoint{} : checkpoint;
}

fs::path withStem(const fs::path& file, const std::string& ending) {
  return file.parent_path() / (file.stem().string() + ending);
}

void requireOther(const fs::path& output, const fs::path& input) {
  std::error_code absent;
  if (!fs::equivalent(output, input, absent)) return;
  throw core::InputError(output.string() + ": is the input, which is never changed; give another -o");
}

/// Where a name is absolute or leads out of the folder, the output finds the image as the input does.
bool isSameFolder(const fs::path& a, const fs::path& b) {
  std::error_code absent;
  return fs::equivalent(a, b, absent);
}

}  // namespace

OutputFiles::OutputFiles(fs::path output, bool hasSidecar, const fs::path& input, std::string job)
    : output_(std::move(output)),
      resumeFile_(output_.string() + ".resume"),
      inputImages_(sources::findImageFolder(input)),
      job_(std::move(job)) {
  requireOther(output_, input);
  if (hasSidecar) requireOther(sidecar(), input);
  const auto outputImages = sources::findImageFolder(output_);
  if (inputImages_ && outputImages && !isSameFolder(*inputImages_, *outputImages)) {
    throw core::InputError(outputImages->string() + ": is there already, and would pass for the images of " +
                           output_.string() + "; give another -o");
  }
  const Checkpoint checkpoint = readCheckpoint(resumeFile_, job_);
  try {
    open(hasSidecar, checkpoint.main_bytes, checkpoint.sidecar_bytes);
    objectsDone_ = checkpoint.objects;
  } catch (const core::InputError&) {
    if (checkpoint.objects == 0) throw;
    open(hasSidecar, 0, 0);  // what the checkpoint tells of is gone
  }
}

void OutputFiles::open(bool hasSidecar, std::uintmax_t mainSize_bytes, std::uintmax_t sidecarSize_bytes) {
  using recording::ImageCoding;
  main_ = std::make_unique<recording::RawlogWriter>(output_, ImageCoding::Lossless, mainSize_bytes);
  if (!hasSidecar) return;
  sidecar_ = std::make_unique<recording::RawlogWriter>(sidecar(), ImageCoding::Lossless, sidecarSize_bytes);
}

fs::path OutputFiles::sidecar() const { return withStem(output_, "_sem.rawlog"); }

void OutputFiles::checkpoint(std::size_t objectsDone) {
  guarded([&] {
    const std::uintmax_t main_bytes = main_->checkpoint();
    const std::uintmax_t sidecar_bytes = sidecar_ ? sidecar_->checkpoint() : 0;
    core::writeFileAtomically(resumeFile_, std::to_string(objectsDone) + " " + std::to_string(main_bytes) + " " +
                                               std::to_string(sidecar_bytes) + "\n" + job_);
  });
}

void OutputFiles::discard() {
  if (diskFails_) return;
  main_->discard();
  if (sidecar_) sidecar_->discard();
  std::error_code absent;
  fs::remove(resumeFile_, absent);
}

void OutputFiles::commit() {
  linkImages();
  if (sidecar_) sidecar_->commit();
  main_->commit();
  std::error_code absent;
  fs::remove(resumeFile_, absent);
}

/// External images stay where they are; the copy finds them through a link of the name MRPT looks for.
void OutputFiles::linkImages() const {
  if (!inputImages_ || sources::findImageFolder(output_)) return;
  const fs::path link = withStem(output_, "_Images");
  std::error_code error;
  fs::create_directory_symlink(fs::relative(*inputImages_, fs::absolute(output_).parent_path()), link, error);
  if (!error) return;
  throw core::InputError(link.string() + ": cannot be made (" + error.message() +
                         "), a link to the images of the input; give an -o in the folder of the input");
}

}  // namespace wardslam::rawlog_annotate
