#pragma once

#include <filesystem>
#include <string>

#include "support/interruption.h"
#include "wardslam/core/event_counts.h"
#include "wardslam/pipeline/slam_options.h"
#include "wardslam/sources/sensor_counts.h"

namespace wardslam::rawlog_annotate {

struct AnnotationJob {
  std::filesystem::path input;
  std::filesystem::path output;
  pipeline::SlamOptions options;
  std::string sensorLabel;  ///< Empty: the first RGB-D sensor of the rawlog.
  bool embed = false;       ///< Everything into one file, which then needs the plug-in to be read.
  bool keepPeople = false;  ///< Else they are blanked.
};

struct AnnotationReport {
  std::size_t objects = 0;        ///< Of the input.
  std::size_t resumedAt = 0;      ///< So many of them were done by an interrupted run.
  std::size_t annotated = 0;      ///< Scans annotated by this run.
  std::filesystem::path sidecar;  ///< Empty: none.
  core::EventCounts events;
  sources::SensorCounts sensors;
  std::string trouble;  ///< The first about input that could not be used, a sentence part; empty: all was well.
};

/// Throws core::InputError, and leaves nothing behind where that is the input's fault; where it was interrupted, or the
/// disk did not take it, what is done by then is kept for the next run of the same job.
[[nodiscard]] AnnotationReport annotateRawlog(const AnnotationJob& job, const apps::InterruptionGuard& interruption);

}  // namespace wardslam::rawlog_annotate
