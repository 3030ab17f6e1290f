#include "report/evaluation.h"

#include <algorithm>
#include <functional>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json_node.h"
#include "base/wording.h"
#include "report/columns.h"
#include "report/wording.h"
#include "task/imitation_result.h"

// Evaluation of many runs of imitation: reads their results, computes rates, means and paired
// comparisons, and writes them as JSON and as a table for terminals. evaluation_page.cc draws the
// same numbers. Results may come from older versions or other programs, so members may be missing.

namespace smile::report {
namespace {

/// Limits on results, which other programs may have written.
constexpr std::size_t kMaxResultBytes = 16 << 20;
constexpr std::size_t kMaxTextBytes = 4096;
constexpr std::uint64_t kMaxCount = 1'000'000'000;
// Larger numbers are faults, and would spoil every mean.
constexpr double kMostNumber = 1e12;
// Format of the JSON; increases when a member changes its meaning.
constexpr int kEvaluationFormat = 2;

/// Returns an optional number of a result; nullopt if it is missing or null, as in results of older
/// versions.
std::optional<double> NumberIn(const JsonNode& node, const std::string& name) {
  if (!node.Has(name) || node.Member(name).IsNull()) return std::nullopt;
  return node.Member(name).Number(0, kMostNumber);
}

/// Returns the gain of a result; nullopt in results of older versions, and where there was nothing
/// to gain.
std::optional<double> GainIn(const JsonNode& result) {
  if (!result.Has("gain") || result.Member("gain").IsNull()) return std::nullopt;
  return result.Member("gain").Number(-kMostNumber, 1);
}

/// Returns an optional count of a result.
std::optional<std::uint64_t> CountIn(const JsonNode& node, const std::string& name) {
  if (!node.Has(name)) return std::nullopt;
  return node.Member(name).Whole(0, kMaxCount);
}

/// Returns the reason that follows from the fields that every version has.
task::FailureReason FailureReasonFromStatus(const JsonNode& result) {
  const JsonNode brain = result.Member("brain");
  const std::string status = brain.Member("status").String();
  if (status == "failed") {
    return {"brain_failed", brain.Member("message").String().substr(0, kMaxTextBytes)};
  }
  if (status == "running") return {"time_up", texts::Say("failures.timeUp")};
  return {"not_rebuilt", texts::Say("failures.notRebuilt")};
}

/// Returns the run of a result.
/// @throws InputError if a member is missing or wrong.
EvaluatedRun RunIn(const JsonNode& result, std::uint64_t seed) {
  result.ExpectObject();
  EvaluatedRun run{.seed = seed,
                   .has_succeeded = task::ReadSuccess(result),
                   // Required in all versions; the fields below may be missing.
                   .score = result.Member("score").Number(0, 1),
                   .gain = GainIn(result),
                   .claim = task::ReadClaim(result),
                   .error_mm = NumberIn(result, "mean_error_mm"),
                   .error_degrees = NumberIn(result, "mean_error_degrees"),
                   .seconds = NumberIn(result, "seconds"),
                   .realtime_factor = NumberIn(result, "realtime_factor")};
  if (result.Has("work")) {
    run.grasps = CountIn(result.Member("work"), "grasps");
    run.retries = CountIn(result.Member("work"), "retries");
  }
  if (run.has_succeeded) return run;
  // Results of older versions have no cause.
  if (result.Has("cause")) run.failure_reason = task::FailureReasonIn(result.Member("cause"));
  if (!run.failure_reason) run.failure_reason = FailureReasonFromStatus(result);
  return run;
}

/// Returns the values of a field in the successful runs that report it.
std::vector<double> OfSuccesses(const std::vector<EvaluatedRun>& runs,
                                std::optional<double> EvaluatedRun::*field) {
  std::vector<double> numbers;
  for (const EvaluatedRun& run : runs) {
    // A failed run has errors, too, but of a structure that is not the demonstrated one.
    if (run.has_succeeded && run.*field) numbers.push_back(*(run.*field));
  }
  return numbers;
}

/// Returns the mean difference of one field over the seeds from which both succeeded.
/// Pairing by seed removes the variation between layouts, which is larger than that between
/// programs.
std::optional<Mean> MeanDifference(const EvaluatedBrain& first, const EvaluatedBrain& second,
                                   std::optional<double> EvaluatedRun::*field) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < first.runs.size(); ++i) {
    // All brains ran the same seeds in the same order, so the index pairs them.
    const EvaluatedRun &a = first.runs[i], &b = second.runs[i];
    if (a.has_succeeded && b.has_succeeded && a.*field && b.*field) {
      differences.push_back(*(a.*field) - *(b.*field));
    }
  }
  return MeanOf(differences);
}

/// Adds a count to a sum, which stays nullopt if no run has the count.
void AddCount(const std::optional<std::uint64_t>& count, std::optional<std::uint64_t>* sum) {
  if (count) *sum = sum->value_or(0) + *count;
}

/// Returns a number as JSON, null without one.
template <class Number>
Json OrNull(const std::optional<Number>& number) {
  return number ? Json(*number) : Json();
}

Json MeanJson(const std::optional<Mean>& mean) {
  if (!mean) return nullptr;
  return {{"mean", mean->value},
          {"interval",
           mean->interval ? Json::array({mean->interval->low, mean->interval->high}) : Json()},
          {"count", mean->count}};
}

Json SummaryJson(const Summary& summary) {
  Json causes = Json::object();
  for (const auto& [word, count] : summary.num_failures) causes[word] = count;
  return {{"runs", summary.runs},
          {"successes", summary.successes},
          {"success_rate", summary.success_rate()},
          {"success_interval", {summary.success_interval.low, summary.success_interval.high}},
          {"error_mm", MeanJson(summary.error_mm)},
          {"error_degrees", MeanJson(summary.error_degrees)},
          {"seconds_p50", OrNull(summary.seconds_p50)},
          {"seconds_p95", OrNull(summary.seconds_p95)},
          {"gain", OrNull(summary.mean_gain)},
          {"right_claims", summary.right_claims},
          {"wrong_claims", summary.wrong_claims},
          {"grasps", OrNull(summary.grasps)},
          {"retries", OrNull(summary.retries)},
          {"causes", causes}};
}

Json ClaimJson(const std::optional<task::ClaimEnd>& claim) {
  if (!claim) return nullptr;
  return {{"done", claim->is_done}, {"right", claim->is_right}, {"reason", claim->reason}};
}

Json RunJson(const EvaluatedRun& run) {
  return {{"seed", run.seed},
          {"success", run.has_succeeded},
          {"score", run.score},
          {"gain", OrNull(run.gain)},
          {"claim", ClaimJson(run.claim)},
          {"error_mm", OrNull(run.error_mm)},
          {"error_degrees", OrNull(run.error_degrees)},
          {"seconds", OrNull(run.seconds)},
          {"grasps", OrNull(run.grasps)},
          {"retries", OrNull(run.retries)},
          {"cause", task::ToJson(run.failure_reason)},
          {"recording", run.recording.empty() ? Json() : Json(run.recording)},
          {"realtime_factor", OrNull(run.realtime_factor)}};
}

Json ComparisonJson(const BrainComparison& comparison) {
  return {{"both", comparison.both},
          {"only_first", comparison.only_first},
          {"only_second", comparison.only_second},
          {"neither", comparison.neither},
          {"success_difference", comparison.success_difference},
          {"p_value", comparison.p_value},
          {"error_mm", MeanJson(comparison.error_mm)},
          {"error_degrees", MeanJson(comparison.error_degrees)},
          {"seconds", MeanJson(comparison.seconds)}};
}

/// Returns lines that compare two brains. Errors and times are left out if no seed has them
/// from both.
std::string ComparisonText(const EvaluatedBrain& first, const EvaluatedBrain& second) {
  const BrainComparison comparison = Compare(first, second);
  const std::string a = Printable(first.name), b = Printable(second.name);
  std::string text = a + " less " + b + ", on the same " + Plural(first.runs.size(), "layout") +
                     ":\n  success  " + Signed(100 * comparison.success_difference, 1) +
                     " points; both " + std::to_string(comparison.both) + ", only " + a + " " +
                     std::to_string(comparison.only_first) + ", only " + b + " " +
                     std::to_string(comparison.only_second) + ", neither " +
                     std::to_string(comparison.neither) + "; exact McNemar test " +
                     PValue(comparison.p_value) + "\n";
  if (comparison.error_mm) {
    text += "  error    " + DifferenceWithInterval(comparison.error_mm, 2) + " mm\n";
  }
  if (comparison.seconds) {
    text += "  time     " + DifferenceWithInterval(comparison.seconds, 1) + " s\n";
  }
  return text;
}

/// Returns a line on the seeds that were left out; empty if there are none.
std::string ImpossibleText(const Evaluation& evaluation) {
  if (evaluation.impossible.empty()) return "";
  return "left out: " + Plural(evaluation.impossible.size(), "layout") + "; seed " +
         std::to_string(evaluation.impossible.front().seed) + ": " +
         Printable(evaluation.impossible.front().reason) + "\n";
}

}  // namespace

EvaluatedRun ReadRun(const std::filesystem::path& result_json, std::uint64_t seed) {
  const std::string file = result_json.string();
  try {
    const Json json = ParseJson(ReadFile(result_json, kMaxResultBytes));
    return RunIn(JsonNode(json, file, ""), seed);
  } catch (const std::invalid_argument& error) {
    // Line 0: the file as a whole is no JSON.
    throw InputError({file, 0, "", error.what()});
  }
}

Summary SummaryOf(const EvaluatedBrain& brain) {
  Summary summary{.runs = brain.runs.size()};
  std::vector<double> gains;
  for (const EvaluatedRun& run : brain.runs) {
    if (run.has_succeeded) ++summary.successes;
    if (run.failure_reason) ++summary.num_failures[run.failure_reason->code];
    if (run.claim) ++(run.claim->is_right ? summary.right_claims : summary.wrong_claims);
    if (run.gain) gains.push_back(*run.gain);
    AddCount(run.grasps, &summary.grasps);
    AddCount(run.retries, &summary.retries);
  }
  // Wilson's interval, since the usual one has no width when all runs succeed.
  summary.success_interval = WilsonInterval(summary.successes, summary.runs);
  summary.error_mm = MeanOf(OfSuccesses(brain.runs, &EvaluatedRun::error_mm));
  summary.error_degrees = MeanOf(OfSuccesses(brain.runs, &EvaluatedRun::error_degrees));
  const std::vector<double> seconds = OfSuccesses(brain.runs, &EvaluatedRun::seconds);
  summary.seconds_p50 = Quantile(seconds, 0.5);
  summary.seconds_p95 = Quantile(seconds, 0.95);
  if (const std::optional<Mean> gain = MeanOf(gains)) summary.mean_gain = gain->value;
  return summary;
}

std::string RightClaimsText(const Summary& summary) {
  const std::size_t count = summary.right_claims + summary.wrong_claims;
  if (count == 0) return "–";
  return std::to_string(summary.right_claims) + " of " + std::to_string(count);
}

std::string FailureCountsText(const Summary& summary) {
  std::string text;
  for (const auto& [word, count] : summary.num_failures) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " x " + Printable(word);
  }
  return text;
}

BrainComparison Compare(const EvaluatedBrain& first, const EvaluatedBrain& second) {
  BrainComparison comparison;
  for (std::size_t i = 0; i < first.runs.size(); ++i) {
    const bool a = first.runs[i].has_succeeded, b = second.runs[i].has_succeeded;
    // The four cells of a paired table.
    ++(a && b ? comparison.both
       : a    ? comparison.only_first
       : b    ? comparison.only_second
              : comparison.neither);
  }
  // Pairs in which both succeed or both fail cancel out.
  comparison.success_difference =
      (static_cast<double>(comparison.only_first) - static_cast<double>(comparison.only_second)) /
      static_cast<double>(first.runs.size());
  comparison.p_value = ExactMcNemar(comparison.only_first, comparison.only_second);
  comparison.error_mm = MeanDifference(first, second, &EvaluatedRun::error_mm);
  comparison.error_degrees = MeanDifference(first, second, &EvaluatedRun::error_degrees);
  comparison.seconds = MeanDifference(first, second, &EvaluatedRun::seconds);
  return comparison;
}

std::vector<std::pair<const EvaluatedBrain*, const EvaluatedBrain*>> ComparablePairs(
    const Evaluation& evaluation) {
  std::vector<std::pair<const EvaluatedBrain*, const EvaluatedBrain*>> pairs;
  for (std::size_t i = 0; i < evaluation.brains.size(); ++i) {
    for (std::size_t k = i + 1; k < evaluation.brains.size(); ++k) {
      const EvaluatedBrain &first = evaluation.brains[i], &second = evaluation.brains[k];
      // Pairs that differ in both have no interpretation: either could be the reason.
      if (first.brain == second.brain || first.demonstrator == second.demonstrator) {
        pairs.emplace_back(&first, &second);
      }
    }
  }
  return pairs;
}

Json ToJson(const Evaluation& evaluation) {
  Json brains = Json::array(), comparisons = Json::array();
  for (const EvaluatedBrain& brain : evaluation.brains) {
    Json runs = Json::array();
    for (const EvaluatedRun& run : brain.runs) runs.push_back(RunJson(run));
    brains.push_back(
        {{"name", brain.name},
         {"brain", brain.brain},
         {"demonstrator", brain.demonstrator.empty() ? Json() : Json(brain.demonstrator)},
         {"summary", SummaryJson(SummaryOf(brain))},
         {"runs", runs}});
  }
  Json impossible = Json::array();
  for (const ImpossibleLayout& layout : evaluation.impossible) {
    impossible.push_back({{"seed", layout.seed}, {"reason", layout.reason}});
  }
  for (const auto& [first, second] : ComparablePairs(evaluation)) {
    Json comparison{{"first", first->name}, {"second", second->name}};
    comparison.update(ComparisonJson(Compare(*first, *second)));
    comparisons.push_back(comparison);
  }
  return {{"format", kEvaluationFormat},
          {"program", evaluation.program},
          {"demo", evaluation.demo},
          {"scene", evaluation.scene},
          {"level", evaluation.level.empty() ? Json() : Json(evaluation.level)},
          {"options", evaluation.options},
          {"impossible_layouts", impossible},
          {"brains", brains},
          {"comparisons", comparisons}};
}

std::string ToText(const Evaluation& evaluation) {
  std::vector<std::vector<std::string>> rows{{"", "success", "", "95 %", "error mm (95 %)",
                                              "error deg (95 %)", "s p50", "s p95", "retries",
                                              "gain", "right claims"}};
  std::string failures, comparisons;
  for (const EvaluatedBrain& brain : evaluation.brains) {
    const Summary summary = SummaryOf(brain);
    const std::string name = Printable(brain.name);
    rows.push_back({name, std::to_string(summary.successes) + "/" + std::to_string(summary.runs),
                    Percent(summary.success_rate()), PercentRange(summary.success_interval),
                    WithInterval(summary.error_mm, 2), WithInterval(summary.error_degrees, 2),
                    Fixed(summary.seconds_p50, 1), Fixed(summary.seconds_p95, 1),
                    Count(summary.retries), Fixed(summary.mean_gain, 2), RightClaimsText(summary)});
    if (!summary.num_failures.empty())
      failures += name + " failed: " + FailureCountsText(summary) + "\n";
  }
  for (const auto& [first, second] : ComparablePairs(evaluation)) {
    comparisons += ComparisonText(*first, *second);
  }
  return InColumns(rows) + ImpossibleText(evaluation) + failures + comparisons;
}

}  // namespace smile::report
