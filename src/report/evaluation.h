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

namespace smile::report {

/// One imitation: a robot program in one starting layout.
struct EvaluatedRun {
  std::uint64_t seed = 0;  ///< of the layout
  bool is_rebuilt = false;
  double score = 0;  ///< share of the structure, 0 to 1
  // As far as the run came to tell:
  std::optional<double> error_mm, error_degrees;  ///< mean over the structure
  std::optional<double> seconds;                  ///< simulated
  std::optional<std::uint64_t> grasps, retries;
  std::optional<double> realtime_factor;              ///< by the clock on the wall
  std::optional<task::FailureReason> failure_reason;  ///< of failures, each of which has one
  std::string recording;  ///< seen from the report; empty where none was kept

  bool operator==(const EvaluatedRun&) const = default;
};

/// What a `result.json` (docs/results.md) says. Fields that older versions did not have may be
/// missing.
/// @throws InputError if there is none, or it contradicts itself.
EvaluatedRun ReadRun(const std::filesystem::path& result_json, std::uint64_t seed);

/// A robot program and how it fared.
struct EvaluatedAgent {
  std::string name;                ///< unique among those it is compared with
  std::string brain;               ///< as the user named it
  std::vector<EvaluatedRun> runs;  ///< the same seeds for all, in ascending order
  std::string demonstrator = {};   ///< whom it saw; empty: the recording as it is
};

/// Robot programs that did the same task from the same starting layouts.
struct Evaluation {
  std::string program;            ///< version of the simulator
  std::string demo, scene;        ///< as the user named them
  std::string level;              ///< of the layouts; empty: the usual one
  std::vector<std::string> ways;  ///< other options that each run was given
  std::vector<EvaluatedAgent> agents;
  std::string again;  ///< what to type for a run with pictures; `NAME`, … stand for what differs
};

/// Of one agent. What tells how well and how fast is of the rebuilt structures only.
struct Summary {
  std::size_t runs = 0, rebuilt = 0;
  Interval success;  ///< of the share that is rebuilt
  std::optional<Mean> error_mm, error_degrees;
  std::optional<double> seconds_p50, seconds_p95;
  std::optional<std::uint64_t> grasps, retries;     ///< in all runs together that tell
  std::map<std::string, std::size_t> num_failures;  ///< by FailureReason::code

  double success_rate() const { return static_cast<double>(rebuilt) / static_cast<double>(runs); }
};
/// @param agent  with at least one run.
Summary SummaryOf(const EvaluatedAgent& agent);

/// Of two agents, seed by seed. Differences are of the first less the second, where both rebuilt.
struct Comparison {
  std::size_t both = 0, only_first = 0, only_second = 0, neither = 0;  ///< rebuilt
  double success_difference = 0;
  double p_value = 1;  ///< exact McNemar
  std::optional<Mean> error_mm, error_degrees, seconds;
};
/// @param first, second  with the same seeds.
Comparison Compare(const EvaluatedAgent& first, const EvaluatedAgent& second);

/// Those that have the robot program or the demonstrator in common, each two once. Of others nobody
/// could say what a difference comes from.
std::vector<std::pair<const EvaluatedAgent*, const EvaluatedAgent*>> ComparablePairs(
    const Evaluation& evaluation);

/// `evaluation.json` (docs/experiments.md). The same runs give the same bytes, but for what the
/// clock on the wall says.
Json ToJson(const Evaluation& evaluation);

/// The same for a terminal: a table of agents, their failures, and how they compare.
std::string ToText(const Evaluation& evaluation);

}  // namespace smile::report
