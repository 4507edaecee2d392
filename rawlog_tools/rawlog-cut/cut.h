#pragma once

#include <filesystem>
#include <string>

#include "selection.h"
#include "support/interruption.h"
#include "tally.h"

namespace wardslam::rawlog_cut {

struct CutJob {
  std::filesystem::path input;
  std::filesystem::path output;
  Selection selection;
};

struct CutReport {
  Tally read;
  Tally written;
  std::string trouble;  ///< What keeps the end of the input from being read; empty where nothing does.
};

/// Writes what is wanted of a rawlog to another, which is complete or absent. Objects that are wanted whole are copied
/// byte for byte. Of external images, those that are wanted go to "<output>_Images" (as hard links where the file
/// system allows it). Before the output appears it is read back and judged once more.
///
/// Throws core::InputError, and writes nothing, where the input cannot be read, holds a class that is not known or has
/// no sensor of a name that was given, where nothing is left, where the output would be the input or cannot be written,
/// and where it does not read back as it should.
[[nodiscard]] CutReport cutRawlog(const CutJob& job, const apps::InterruptionGuard& interruption);

/// Reads a rawlog and throws core::InputError unless it holds what `written` counts, and nothing the judge would not
/// have in it.
void requireAsWritten(const std::filesystem::path& rawlog, const Tally& written, Judge& judge);

}  // namespace wardslam::rawlog_cut
