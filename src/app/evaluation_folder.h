#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "base/json.h"
#include "report/evaluation.h"

namespace smile::app {

/// Which recordings stay when all is done.
enum class Keep { kAll, kFailures, kNone };

/// Where the runs of one robot program lie, one folder a seed:
///
///     NAME/agent.json                what all of them depend on
///     NAME/seed-0007/result.json     see docs/results.md
///     NAME/seed-0007/run.json        written last: this run came to its end
///     NAME/seed-0007/log.txt         what it printed
///     NAME/seed-0007/imitation/      the recording
///
/// Runs of other programs, scenes, … never lie beside one another here: when something changed, the
/// folder of before moves aside, to `NAME.1`, `NAME.2`, …
class AgentFolder {
 public:
  /// @param depends_on  what the results depend on, but for the seed.
  /// @throws std::runtime_error if the disk says no.
  AgentFolder(const std::filesystem::path& directory, const Json& depends_on);

  std::filesystem::path FolderOf(std::uint64_t seed) const;
  std::filesystem::path LogOf(std::uint64_t seed) const { return FolderOf(seed) / "log.txt"; }

  /// A run that came to its end before; nullopt if it did not, or is damaged.
  std::optional<report::EvaluatedRun> FindRun(std::uint64_t seed) const;

  /// Makes room for a run: an empty folder, in place of what an interrupted one left.
  void BeginRun(std::uint64_t seed) const;
  /// The result that a run wrote itself; from now on, FindRun() finds it.
  /// @throws InputError if it is none.
  report::EvaluatedRun CompleteRun(std::uint64_t seed) const;

  /// Deletes the recording unless it is to be kept, and says in the run where it is.
  /// @param report_folder  from where the recording will be linked.
  void Tidy(Keep keep, const std::filesystem::path& report_folder, report::EvaluatedRun* run) const;

 private:
  std::filesystem::path ResultOf(std::uint64_t seed) const;

  std::filesystem::path directory_;
};

}  // namespace smile::app
