#include "reproduce_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "plan_sequences.h"
#include "reproduction_run.h"
#include "support/interruption.h"
#include "support/program.h"
#include "support/progress.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/report/tables_page.h"
#include "wardslam/reproduction/paper_tables.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;
using reproduction::Plan;

/// A plan of one's own, or one that comes with the program: "sample.yaml".
Plan readPlan(const fs::path& name) {
  if (fs::exists(name)) return reproduction::readPlan(name);
  return reproduction::readPlan(core::findDataFile(name.has_parent_path() ? name : fs::path("plans") / name));
}

/// One sentence for each sequence that is not there.
std::vector<std::string> missingSequences(const Plan& plan, const fs::path& data) {
  std::vector<std::string> sentences;
  for (const auto& sequence : plan.sequences) {
    const fs::path folder = reproduction::folderOf(sequence, data);
    if (fs::exists(folder)) continue;
    sentences.push_back(sequence.name + ": missing, looked for in " + folder.string() +
                        (sequence.fetch.url.empty() ? "" : " (--fetch gets it from " + sequence.fetch.url + ")"));
  }
  return sentences;
}

std::string countsOf(const ReproductionRun& run, const Plan& plan) {
  const std::size_t all = plan.sequences.size() * plan.variants.size() * static_cast<std::size_t>(plan.repetitions);
  return std::to_string(run.finished()) + " of " + std::to_string(all) + " runs are done" +
         (run.cells() < all
              ? ", " + std::to_string(all - run.cells()) + " cannot be: see 'missing', 'no masks', 'no truth'"
              : std::string()) +
         ".";
}

/// tables.md and tables.html, and every table as CSV, and figures.csv, which has all.
class TableFolder {
 public:
  TableFolder(const Plan& plan, const ReproduceArguments& arguments)
      : plan_(plan),
        out_(arguments.out),
        missing_(missingSequences(plan, arguments.data)),
        published_(reproduction::readPublishedFigures(core::findDataFile("reproduction/published.yaml"))) {}

  std::string write(const ReproductionRun& run) const {
    const reproduction::TableCollection collection = collectionOf(run);
    for (const auto& table : collection.tables) {
      core::writeFileAtomically(out_ / (table.name + ".csv"), reproduction::toCsv(table));
    }
    core::writeFileAtomically(out_ / "figures.csv",
                              reproduction::toCsv(reproduction::allFigures(plan_, run.results())));
    core::writeFileAtomically(out_ / "tables.html", report::makeTablesPage(collection));
    std::string text = reproduction::toMarkdown(collection);
    core::writeFileAtomically(out_ / "tables.md", text);
    return text;
  }

 private:
  [[nodiscard]] reproduction::TableCollection collectionOf(const ReproductionRun& run) const {
    reproduction::TableCollection collection;
    collection.title = plan_.title;
    collection.introduction =
        "WardSLAM " WARDSLAM_VERSION ", " + plan_.file.filename().string() + ". " + countsOf(run, plan_);
    collection.sentences = missing_;
    collection.sentences.insert(collection.sentences.end(), run.troubles().begin(), run.troubles().end());
    collection.tables = reproduction::paperTables(plan_, published_, run.results());
    return collection;
  }

  const Plan& plan_;
  fs::path out_;
  std::vector<std::string> missing_;
  std::vector<reproduction::PublishedSystem> published_;
};

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw core::InputError(folder.string() + ": cannot be made: " + error.message());
}

void reproduce(const ReproduceArguments& arguments) {
  const Plan plan = readPlan(arguments.plan);
  makeFolder(arguments.out);
  const InterruptionGuard interruption;
  if (arguments.fetch) {
    for (const auto& sentence : fetchAbsent(plan, arguments.data, interruption))
      std::cerr << "wardslam: " << sentence << "\n";
  }
  renderAbsent(plan, arguments.data, interruption);
  ReproductionRun run(plan, arguments);
  const TableFolder tables(plan, arguments);
  std::string text = tables.write(run);
  {
    Progress progress(std::cerr, standardErrorIsTerminal(), "run", run.cells() - run.finishedBefore());
    progress.update(0);
    run.perform(interruption, [&] {
      text = tables.write(run);
      progress.update(run.finished() - run.finishedBefore());
    });
  }
  std::cout << text << std::flush;
}

}  // namespace

void addReproduceCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "reproduce",
      "Run every sequence of a plan with every variant, several times, and write the tables of the paper with "
      "published "
      "figures and ours (tables.md, tables.html, CSV). Run again after an interruption, it goes on with what is "
      "missing");
  auto arguments = std::make_shared<ReproduceArguments>();
  command
      ->add_option("PLAN", arguments->plan,
                   "a plan (YAML), or one that comes with the program: sample.yaml, tum_fr3.yaml, bonn.yaml, "
                   "hospital.yaml")
      ->required();
  command->add_option("--data", arguments->data, "folder that holds those of the sequences; here unless told");
  command->add_option("--out", arguments->out, "folder for runs and tables; made when absent")->required();
  command->add_option("--jobs", arguments->jobs, "runs beside each other; as many as there are cores unless told")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--fetch", arguments->fetch, "get sequences that are absent from where they are published");
  command->callback([arguments] { reproduce(*arguments); });
}

}  // namespace wardslam::apps
