#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "experiment/variation.h"
#include "report/statistics.h"
#include "task/failure_reason.h"

namespace smile::experiment {

// The files of a generation (docs/generation.md):
//
//     generation.json           everything that its attempts depend on
//     manifest.jsonl            each attempt, a line each
//     summary.json              yield
//     episodes/seed-0007/       a success: `result.json`, `imitation/` and `attempt.json`
//     failures/seed-0008/       a failure: the same, as far as it came
//
// None of them contains wall-clock times or names of folders: equal generations have equal bytes.

/// Seeds of the first and the second attempt at an episode differ by this: an episode that fails is
/// tried again in another layout, whatever becomes of the others.
inline constexpr std::uint64_t kSeedsBetweenTries = 1'000'000;

/// Attempt at an episode.
struct Attempt {
  std::size_t episode = 0;  ///< from 0
  std::size_t number = 1;   ///< of the attempts at it, from 1
  std::uint64_t seed = 0;
  Variation variation;

  bool operator==(const Attempt&) const = default;
};

/// Returns `seed-0007`.
std::string FolderNameOf(std::uint64_t seed);

enum class Outcome {
  kSuccess,
  kFailure,
  kImpossible  ///< there was no such layout, or nothing to do in it; no run
};

/// An attempt that came to its end, and what became of it.
struct EndedAttempt {
  Attempt attempt;
  Outcome outcome = Outcome::kFailure;
  std::optional<task::FailureReason> cause;  ///< unless it is a success
  double score = 0;
  std::optional<double> seconds;  ///< simulated, of the run
  bool has_recording = false;
  std::string recording_hash, result_hash;  ///< of `imitation/` and `result.json`; empty: none
  std::string state_hash;  ///< of the last state, the same in its replay; empty if not verified

  /// Returns the path of its folder within that of the generation; empty if it has none.
  std::filesystem::path folder() const;
  bool operator==(const EndedAttempt&) const = default;
};

/// Returns the line of the manifest.
Json ToJson(const EndedAttempt& ended);

/// @throws InputError if it is damaged.
EndedAttempt EndedAttemptIn(const JsonNode& node);

/// Returns the attempt that left its files in a folder; nullopt if there is no such folder, or
/// something in it was changed.
std::optional<EndedAttempt> FindAttempt(const Attempt& attempt,
                                        const std::filesystem::path& generation);

/// Returns what differs between the files of an attempt and its record; nullopt if nothing does.
std::optional<std::string> DifferenceOf(const EndedAttempt& ended,
                                        const std::filesystem::path& generation);

/// Counts of attempts. Impossible ones are counted apart.
struct Yield {
  std::size_t attempts = 0, successes = 0;

  Json json() const;  ///< with Wilson's interval
  bool operator==(const Yield&) const = default;
};

struct GenerationSummary {
  std::size_t wanted = 0, impossible = 0;
  Yield yield;
  std::map<std::string, std::size_t> causes;  ///< of failures, by FailureReason::code
  std::map<std::string, Yield> levels;
};

/// @param wanted  number of episodes.
GenerationSummary SummaryOf(const std::vector<EndedAttempt>& attempts, std::size_t wanted);

Json ToJson(const GenerationSummary& summary);

/// Returns the summary as text for a terminal.
std::string SummaryText(const GenerationSummary& summary);

/// Writes `manifest.jsonl` and `summary.json`.
/// @param attempts  in any order.
void WriteManifest(std::vector<EndedAttempt> attempts, const GenerationSummary& summary,
                   const std::filesystem::path& generation);

/// @throws InputError if it is missing or damaged.
std::vector<EndedAttempt> ReadManifest(const std::filesystem::path& generation);

}  // namespace smile::experiment
