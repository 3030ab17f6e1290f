#include "app/evaluation_folder.h"

#include <cstdio>
#include <stdexcept>
#include <system_error>

#include "app/content_hash.h"
#include "app/move_aside.h"
#include "base/diagnostic.h"
#include "base/files.h"

namespace smile::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFileBytes = 1 << 20;
constexpr const char* kAgentFile = "agent.json";
constexpr const char* kRunFile = "run.json";
constexpr const char* kRecording = "imitation";

/// A small file of ours; null when it is not there or not whole.
Json ReadOwn(const fs::path& path) {
  try {
    return ParseJson(ReadFile(path, kMaxFileBytes));
  } catch (const InputError&) {
    return nullptr;
  } catch (const std::invalid_argument&) {
    return nullptr;
  }
}

void Remove(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error) throw std::runtime_error(path.string() + ": cannot be deleted: " + error.message());
}

Json MarkOf(std::uint64_t seed, const fs::path& result) {
  return {{"seed", seed}, {"result", ContentOf(result)}};
}

}  // namespace

AgentFolder::AgentFolder(const fs::path& directory, const Json& depends_on)
    : directory_(directory) {
  std::error_code error;
  if (fs::exists(directory_, error) && ReadOwn(directory_ / kAgentFile) != depends_on) {
    MoveAside(directory_);
  }
  MakeDirectories(directory_);
  WriteFile(directory_ / kAgentFile, ToText(depends_on, 2) + "\n");
}

fs::path AgentFolder::FolderOf(std::uint64_t seed) const {
  char name[40];
  std::snprintf(name, sizeof name, "seed-%04llu", static_cast<unsigned long long>(seed));
  return directory_ / name;
}

fs::path AgentFolder::ResultOf(std::uint64_t seed) const { return FolderOf(seed) / "result.json"; }

std::optional<report::EvaluatedRun> AgentFolder::FindRun(std::uint64_t seed) const {
  const Json mark = ReadOwn(FolderOf(seed) / kRunFile);
  if (mark.is_null() || !fs::exists(ResultOf(seed)) || mark != MarkOf(seed, ResultOf(seed))) {
    return std::nullopt;
  }
  try {
    return report::ReadRun(ResultOf(seed), seed);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void AgentFolder::BeginRun(std::uint64_t seed) const {
  Remove(FolderOf(seed));
  MakeDirectories(FolderOf(seed));
}

report::EvaluatedRun AgentFolder::CompleteRun(std::uint64_t seed) const {
  const report::EvaluatedRun run = report::ReadRun(ResultOf(seed), seed);
  WriteFile(FolderOf(seed) / kRunFile, ToText(MarkOf(seed, ResultOf(seed)), 2) + "\n");
  return run;
}

void AgentFolder::Tidy(Keep keep, const fs::path& report_folder, report::EvaluatedRun* run) const {
  const fs::path recording = FolderOf(run->seed) / kRecording;
  const bool is_kept = keep == Keep::kAll || (keep == Keep::kFailures && !run->is_rebuilt);
  std::error_code error;
  if (!is_kept) Remove(recording);
  if (fs::exists(recording, error)) {
    run->recording = recording.lexically_relative(report_folder).generic_string();
  }
}

}  // namespace smile::app
