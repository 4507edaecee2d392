#include <mrpt/system/os.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "cut.h"
#include "support/command_line.h"
#include "support/program.h"
#include "wardslam/core/errors.h"
#include "wardslam/mrpt_plugin/register_all.h"

namespace wardslam::rawlog_cut {
namespace {

constexpr const char* kName = "rawlog-cut";

struct Arguments {
  std::filesystem::path input;
  std::filesystem::path output;
  std::string from;
  std::string to;
  std::vector<std::string> keep;
  std::vector<std::string> remove;
  std::string plugins;
};

Selection selectionOf(const Arguments& arguments) {
  Selection selection;
  if (!arguments.from.empty()) selection.from = Moment::parse(arguments.from);
  if (!arguments.to.empty()) selection.to = Moment::parse(arguments.to);
  selection.keep = {arguments.keep.begin(), arguments.keep.end()};
  selection.remove = {arguments.remove.begin(), arguments.remove.end()};
  if (!selection.from && !selection.to && selection.keep.empty() && selection.remove.empty())
    throw apps::UsageError("nothing to do; give --from, --to, --keep or --remove");
  if (!selection.keep.empty() && !selection.remove.empty())
    throw apps::UsageError("--keep leaves out all other sensors; give either --keep or --remove");
  return selection;
}

void loadPlugins(const std::string& plugins) {
  std::string trouble;
  if (!mrpt::system::loadPluginModules(plugins, trouble))
    throw core::InputError("a plug-in cannot be loaded: " + trouble);
}

int cut(const Arguments& arguments) {
  const CutJob job{arguments.input, arguments.output, selectionOf(arguments)};
  if (!arguments.plugins.empty()) loadPlugins(arguments.plugins);
  mrpt_plugin::registerAll();
  const CutReport report = cutRawlog(job, apps::InterruptionGuard());
  std::cout << job.output.string() << ": " << report.written.objects << " of " << report.read.objects << " objects\n";
  for (const auto& [label, count] : report.read.observations) {
    const auto written = report.written.observations.find(label);
    std::cout << "  " << (label.empty() ? "(no label)" : label) << ": "
              << (written == report.written.observations.end() ? 0 : written->second) << " of " << count
              << " observations\n";
  }
  if (report.trouble.empty()) return apps::kSuccess;
  std::cerr << kName << ": " << job.input.string() << ": " << report.trouble
            << "; the output is of what comes before\n";
  return apps::kFailure;
}

}  // namespace
}  // namespace wardslam::rawlog_cut

int main(int argc, char** argv) {
  using namespace wardslam::rawlog_cut;
  return wardslam::apps::runProgram(kName, [&]() -> int {
    CLI::App app("Takes a span of time, or some of the sensors, out of an MRPT rawlog, into a copy of it", kName);
    app.set_version_flag("--version", "rawlog-cut " WARDSLAM_VERSION);
    Arguments arguments;
    app.add_option("INPUT", arguments.input, "rawlog to read; it is not changed")->required();
    app.add_option("-o,--output", arguments.output,
                   "rawlog to write; it appears once it was read back and found to be what was asked for")
        ->required();
    app.add_option("--from", arguments.from,
                   "leave out what was observed before: UNIX seconds, or with a plus sign (+12.5) seconds since the "
                   "first observation");
    app.add_option("--to", arguments.to, "leave out what was observed after, as with --from");
    app.add_option("--keep", arguments.keep, "label of a sensor to keep, all others are left out; can be repeated");
    app.add_option("--remove", arguments.remove, "label of a sensor to leave out; can be repeated");
    app.add_option("-p,--plugins", arguments.plugins,
                   "libraries (.so, full paths, separated by commas) with the classes of other objects in the rawlog");
    if (const auto code = wardslam::apps::parseCommandLine(app, argc, argv)) return *code;
    return cut(arguments);
  });
}
