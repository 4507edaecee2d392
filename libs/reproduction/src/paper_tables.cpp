#include "wardslam/reproduction/paper_tables.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "table_columns.h"

namespace wardslam::reproduction {
namespace {

/// A line for each, as there are many figures of one run.
Table runsTable(const Tables& all) {
  Table table;
  table.name = "runs";
  table.title = "What was run";
  table.labels = 2;
  table.headings = {"Sequence",       "Variant",   "Runs",      "ATE SE(3) [m]",
                    "ATE Sim(3) [m]", "RPE [m/s]", "RPE [°/s]", "Coverage"};
  for (std::size_t sequence = 0; sequence < all.plan().sequences.size(); ++sequence) {
    for (std::size_t variant = 0; variant < all.plan().variants.size(); ++variant) {
      const auto cell = [&](double (*figure)(const RunResult&), int decimals) {
        return all.ownCell(sequence, variant, {"", figure, decimals});
      };
      table.rows.push_back({all.plan().sequences[sequence].name, all.plan().variants[variant].name,
                            std::to_string(all.results().of(sequence, variant).size()), cell(&ateRmse, 4),
                            cell(&ateSim3, 4), cell(&rpeTranslation, 4), cell(&rpeRotation, 3), cell(&coverage, 3)});
    }
  }
  table.notes.emplace_back(
      "RMSE; median of the repetitions [least–most]. Coverage is the share of the images with a pose: a run that loses "
      "half of "
      "them can look good.");
  return table;
}

Table table1(const Tables& all) {
  Table table = all.begin("table_1", "Table 1: absolute trajectory error [m]");
  all.addPublished(
      table, 1,
      {{" aRMSE", "ate_rmse_m"}, {" Mean", "ate_mean_m"}, {" STD", "ate_std_m"}, {" Median", "ate_median_m"}});
  all.addOwn(table, isMain,
             {{" RMSE", &ateRmse, 4}, {" Mean", &ateMean, 4}, {" STD", &ateStd, 4}, {" Median", &ateMedian, 4}});
  return table;
}

Table table2(const Tables& all) {
  Table table = all.begin("table_2", "Table 2: RMSE of the absolute trajectory error [m]");
  all.addPublished(table, 2, {{"", "ate_rmse_m"}});
  all.addOwn(table, isMain, {{" SE(3)", &ateRmse, 4}, {" Sim(3)", &ateSim3, 4}});
  table.notes.emplace_back(
      "Ours in both alignments: SE(3) turns and shifts the trajectory onto the truth, Sim(3) also scales it, which "
      "flatters. "
      "Published columns are SE(3), or their source does not say, unless marked; GPU: needs one.");
  return table;
}

Table table3(const Tables& all) {
  Table table = all.begin("table_3", "Table 3: RMSE of the translational drift (RPE) [m/s]");
  all.addPublished(table, 3, {{"", "rpe_translation_mps"}});
  all.addOwn(table, isMain, {{"", &rpeTranslation, 4}});
  return table;
}

Table table4(const Tables& all) {
  Table table = all.begin("table_4", "Table 4: RMSE of the rotational drift (RPE) [°/s]");
  all.addPublished(table, 4, {{"", "rpe_rotation_degps"}});
  all.addOwn(table, isMain, {{"", &rpeRotation, 4}});
  return table;
}

bool isEqualButForParameters(const Variant& a, const Variant& b) {
  return a.filter == b.filter && a.network == b.network && a.config == b.config && a.match_outliers == b.match_outliers;
}

Table table5(const Tables& all) {
  Table table = all.begin("table_5", "Table 5: RMSE of the absolute trajectory error [m] by n and δ");
  all.addPublished(table, 5, {{"", "ate_rmse_m"}});
  const auto& variants = all.plan().variants;
  const auto isVaried = [&](const Variant& variant) {
    return variant.segments() && std::any_of(variants.begin(), variants.end(), [&](const Variant& other) {
             return isEqualButForParameters(variant, other) && (variant.n != other.n || variant.delta != other.delta);
           });
  };
  all.addOwn(table, isVaried, {{"", &ateRmse, 4}});
  return table;
}

bool differInOutliersAlone(const Variant& without, const Variant& with) {
  return !without.match_outliers && with.match_outliers && without.filter == with.filter && without.n == with.n &&
         without.delta == with.delta && without.network == with.network && without.config == with.config;
}

/// On how many sequences the second is better, by what factor in the middle.
std::string verdict(const Tables& all, std::size_t without, std::size_t with) {
  std::vector<double> ratios;
  std::size_t better = 0;
  std::size_t worse = 0;
  for (std::size_t sequence = 0; sequence < all.plan().sequences.size(); ++sequence) {
    const double before = all.results().spread(sequence, without, &ateRmse).median;
    const double after = all.results().spread(sequence, with, &ateRmse).median;
    if (std::isnan(before) || std::isnan(after) || before <= 0.0) continue;
    ratios.push_back(after / before);
    if (after < before) ++better;
    if (after > before) ++worse;
  }
  const auto& variants = all.plan().variants;
  if (ratios.empty()) return "";
  const std::size_t count = ratios.size();
  return "'" + variants[with].name + "' against '" + variants[without].name + "': lower RMSE on " +
         std::to_string(better) + ", higher on " + std::to_string(worse) + " of " + std::to_string(count) +
         " sequences, " + figureText(spreadOf(std::move(ratios)).median, 3) + " times in the middle.";
}

Table table6(const Tables& all) {
  Table table =
      all.begin("table_6", "Table 6: absolute trajectory error [m] without and with the distance of descriptors (P6)");
  all.addPublished(
      table, 6,
      {{" RMSE", "ate_rmse_m"}, {" Mean", "ate_mean_m"}, {" Median", "ate_median_m"}, {" S.D.", "ate_std_m"}});
  const auto& variants = all.plan().variants;
  const auto isOneOfAPair = [&](const Variant& variant) {
    return std::any_of(variants.begin(), variants.end(), [&](const Variant& other) {
      return differInOutliersAlone(variant, other) || differInOutliersAlone(other, variant);
    });
  };
  all.addOwn(table, isOneOfAPair,
             {{" RMSE", &ateRmse, 4}, {" Mean", &ateMean, 4}, {" Median", &ateMedian, 4}, {" S.D.", &ateStd, 4}});
  for (std::size_t i = 0; i < variants.size(); ++i) {
    for (std::size_t j = 0; j < variants.size(); ++j) {
      const std::string sentence = differInOutliersAlone(variants[i], variants[j]) ? verdict(all, i, j) : "";
      if (!sentence.empty()) table.notes.push_back(sentence);
    }
  }
  return table;
}

Table table7(const Tables& all) {
  Table table = all.begin("table_7", "Table 7: time for an image [ms]", {"dynamic", "stationary"});
  all.addPublished(table, 7, {{"", "filter_ms"}});
  all.addOwn(table, [](const Variant& variant) { return variant.isMain() && variant.filter != Filter::Off; },
             {{" filter", &filterTime, 1}});
  all.addOwn(table, isMain, {{" whole image", &frameTime, 1}});
  table.notes.emplace_back(
      "Filter: marking what moves and waiting for masks, median over the images of a run. The paper's dynamic case "
      "leaves the "
      "network out, its stationary case has ORB-SLAM2's whole tracking and training in it. Whole image: all that "
      "tracking does. "
      "Runs beside each other take each other's time: for these figures, one at a time (--jobs 1).");
  return table;
}

}  // namespace

std::vector<Table> paperTables(const Plan& plan, const std::vector<PublishedSystem>& published,
                               const Results& results) {
  const Tables all(plan, published, results);
  std::vector<Table> tables = {runsTable(all), table1(all), table2(all), table3(all),
                               table4(all),    table5(all), table6(all), table7(all)};
  tables.erase(
      std::remove_if(tables.begin(), tables.end(), [](const Table& table) { return table.headings.size() < 2; }),
      tables.end());
  return tables;
}

Table allFigures(const Plan& plan, const Results& results) {
  struct Line {
    const char* figure;
    const char* unit;
    double (*of)(const RunResult&);
  };
  constexpr Line kLines[] = {{"ate_rmse_se3", "m", &ateRmse},
                             {"ate_rmse_sim3", "m", &ateSim3},
                             {"ate_mean_se3", "m", &ateMean},
                             {"ate_median_se3", "m", &ateMedian},
                             {"ate_std_se3", "m", &ateStd},
                             {"rpe_translation_rmse", "m/s", &rpeTranslation},
                             {"rpe_rotation_rmse", "deg/s", &rpeRotation},
                             {"coverage", "1", &coverage},
                             {"filter_time", "ms", &filterTime},
                             {"image_time", "ms", &frameTime}};
  Table table;
  table.name = "figures";
  table.title = "All figures";
  table.labels = 4;
  table.headings = {"sequence", "variant", "figure", "unit", "median", "min", "max", "mean", "known", "runs"};
  for (std::size_t sequence = 0; sequence < plan.sequences.size(); ++sequence) {
    for (std::size_t variant = 0; variant < plan.variants.size(); ++variant) {
      for (const Line& line : kLines) {
        const Spread spread = results.spread(sequence, variant, line.of);
        table.rows.push_back({plan.sequences[sequence].name, plan.variants[variant].name, line.figure, line.unit,
                              figureText(spread.median, 6), figureText(spread.min, 6), figureText(spread.max, 6),
                              figureText(spread.mean, 6), std::to_string(spread.known), std::to_string(spread.runs)});
      }
    }
  }
  return table;
}

}  // namespace wardslam::reproduction
