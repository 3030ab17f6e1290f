#include "experiment/evaluation_folder.h"

#include <stdexcept>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "experiment/attempts.h"
#include "experiment/content_hash.h"
#include "experiment/move_aside.h"

namespace smile::experiment {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFileBytes = 1 << 20;
constexpr const char* kBrainFile = "brain.json";
constexpr const char* kRunFile = "run.json";
constexpr const char* kResultFile = "result.json";
constexpr const char* kRecording = "imitation";

/// Returns the content of a small file; null if it is missing or damaged.
Json ReadOwn(const fs::path& path) {
  try {
    return ParseJson(ReadFile(path, kMaxFileBytes));
  } catch (const InputError&) {
    // Missing and damaged files mean the same: not done. The run is then repeated.
    return nullptr;
  } catch (const std::invalid_argument&) {
    return nullptr;
  }
}

/// Deletes a file or folder; one that does not exist is fine.
/// @throws std::runtime_error if it cannot be deleted.
void Remove(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error) throw std::runtime_error(path.string() + ": cannot be deleted: " + error.message());
}

/// Returns the mark of a finished run: its seed and the hash of its result, so that a damaged
/// result is noticed.
Json MarkOf(std::uint64_t seed, const fs::path& result) {
  return {{"seed", seed}, {"result", ContentOf(result)}};
}

}  // namespace

EvaluationFolder::EvaluationFolder(const fs::path& directory, const Json& depends_on,
                                   const Callbacks& callbacks)
    : directory_(directory) {
  std::error_code error;
  // Results that depend on something else are kept under another name. Also if `brain.json` itself
  // is missing: the folder may belong to something else.
  if (fs::exists(directory_, error) && ReadOwn(directory_ / kBrainFile) != depends_on) {
    MoveAside(directory_, callbacks);
  }
  MakeDirectories(directory_);
  WriteFile(directory_ / kBrainFile, ToText(depends_on, 2) + "\n");
}

fs::path EvaluationFolder::FolderOf(std::uint64_t seed) const {
  return directory_ / FolderNameOf(seed);
}

fs::path EvaluationFolder::ResultOf(std::uint64_t seed) const {
  return FolderOf(seed) / kResultFile;
}

std::optional<report::EvaluatedRun> EvaluationFolder::FindRun(std::uint64_t seed) const {
  return FindRunIn(FolderOf(seed), seed);
}

std::optional<report::EvaluatedRun> FindRunIn(const fs::path& folder, std::uint64_t seed) {
  const fs::path result = folder / kResultFile;
  // The mark is written after the result, and holds its hash: a run that was killed between the
  // two, or whose result was edited, counts as not done.
  const Json mark = ReadOwn(folder / kRunFile);
  if (mark.is_null() || !fs::exists(result) || mark != MarkOf(seed, result)) return std::nullopt;
  try {
    return report::ReadRun(result, seed);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void EvaluationFolder::BeginRun(std::uint64_t seed) const {
  // Remains of a run that was interrupted.
  Remove(FolderOf(seed));
  MakeDirectories(FolderOf(seed));
}

report::EvaluatedRun EvaluationFolder::CompleteRun(std::uint64_t seed) const {
  const report::EvaluatedRun run = report::ReadRun(ResultOf(seed), seed);
  // Written last: a run without this mark is not finished.
  WriteFile(FolderOf(seed) / kRunFile, ToText(MarkOf(seed, ResultOf(seed)), 2) + "\n");
  return run;
}

void EvaluationFolder::Tidy(Keep keep, const fs::path& report_folder,
                            report::EvaluatedRun* run) const {
  const fs::path recording = FolderOf(run->seed) / kRecording;
  const bool is_kept = keep == Keep::kAll || (keep == Keep::kFailures && !run->has_succeeded);
  std::error_code error;
  if (!is_kept) Remove(recording);
  if (fs::exists(recording, error)) {
    // Relative, so that the folder with its report can be moved or copied.
    run->recording = recording.lexically_relative(report_folder).generic_string();
  }
}

}  // namespace smile::experiment
