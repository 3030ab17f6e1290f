#include "datasets/generated_sets.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <optional>
#include <system_error>
#include <tuple>
#include <utility>

#include "base/diagnostic.h"
#include "base/file_state.h"
#include "base/files.h"
#include "base/wording.h"
#include "experiment/json_file.h"
#include "library/library.h"
#include "page/requests.h"
#include "recording/recording_names.h"
#include "texts/user_message.h"

namespace smile::datasets {

using texts::Say;
namespace {

namespace fs = std::filesystem;
using experiment::EndedAttempt;
using experiment::Outcome;

/// Examined in a folder.
constexpr std::size_t kMaxEntries = 100'000;

/// Returns the folders in a folder; none if it cannot be read.
std::vector<fs::path> FoldersIn(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (found.size() >= kMaxEntries) break;
    if (StateOf(it->path()).is_directory) found.push_back(it->path());
  }
  return found;
}

/// Returns a JSON file; an empty object if it cannot be read.
Json JsonIfAny(const fs::path& file) {
  try {
    return StateOf(file).is_file ? experiment::ReadJsonFile(file) : Json::object();
  } catch (const std::exception&) {
    return Json::object();
  }
}

/// Returns the attempt in its folder; nullopt if it is damaged or not complete.
std::optional<EndedAttempt> AttemptIn(const fs::path& folder) {
  const fs::path file = folder / "attempt.json";
  try {
    if (!StateOf(file).is_file) return std::nullopt;
    const Json json = experiment::ReadJsonFile(file);
    return experiment::EndedAttemptIn(JsonNode(json, file.string(), ""));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// Returns the id by which the library knows the recording of an attempt; null without one.
Json RecordingIdOf(const std::string& set, const EndedAttempt& ended) {
  if (!ended.has_recording) return nullptr;
  return library::AttemptId(set, experiment::FolderNameOf(ended.attempt.seed));
}

Json Described(const std::string& set, const EndedAttempt& ended) {
  const Json json = experiment::ToJson(ended);
  Json attempt{{"recording", RecordingIdOf(set, ended)}};
  for (const char* key : {"seed", "episode", "try", "outcome", "cause", "score", "seconds"}) {
    attempt[key] = json[key];
  }
  attempt["scene"] = fs::path(ended.attempt.variation.scene).stem().string();
  attempt["level"] = ended.attempt.variation.level;
  return attempt;
}

/// Returns the sets in a folder, newest first, as recordings; by the time at which the generation
/// began.
std::vector<fs::path> SetsIn(const fs::path& root) {
  std::vector<fs::path> folders = FoldersIn(root);
  std::erase_if(folders, [](const fs::path& folder) {
    return !StateOf(folder / "generation.json").is_file ||
           !recording::IsRecordingName(folder.filename().string());
  });
  std::ranges::sort(folders, [](const fs::path& a, const fs::path& b) {
    const auto key = [](const fs::path& folder) {
      return StateOf(folder / "generation.json").changed;
    };
    return std::tuple(key(b), a) < std::tuple(key(a), b);
  });
  return folders;
}

/// Returns the file with the request that made the set in a folder.
fs::path RequestFileBeside(const fs::path& folder) { return folder.string() + ".json"; }

/// Returns the episodes, attempts and causes of a summary.
Json CountsOf(const experiment::GenerationSummary& summary) {
  const Json json = experiment::ToJson(summary);
  return {{"attempts", json["attempts"]},
          {"yield", json["yield"]},
          {"interval", json["interval"]},
          {"causes", json["causes"]}};
}

/// Returns the picture that stands for a set: of its first success, or else its first attempt.
Json PictureOf(const std::string& set, const std::vector<EndedAttempt>& attempts) {
  const auto success = std::ranges::find(attempts, Outcome::kSuccess, &EndedAttempt::outcome);
  if (success != attempts.end()) return RecordingIdOf(set, *success);
  return attempts.empty() ? Json() : RecordingIdOf(set, attempts.front());
}

}  // namespace

GeneratedSets::GeneratedSets(fs::path library)
    : library_(std::move(library)), root_(library_ / library::kGeneratedFolder) {}

fs::path GeneratedSets::FolderFor(const std::string& name) const {
  if (!recording::IsRecordingName(name)) {
    throw page::RequestError(recording::FaultOfName(name));
  }
  // Neither a link nor a recording of this name may be written into.
  const FileState state = StateOf(root_);
  const bool is_other = state != FileState() && !state.is_directory;
  if (is_other || StateOf(root_ / "demo.json").is_file) {
    throw page::RequestError(root_.string() + " is no folder of generated sets; rename it");
  }
  return root_ / name;
}

fs::path GeneratedSets::FolderOf(const std::string& name) const {
  fs::path folder = FolderFor(name);
  if (StateOf(folder).is_directory && StateOf(folder / "generation.json").is_file) return folder;
  throw page::RequestError(Say("sets.isUnknown", {{"set", Quoted(name)}}));
}

fs::path GeneratedSets::RequestFileOf(const std::string& name) const {
  return RequestFileBeside(FolderFor(name));
}

void GeneratedSets::Move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  // The folder is the set, and moves at once; what stands beside it follows.
  fs::rename(from, to, error);
  if (error) throw page::RequestError(from.string() + " cannot be moved: " + error.message());
  for (const char* end : {".json", ".log"}) {
    const fs::path beside = from.string() + end;
    if (StateOf(beside).is_file) fs::rename(beside, to.string() + end);
  }
}

void GeneratedSets::Rename(const std::string& name, const std::string& new_name) {
  const fs::path from = FolderOf(name), to = FolderFor(new_name);
  if (StateOf(to) != FileState()) {
    throw page::RequestError(
        Say("sets.nameIsTaken", {{"kind", "set"}, {"name", Quoted(new_name)}}));
  }
  Move(from, to);
}

std::string GeneratedSets::Bin(const std::string& name) {
  const fs::path from = FolderOf(name);
  MakeDirectories(bin());
  const fs::path to = recording::NewDirectory(bin(), name);
  Move(from, to);
  return to.filename().string();
}

std::string GeneratedSets::Unbin(const std::string& name) {
  const fs::path from = bin() / FolderFor(name).filename();
  if (!StateOf(from / "generation.json").is_file) {
    throw page::RequestError(Say("sets.isNotInBin", {{"set", Quoted(name)}}));
  }
  const fs::path to = recording::NewDirectory(root_, name);
  Move(from, to);
  return to.filename().string();
}

std::vector<EndedAttempt> GeneratedSets::Read(const fs::path& folder) {
  std::vector<EndedAttempt> attempts;
  const std::lock_guard lock(mutex_);
  Attempts& known = known_[folder];
  Attempts now;
  for (const char* outcome : {"episodes", "failures"}) {
    for (const fs::path& path : FoldersIn(folder / outcome)) {
      // A set may be deleted, and made again under the same name.
      std::string stamp = StampOf(path / "attempt.json");
      const auto before = known.find(path);
      const bool is_known = before != known.end() && before->second.stamp == stamp;
      auto ended = is_known ? before->second.ended : AttemptIn(path);
      if (!ended) continue;
      attempts.push_back(*ended);
      now.emplace(path, Known{std::move(stamp), *std::move(ended)});
    }
  }
  known = std::move(now);
  std::ranges::sort(attempts, {}, [](const EndedAttempt& ended) { return ended.attempt.seed; });
  return attempts;
}

Json GeneratedSets::List() {
  std::vector<fs::path> folders = SetsIn(root_);
  std::ranges::move(SetsIn(bin()), std::back_inserter(folders));
  if (folders.size() > kMaxSets) folders.resize(kMaxSets);
  Json list = Json::array();
  for (const fs::path& folder : folders) list.push_back(DescribeFolder(folder));
  return list;
}

Json GeneratedSets::Describe(const std::string& name) { return DescribeFolder(FolderOf(name)); }

Json GeneratedSets::DescribeFolder(const fs::path& folder) {
  const std::string name = folder.filename().string();
  const std::vector<EndedAttempt> attempts = Read(folder);
  const Json request = JsonIfAny(RequestFileBeside(folder)),
             made = JsonIfAny(folder / "summary.json");
  const Json wanted = request.contains("count") ? request["count"] : made.value("wanted", Json());
  const auto summary = experiment::SummaryOf(attempts, 0);
  Json set{{"name", name}};
  for (const char* key : {"recording", "scene", "level", "brain"}) {
    set[key] = request.value(key, Json());
  }
  set["wanted"] = wanted;
  set["episodes"] = summary.yield.successes;
  set.update(CountsOf(summary));
  // A summary is written last; of fewer episodes than wanted now, it is of an earlier command.
  set["is_complete"] = made.contains("wanted") && made["wanted"] == wanted;
  set["can_continue"] = !request.empty();
  // Recordings in the bin have no ids, hence no pictures.
  const bool is_binned = folder.parent_path() == bin();
  set["binned"] = is_binned;
  set["picture"] = is_binned ? Json() : PictureOf(name, attempts);
  return set;
}

Json GeneratedSets::AttemptsOf(const std::string& name) {
  Json list = Json::array();
  for (const EndedAttempt& ended : Read(FolderOf(name))) {
    if (list.size() >= kMaxAttempts) break;
    list.push_back(Described(name, ended));
  }
  return list;
}

Json GeneratedSets::ProgressOf(const std::string& name, std::size_t wanted) {
  const auto summary = experiment::SummaryOf(Read(FolderFor(name)), wanted);
  Json progress{{"done", summary.yield.successes}, {"total", wanted}};
  progress.update(CountsOf(summary));
  return progress;
}

}  // namespace smile::datasets
