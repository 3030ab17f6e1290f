#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "base/json.h"
#include "experiment/callbacks.h"
#include "report/evaluation.h"

namespace smile::experiment {

/// Which recordings are kept at the end.
enum class Keep { kAll, kFailures, kNone };

/// The runs of one brain on disk, one folder for each seed:
///
///     NAME/brain.json                everything that all of them depend on
///     NAME/seed-0007/result.json     see docs/results.md
///     NAME/seed-0007/run.json        written last: marks a finished run
///     NAME/seed-0007/log.txt         its output
///     NAME/seed-0007/imitation/      its recording
///
/// Runs that depend on different things never share a folder: when something changed, the earlier
/// folder moves aside, to `NAME.1`, `NAME.2`, …
class EvaluationFolder {
 public:
  /// @param depends_on  everything the results depend on, except the seed.
  /// @throws std::runtime_error if the folder cannot be written.
  EvaluationFolder(const std::filesystem::path& directory, const Json& depends_on,
                   const Callbacks& callbacks = {});

  std::filesystem::path FolderOf(std::uint64_t seed) const;

  /// Returns a run that was finished before; nullopt if it was not, or is damaged.
  std::optional<report::EvaluatedRun> FindRun(std::uint64_t seed) const;

  /// Makes an empty folder for a run, in place of the one that an interrupted run left.
  void BeginRun(std::uint64_t seed) const;
  /// Reads the result that a run wrote, and marks the run as finished.
  /// @throws InputError if it is missing or damaged.
  report::EvaluatedRun CompleteRun(std::uint64_t seed) const;

  /// Deletes the recording unless it is to be kept; else stores its path in the run.
  /// @param report_folder  folder that the path is relative to.
  void Tidy(Keep keep, const std::filesystem::path& report_folder, report::EvaluatedRun* run) const;

 private:
  std::filesystem::path ResultOf(std::uint64_t seed) const;

  std::filesystem::path directory_;
};

/// Returns the finished run in a folder `seed-…`; nullopt if it is not finished, or damaged.
std::optional<report::EvaluatedRun> FindRunIn(const std::filesystem::path& folder,
                                              std::uint64_t seed);

}  // namespace smile::experiment
