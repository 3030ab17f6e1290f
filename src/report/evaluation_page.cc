#include "report/evaluation_page.h"

#include <algorithm>
#include <set>

#include "report/internal_plots.h"
#include "report/internal_table.h"
#include "report/markup.h"
#include "report/wording.h"

// The page of an evaluation: one self-contained HTML file without scripts. Every diagram has a
// table with the same numbers, for readers who do not see it and for copying.

namespace smile::report {
namespace {

constexpr const char* kWhatIntervalsAre =
    "All intervals are 95 % confidence intervals: Wilson's for rates, Student's t for means and "
    "differences.";

/// Returns the head of a brain's row: a chip in the color of its series, and its name.
Markup BrainHead(const std::string& name, std::size_t series) {
  Markup head = Element("span", {{"class", "chip " + SeriesClass(series)}}, Markup());
  head += Text(name);
  return Element("th", {{"scope", "row"}}, head);
}

/// Returns the range of the seeds. All brains ran the same ones, in ascending order.
std::string SeedsText(const Evaluation& evaluation) {
  const std::vector<EvaluatedRun>& runs = evaluation.brains.front().runs;
  return std::to_string(runs.front().seed) + " to " + std::to_string(runs.back().seed);
}

/// Returns the result in one sentence. The first of equally good brains is named.
std::string Headline(const Evaluation& evaluation) {
  // Strictly more: of equally good brains the first one stays.
  const EvaluatedBrain* best = nullptr;
  std::size_t most = 0;
  for (const EvaluatedBrain& brain : evaluation.brains) {
    const std::size_t successes = SummaryOf(brain).successes;
    if (best == nullptr || successes > most) best = &brain;
    most = std::max(most, successes);
  }
  const std::string count =
      std::to_string(most) + " of " + Plural(best->runs.size(), "starting layout");
  if (evaluation.brains.size() == 1) return best->name + " succeeded from " + count;
  const char* what = best->demonstrator.empty() ? "brain" : "combination";
  return "Of " + Plural(evaluation.brains.size(), what) + ", " + best->name +
         " succeeded from most layouts: " + count;
}

Markup HeaderOf(const Evaluation& evaluation) {
  Markup header = Element("p", {{"class", "eyebrow"}}, "SMILE evaluation");
  header += Element("h1", {}, Headline(evaluation));
  header += Element("p", {{"class", "lead"}},
                    "A robot watched a demonstration and imitated it from random starting layouts. "
                    "All brains and demonstrators have the same layouts.");
  return Element("header", {}, header);
}

/// Returns the settings of the evaluation: recording, scene, seeds, options and brains.
Markup WhatWasRun(const Evaluation& evaluation) {
  Markup facts = Fact("Demonstration", evaluation.demo);
  facts += Fact("Scene", evaluation.scene);
  facts += Fact("Level", evaluation.level.empty() ? "default" : evaluation.level);
  facts += Fact("Seeds", SeedsText(evaluation));
  if (!evaluation.impossible.empty()) {
    facts += Fact("Left out", Plural(evaluation.impossible.size(), "layout") + "; seed " +
                                  std::to_string(evaluation.impossible.front().seed) + ": " +
                                  evaluation.impossible.front().reason);
  }
  facts += Fact("Program", evaluation.program);
  // Other options of each run, on one line.
  std::string options;
  for (const std::string& option : evaluation.options)
    options += (options.empty() ? "" : " ") + option;
  if (!options.empty()) facts += Fact("Options", options);
  for (const EvaluatedBrain& brain : evaluation.brains) {
    facts += Fact(brain.name, brain.demonstrator.empty()
                                  ? brain.brain
                                  : brain.brain + ", demonstrator " + brain.demonstrator);
  }
  return Section("Setup", Element("dl", {{"class", "facts"}}, facts));
}

/// Returns one row per brain, with intervals of 95 %.
Markup SummaryTable(const Evaluation& evaluation) {
  const Markup head = Row({Head("Brain"), NumberHead("Successes"), NumberHead("Rate (95 %)"),
                           NumberHead("Error, mm (95 %)"), NumberHead("Error, ° (95 %)"),
                           NumberHead("Seconds, median"), NumberHead("Seconds, 95th percentile"),
                           NumberHead("Grasps"), NumberHead("Retries"), NumberHead("Mean gain"),
                           NumberHead("Right claims")});
  Markup rows;
  for (std::size_t i = 0; i < evaluation.brains.size(); ++i) {
    const Summary summary = SummaryOf(evaluation.brains[i]);
    rows +=
        Row({BrainHead(evaluation.brains[i].name, i),
             NumberCell(std::to_string(summary.successes) + " of " + std::to_string(summary.runs)),
             NumberCell(Percent(summary.success_rate()) + " (" +
                        PercentRange(summary.success_interval) + ")"),
             NumberCell(WithInterval(summary.error_mm, 2)),
             NumberCell(WithInterval(summary.error_degrees, 2)),
             NumberCell(Fixed(summary.seconds_p50, 1)), NumberCell(Fixed(summary.seconds_p95, 1)),
             NumberCell(Count(summary.grasps)), NumberCell(Count(summary.retries)),
             NumberCell(Fixed(summary.mean_gain, 2)), NumberCell(RightClaimsText(summary))});
  }
  return Table(
      "Errors and times include successful runs only; grasps, retries, gains and claims include "
      "all "
      "runs. Gain is the part of the task that a run did: 0 for doing nothing.",
      head, rows);
}

/// Returns the rates of success as bars with their intervals.
Markup Bars(const Evaluation& evaluation) {
  std::vector<RateRow> rows;
  std::string words = "Successes:";
  for (const EvaluatedBrain& brain : evaluation.brains) {
    const Summary summary = SummaryOf(brain);
    rows.push_back({brain.name, summary.successes, summary.runs, summary.success_interval});
    words += " " + brain.name + " " + Percent(summary.success_rate()) + ";";
  }
  return RateBars(rows, words);
}

/// Returns one cell per run: a row per brain, a column per seed.
Markup Map(const Evaluation& evaluation) {
  std::vector<MapRow> rows;
  for (const EvaluatedBrain& brain : evaluation.brains) {
    MapRow row{.name = brain.name, .cells = {}};
    for (const EvaluatedRun& run : brain.runs) {
      // The text appears as a tooltip: the cell itself has only a color and a cross.
      row.cells.push_back(
          {run.has_succeeded, "seed " + std::to_string(run.seed) + ": " +
                                  (run.failure_reason ? run.failure_reason->code : "success")});
    }
    rows.push_back(row);
  }
  return SuccessMap(rows, "Success of each seed; the table of seeds below contains the same data");
}

/// Returns the distribution of a number over successful runs, one row per brain.
Markup Distribution(const Evaluation& evaluation, std::optional<double> EvaluatedRun::*field,
                    const std::string& axis, const std::string& words) {
  std::vector<DotRow> rows;
  for (const EvaluatedBrain& brain : evaluation.brains) {
    DotRow row{.name = brain.name, .numbers = {}, .mean = {}};
    for (const EvaluatedRun& run : brain.runs) {
      if (run.has_succeeded && run.*field) row.numbers.push_back(*(run.*field));
    }
    row.mean = MeanOf(row.numbers);
    rows.push_back(row);
  }
  return DotPlot(rows, axis, words);
}

/// Returns the distribution of retries; empty if no run has counted them.
Markup Retries(const Evaluation& evaluation) {
  std::vector<DotRow> rows;
  bool are_known = false;
  for (const EvaluatedBrain& brain : evaluation.brains) {
    DotRow row{.name = brain.name, .numbers = {}, .mean = {}};
    for (const EvaluatedRun& run : brain.runs) {
      if (run.retries) row.numbers.push_back(static_cast<double>(*run.retries));
    }
    are_known |= !row.numbers.empty();
    rows.push_back(row);
  }
  if (!are_known) return {};
  return Section("Retries", DotPlot(rows, "repeated grasps of an object per run",
                                    "Number of repeated grasps in each run"));
}

/// Returns the number of failures for each cause; empty without failures.
Markup CauseTable(const Evaluation& evaluation) {
  // The union of all causes, as not every brain fails for each of them; sorted by name.
  std::set<std::string> words;
  std::vector<Summary> summaries;
  for (const EvaluatedBrain& brain : evaluation.brains) {
    summaries.push_back(SummaryOf(brain));
    for (const auto& [word, count] : summaries.back().num_failures) words.insert(word);
  }
  if (words.empty()) return {};
  Markup head = Head("Cause");
  for (const EvaluatedBrain& brain : evaluation.brains) head += NumberHead(brain.name);
  Markup rows;
  for (const std::string& word : words) {
    Markup row = RowHead(word);
    for (Summary& summary : summaries)
      row += NumberCell(std::to_string(summary.num_failures[word]));
    rows += Element("tr", {}, row);
  }
  return Section("Failures by cause",
                 Table("Number of failed runs for each cause.", Element("tr", {}, head), rows));
}

Markup Plots(const Evaluation& evaluation) {
  const std::string note = "Each dot is a successful run; below, the mean and its interval.";
  Markup pair = Section("Success", Bars(evaluation));
  pair += Section("Success by seed", Map(evaluation));
  Markup errors = Distribution(evaluation, &EvaluatedRun::error_mm, "mean error [mm]",
                               "Placement errors of successful runs");
  errors += Element("p", {{"class", "note"}}, note);
  pair += Section("Placement errors", errors);
  Markup times = Distribution(evaluation, &EvaluatedRun::seconds, "robot time [s]",
                              "Robot time of successful runs");
  times += Element("p", {{"class", "note"}}, note);
  pair += Section("Robot time", times);
  pair += Retries(evaluation);
  pair += CauseTable(evaluation);
  return Element("div", {{"class", "pair"}}, pair);
}

/// Returns the comparison of each comparable pair of brains, by their runs from the same
/// seeds; empty without such a pair.
Markup Comparisons(const Evaluation& evaluation) {
  Markup rows;
  for (const auto& [first, second] : ComparablePairs(evaluation)) {
    const BrainComparison comparison = Compare(*first, *second);
    rows +=
        Row({RowHead(first->name + " − " + second->name),
             NumberCell(Signed(100 * comparison.success_difference, 1) + " points"),
             NumberCell(PValue(comparison.p_value)), NumberCell(std::to_string(comparison.both)),
             NumberCell(std::to_string(comparison.only_first)),
             NumberCell(std::to_string(comparison.only_second)),
             NumberCell(std::to_string(comparison.neither)),
             NumberCell(DifferenceWithInterval(comparison.error_mm, 2)),
             NumberCell(DifferenceWithInterval(comparison.error_degrees, 2)),
             NumberCell(DifferenceWithInterval(comparison.seconds, 1))});
  }
  if (rows.is_empty()) return {};
  const Markup head = Row({Head("Difference"), NumberHead("Success"), NumberHead("Exact McNemar"),
                           NumberHead("Both"), NumberHead("First only"), NumberHead("Second only"),
                           NumberHead("Neither"), NumberHead("Error, mm (95 %)"),
                           NumberHead("Error, ° (95 %)"), NumberHead("Seconds (95 %)")});
  return Section("Comparison", Table("Pairwise comparison on the same seeds. Differences of errors "
                                     "and times include only seeds with which both succeeded.",
                                     head, rows));
}

/// Returns one row per failure, with a link to its recording if that was kept.
Markup FailureTable(const Evaluation& evaluation) {
  Markup rows;
  for (std::size_t i = 0; i < evaluation.brains.size(); ++i) {
    for (const EvaluatedRun& run : evaluation.brains[i].runs) {
      if (!run.failure_reason) continue;
      rows += Row(
          {BrainHead(evaluation.brains[i].name, i), NumberCell(std::to_string(run.seed)),
           Cell(run.failure_reason->code), WideCell(run.failure_reason->text),
           Element("td", {},
                   run.recording.empty() ? Text("not kept") : LinkTo(run.recording, "recording"))});
    }
  }
  return Table("All failures.",
               Row({Head("Brain"), NumberHead("Seed"), Head("Cause"), Head("Description"),
                    Head("Recording")}),
               rows);
}

Markup Failures(const Evaluation& evaluation) {
  bool is_any = false;
  for (const EvaluatedBrain& brain : evaluation.brains) {
    for (const EvaluatedRun& run : brain.runs) is_any |= run.failure_reason.has_value();
  }
  // Stated explicitly: an empty section could be a fault of the page.
  if (!is_any) return Section("Failures", Element("p", {}, "None."));
  Markup content = FailureTable(evaluation);
  content += Element(
      "p", {{"class", "note"}},
      "To watch a failure with the robot's pictures, run it again; replace the words in capitals:");
  content += Element("pre", {}, evaluation.again);
  return Section("Failures", content);
}

/// Returns one row per seed, with a group of columns per brain.
Markup SeedTable(const Evaluation& evaluation) {
  Markup head = NumberHead("Seed");
  for (const EvaluatedBrain& brain : evaluation.brains) {
    head += Head(brain.name);
    // The same five columns for each brain, after the column of its result.
    for (const char* name : {"Error, mm", "Error, °", "Seconds", "Retries", "× real time"}) {
      head += NumberHead(name);
    }
  }
  Markup rows;
  // All brains have the same seeds, in the same order.
  for (std::size_t k = 0; k < evaluation.brains.front().runs.size(); ++k) {
    Markup row = Element("th", {{"scope", "row"}, {"class", "number"}},
                         std::to_string(evaluation.brains.front().runs[k].seed));
    for (const EvaluatedBrain& brain : evaluation.brains) {
      const EvaluatedRun& run = brain.runs[k];
      row += Element(
          "td", {},
          Badge(run.has_succeeded, run.failure_reason ? run.failure_reason->code : "success"));
      row += NumberCell(Fixed(run.error_mm, 2));
      row += NumberCell(Fixed(run.error_degrees, 2));
      row += NumberCell(Fixed(run.seconds, 1));
      row += NumberCell(Count(run.retries));
      row += NumberCell(Fixed(run.realtime_factor, 1));
    }
    rows += Element("tr", {}, row);
  }
  return Section("All seeds", Table("Robot time is simulated time. The factor to real time is "
                                    "measured in wall-clock time and depends on the machine.",
                                    Element("tr", {}, head), rows));
}

}  // namespace

std::string PageOf(const Evaluation& evaluation) {
  Markup body = HeaderOf(evaluation);
  body += WhatWasRun(evaluation);
  body += Section("Summary", SummaryTable(evaluation));
  body += Plots(evaluation);
  body += Comparisons(evaluation);
  body += Failures(evaluation);
  body += SeedTable(evaluation);
  body += Element("footer", {}, kWhatIntervalsAre);
  return Page("Evaluation of " + evaluation.scene, body);
}

}  // namespace smile::report
