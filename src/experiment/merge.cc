#include "experiment/merge.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json.h"
#include "base/wording.h"
#include "experiment/attempts.h"
#include "experiment/evaluation.h"
#include "experiment/json_file.h"
#include "experiment/shard.h"
#include "report/evaluation_reader.h"

namespace smile::experiment {
namespace {

namespace fs = std::filesystem;

struct MarkedFolder {
  fs::path folder;
  ShardMark mark;
};

[[noreturn]] void FailAt(const fs::path& path, const std::string& message) {
  throw InputError({path.string(), 0, "", message});
}

/// Requires that two folders agree on a file or a part of one, and names the first member in which
/// they do not.
void RequireEqual(const Json& expected, const Json& found, const fs::path& expected_in,
                  const fs::path& found_in) {
  if (expected == found) return;
  std::string name = "format";
  std::string values;
  for (const auto& [member, value] : expected.items()) {
    if (found.contains(member) && found[member] == value) continue;
    name = member;
    values = ": " + (found.contains(member) ? ToText(found[member]) : "missing") + ", expected " +
             ToText(value);
    break;
  }
  FailAt(found_in, "belongs to another job or version than " + expected_in.string() +
                       ": it differs in " + name + values);
}

/// Returns the shards in order.
/// @param shards  by number; not empty.
/// @throws InputError if one is missing.
std::vector<MarkedFolder> InOrder(const std::map<std::size_t, MarkedFolder>& shards) {
  std::vector<MarkedFolder> ordered;
  for (const auto& [index, shard] : shards) ordered.push_back(shard);
  const std::size_t count = ordered.front().mark.shard.count;
  for (std::size_t index = 1; index <= count; ++index) {
    if (shards.contains(index)) continue;
    FailAt(ordered.front().folder, "shard " + ToString(Shard{.index = index, .count = count}) +
                                       " is missing, expected all of them");
  }
  return ordered;
}

/// Returns the shards in folders, in order.
/// @throws InputError unless they are all shards of one job, each once.
std::vector<MarkedFolder> ShardsIn(const std::vector<fs::path>& folders) {
  if (folders.empty()) throw std::invalid_argument("merge: there are no shards");
  std::map<std::size_t, MarkedFolder> shards;
  for (const fs::path& folder : folders) {
    const std::optional<ShardMark> mark = ReadMark(folder);
    if (!mark) {
      FailAt(folder, "is no complete shard, expected the folder of a generate or evaluate --shard");
    }
    const MarkedFolder& first =
        shards.empty() ? MarkedFolder{folder, *mark} : shards.begin()->second;
    RequireEqual({{"kind", first.mark.kind},
                  {"shards", first.mark.shard.count},
                  {"whole", first.mark.whole}},
                 {{"kind", mark->kind}, {"shards", mark->shard.count}, {"whole", mark->whole}},
                 first.folder, folder);
    const auto [it, is_new] = shards.emplace(mark->shard.index, MarkedFolder{folder, *mark});
    if (!is_new) {
      FailAt(folder,
             "is shard " + ToString(mark->shard) + " again, as " + it->second.folder.string());
    }
  }
  return InOrder(shards);
}

void CopyInto(const fs::path& from, const fs::path& to) {
  MakeDirectories(to.parent_path());
  std::error_code error;
  fs::copy(from, to, fs::copy_options::recursive, error);
  if (error) throw std::runtime_error(to.string() + ": cannot be written: " + error.message());
}

void Proceed(std::size_t done, std::size_t total, const Callbacks& callbacks) {
  callbacks.Report("merging", static_cast<double>(done), static_cast<double>(total));
  if (callbacks.IsCancelled()) throw std::runtime_error("interrupted; nothing was written");
}

std::string MergeGenerations(const std::vector<MarkedFolder>& shards, const fs::path& out,
                             const Callbacks& callbacks) {
  const fs::path first = shards.front().folder;
  const Json key = ReadJsonFile(first / "generation.json");
  const auto count = shards.front().mark.whole.at("count").get<std::size_t>();
  std::vector<EndedAttempt> all;
  std::vector<bool> has_attempt(count, false);
  for (const auto& [folder, mark] : shards) {
    if (!fs::exists(folder / "summary.json")) {
      FailAt(folder, "is not complete; continue it with the same command");
    }
    RequireEqual(key, ReadJsonFile(folder / "generation.json"), first, folder);
    for (const EndedAttempt& ended : ReadManifest(folder)) {
      const std::size_t episode = ended.attempt.episode;
      if (episode >= count || !mark.shard.Contains(episode)) {
        FailAt(folder / "manifest.jsonl", "was changed: episode " + std::to_string(episode) +
                                              " does not belong to shard " + ToString(mark.shard));
      }
      has_attempt[episode] = true;
      if (const auto difference = DifferenceOf(ended, folder)) {
        FailAt(folder, *difference + "; repair the shard with the same command");
      }
      if (ended.outcome != Outcome::kImpossible) {
        const fs::path attempt_file = folder / ended.folder() / "attempt.json";
        if (ReadJsonFile(attempt_file) != ToJson(ended)) {
          FailAt(attempt_file, "was changed: it differs from manifest.jsonl");
        }
        CopyInto(folder / ended.folder(), out / ended.folder());
      }
      all.push_back(ended);
      Proceed(episode, count, callbacks);
    }
  }
  const auto missing = std::ranges::find(has_attempt, false);
  if (missing != has_attempt.end()) {
    FailAt(first, "manifest.jsonl was changed, here or in another shard: episode " +
                      std::to_string(missing - has_attempt.begin()) + " is missing");
  }
  CopyInto(first / "generation.json", out / "generation.json");
  const GenerationSummary summary = SummaryOf(all, count);
  WriteManifest(all, summary, out);
  return SummaryText(summary);
}

/// Returns what all shards of an evaluation must agree on.
Json CommonPartOf(const report::Evaluation& evaluation, const fs::path& folder) {
  Json brains = Json::array(), impossible = Json::array();
  for (const report::EvaluatedBrain& brain : evaluation.brains) {
    brains.push_back({brain.name, brain.brain, ReadJsonFile(folder / brain.name / "brain.json")});
  }
  for (const auto& layout : evaluation.impossible) impossible.push_back(layout.seed);
  return {{"program", evaluation.program},
          {"demo", evaluation.demo},
          {"scene", evaluation.scene},
          {"level", evaluation.level},
          {"options", evaluation.options},
          {"impossible_layouts", impossible},
          {"brains", brains}};
}

/// Copies a run, unless it was changed since.
void CopyRun(const report::EvaluatedRun& run, const fs::path& from, const fs::path& to) {
  const fs::path folder = from / FolderNameOf(run.seed);
  // A run that crashed or hung has no result.
  if (fs::exists(folder / "run.json")) {
    auto found = FindRunIn(folder, run.seed);
    if (found) found->recording = run.recording;
    if (found != run) {
      FailAt(folder,
             "was changed: it differs from evaluation.json; repair the shard with the same "
             "command");
    }
  } else if (run.has_succeeded || !fs::exists(folder)) {
    FailAt(folder, "is missing or was changed; repair the shard with the same command");
  }
  CopyInto(folder, to / FolderNameOf(run.seed));
}

std::string MergeEvaluations(const std::vector<MarkedFolder>& shards, const fs::path& out,
                             const Callbacks& callbacks) {
  const fs::path first = shards.front().folder;
  report::Evaluation whole = report::ReadEvaluation(first);
  const Json common = CommonPartOf(whole, first);
  whole.again = shards.front().mark.whole.at("again").get<std::string>();
  for (report::EvaluatedBrain& brain : whole.brains) brain.runs.clear();
  std::size_t num_done = 0;
  for (const auto& [folder, mark] : shards) {
    const report::Evaluation part = report::ReadEvaluation(folder);
    RequireEqual(common, CommonPartOf(part, folder), first, folder);
    for (std::size_t i = 0; i < part.brains.size(); ++i) {
      const std::string& name = part.brains[i].name;
      if (!fs::exists(out / name))
        CopyInto(folder / name / "brain.json", out / name / "brain.json");
      for (const report::EvaluatedRun& run : part.brains[i].runs) {
        CopyRun(run, folder / name, out / name);
        whole.brains[i].runs.push_back(run);
      }
    }
    Proceed(++num_done, shards.size(), callbacks);
  }
  for (report::EvaluatedBrain& brain : whole.brains) {
    std::ranges::sort(brain.runs, {}, &report::EvaluatedRun::seed);
  }
  if (fs::exists(first / kDemonstratorsFolder)) {
    CopyInto(first / kDemonstratorsFolder, out / kDemonstratorsFolder);
  }
  WriteEvaluation(whole, out);
  return report::ToText(whole);
}

std::string MergeInto(const fs::path& out, const std::vector<MarkedFolder>& shards,
                      const Callbacks& callbacks) {
  const std::string& kind = shards.front().mark.kind;
  if (kind == "generation") return MergeGenerations(shards, out, callbacks);
  if (kind == "evaluation") return MergeEvaluations(shards, out, callbacks);
  FailAt(shards.front().folder,
         "is a shard of " + Quoted(kind) + ", expected one of a generation or an evaluation");
}

}  // namespace

std::string Merge(const std::vector<fs::path>& folders, const fs::path& out,
                  const Callbacks& callbacks) {
  const std::vector<MarkedFolder> shards = ShardsIn(folders);
  if (fs::exists(out)) throw std::runtime_error(out.string() + ": exists, expected a new folder");
  const fs::path target = out.has_filename() ? out : out.parent_path();
  fs::path partial = target;
  partial += ".partial";
  fs::remove_all(partial);
  MakeDirectories(partial);
  try {
    std::string text = MergeInto(partial, shards, callbacks);
    fs::rename(partial, target);
    return text;
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(partial, ignored);
    throw;
  }
}

}  // namespace smile::experiment
