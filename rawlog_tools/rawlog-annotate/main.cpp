#include <mrpt/system/os.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <string>

#include "annotation_run.h"
#include "support/command_line.h"
#include "support/filter_arguments.h"
#include "support/program.h"
#include "wardslam/core/errors.h"
#include "wardslam/mrpt_plugin/register_all.h"

namespace wardslam::rawlog_annotate {
namespace {

constexpr const char* kName = "rawlog-annotate";

struct Arguments {
  std::filesystem::path input;
  std::filesystem::path output;
  apps::FilterArguments filter;
  std::string sensorLabel;
  std::string plugins;
  bool embed = false;
  bool keepPeople = false;
};

AnnotationJob jobOf(const Arguments& arguments) {
  AnnotationJob job;
  job.input = arguments.input;
  job.output = arguments.output;
  if (job.output.empty()) job.output = job.input.parent_path() / (job.input.stem().string() + "_annotated.rawlog");
  job.options = apps::effectiveOptions(arguments.filter, kName);
  job.sensorLabel = arguments.sensorLabel;
  job.embed = arguments.embed;
  job.keepPeople = arguments.keepPeople;
  apps::requireSomebodyLooksForPeople(job.options, job.keepPeople, "an annotated rawlog shows");
  return job;
}

void loadPlugins(const std::string& plugins) {
  std::string trouble;
  if (!mrpt::system::loadPluginModules(plugins, trouble))
    throw core::InputError("a plug-in cannot be loaded: " + trouble);
}

int annotate(const Arguments& arguments) {
  if (!arguments.plugins.empty()) loadPlugins(arguments.plugins);
  mrpt_plugin::registerAll();
  const AnnotationJob job = jobOf(arguments);
  const AnnotationReport report = annotateRawlog(job, apps::InterruptionGuard());
  std::cout << job.output.string() << ": " << report.objects << " objects, of which " << report.annotated
            << " scans annotated";
  if (report.resumedAt > 0) std::cout << ", going on behind the first " << report.resumedAt << " objects";
  std::cout << "\n";
  if (!report.sidecar.empty()) std::cout << report.sidecar.string() << ": what was found, in full\n";
  for (const auto& [event, count] : report.events) std::cout << "  " << event << ": " << count << "\n";
  if (const auto sentence = report.sensors.sentence()) {
    std::cerr << kName << ": " << job.input.string() << ": " << *sentence << "\n";
  }
  if (report.trouble.empty()) return apps::kSuccess;
  std::cerr << kName << ": " << job.input.string() << ": " << report.trouble
            << "; the output holds the rest, and scans that could not be used as they were\n";
  return apps::kFailure;
}

}  // namespace
}  // namespace wardslam::rawlog_annotate

int main(int argc, char** argv) {
  using namespace wardslam::rawlog_annotate;
  return wardslam::apps::runProgram(kName, [&]() -> int {
    CLI::App app("Marks what moves in the RGB-D scans of an MRPT rawlog, in a copy of it", kName);
    app.set_version_flag("--version", "rawlog-annotate " WARDSLAM_VERSION);
    Arguments arguments;
    app.add_option("INPUT", arguments.input, "rawlog to read; it is not changed")->required();
    app.add_option("-o,--output", arguments.output,
                   "rawlog to write, INPUT_annotated.rawlog unless given; all programs of MRPT can read it. What was "
                   "found in full goes to OUTPUT_sem.rawlog");
    wardslam::apps::addFilterArguments(app, arguments.filter);
    app.add_option("--sensor", arguments.sensorLabel,
                   "label of the RGB-D sensor; the first in the rawlog unless given");
    app.add_option("-p,--plugins", arguments.plugins,
                   "libraries (.so, full paths, separated by commas) with the classes of other objects in the rawlog");
    app.add_flag(
        "--embed", arguments.embed,
        "write all into one file; programs of MRPT then need libwardslam-mrpt.so to read beyond its first scan");
    app.add_flag("--keep-people", arguments.keepPeople,
                 "leave colours, depth and key points of people as they are; else they are blanked");
    if (const auto code = wardslam::apps::parseCommandLine(app, argc, argv)) return *code;
    return annotate(arguments);
  });
}
