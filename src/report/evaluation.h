#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/json.h"
#include "report/statistics.h"
#include "task/failure_reason.h"
#include "task/imitation_result.h"

namespace smile::report {

/// Run of an evaluation: one brain in one starting layout.
struct EvaluatedRun {
  std::uint64_t seed = 0;  ///< of the layout
  bool has_succeeded = false;
  double score = 0;                     ///< fraction of the structure, 0 to 1
  std::optional<double> gain;           ///< of the score over that at the start; may be below 0
  std::optional<task::ClaimEnd> claim;  ///< of the brain about its run
  // Only if the run reported them:
  std::optional<double> error_mm, error_degrees;  ///< mean over the structure
  std::optional<double> seconds;                  ///< simulated
  std::optional<std::uint64_t> grasps, retries;
  std::optional<double> realtime_factor;              ///< simulated time per wall-clock time
  std::optional<task::FailureReason> failure_reason;  ///< of failures, each of which has one
  std::string recording;  ///< path from the report; empty if none was kept

  bool operator==(const EvaluatedRun&) const = default;
};

/// Reads a `result.json` (docs/results.md). Fields that older versions did not have may be missing.
/// @throws InputError if it is missing or inconsistent.
EvaluatedRun ReadRun(const std::filesystem::path& result_json, std::uint64_t seed);

/// The runs of a brain with one demonstrator.
struct EvaluatedBrain {
  std::string name;                ///< unique among those it is compared with
  std::string brain;               ///< as the user named it
  std::vector<EvaluatedRun> runs;  ///< the same seeds for all, in ascending order
  std::string demonstrator = {};   ///< in its pictures; empty: the recording as it is
};

/// Starting layout that was left out: no brain could have shown anything there.
struct ImpossibleLayout {
  std::uint64_t seed = 0;
  std::string reason;

  bool operator==(const ImpossibleLayout&) const = default;
};

/// Evaluation: brains that did the same task from the same starting layouts.
struct Evaluation {
  std::string program;               ///< version of the simulator
  std::string demo, scene;           ///< as the user named them
  std::string level;                 ///< of the layouts; empty: the usual one
  std::vector<std::string> options;  ///< other options that each run was given
  std::vector<EvaluatedBrain> brains;
  std::vector<ImpossibleLayout> impossible;  ///< by seed
  std::string again;  ///< command for a run with pictures; `NAME`, … are placeholders
};

/// Summary of one brain. Errors and times are those of successful runs only.
struct Summary {
  std::size_t runs = 0, successes = 0;
  Interval success_interval;  ///< of the success rate
  std::optional<Mean> error_mm, error_degrees;
  std::optional<double> seconds_p50, seconds_p95;
  std::optional<double> mean_gain;                  ///< over all runs that have one
  std::size_t right_claims = 0, wrong_claims = 0;   ///< see task::ClaimEnd
  std::optional<std::uint64_t> grasps, retries;     ///< sums over all runs that have them
  std::map<std::string, std::size_t> num_failures;  ///< by FailureReason::code

  double success_rate() const { return static_cast<double>(successes) / static_cast<double>(runs); }
};
/// @param brain  with at least one run.
Summary SummaryOf(const EvaluatedBrain& brain);

/// Returns the right ones among the claims of a brain, as `9 of 10`; `–` without any.
std::string RightClaimsText(const Summary& summary);

/// Returns the number of failures for each cause: `2 x brain_failed, 1 x time_up`; empty without
/// any.
std::string FailureCountsText(const Summary& summary);

/// Comparison of two brains, seed by seed. Differences are first minus second, where both
/// rebuilt.
struct BrainComparison {
  std::size_t both = 0, only_first = 0, only_second = 0, neither = 0;  ///< succeeded
  double success_difference = 0;
  double p_value = 1;  ///< exact McNemar
  std::optional<Mean> error_mm, error_degrees, seconds;
};
/// @param first, second  with the same seeds.
BrainComparison Compare(const EvaluatedBrain& first, const EvaluatedBrain& second);

/// Returns each pair with the same brain or the same demonstrator once. In other pairs the cause of
/// a difference would be ambiguous.
std::vector<std::pair<const EvaluatedBrain*, const EvaluatedBrain*>> ComparablePairs(
    const Evaluation& evaluation);

/// Returns `evaluation.json` (docs/experiments.md). Equal runs give equal bytes, except wall-clock
/// times.
Json ToJson(const Evaluation& evaluation);

/// Returns the evaluation as text for a terminal: a table of brains, their failures, and
/// comparisons.
std::string ToText(const Evaluation& evaluation);

}  // namespace smile::report
