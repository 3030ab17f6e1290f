#include "experiment/attempts.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "base/diagnostic.h"
#include "base/files.h"
#include "experiment/content_hash.h"
#include "report/wording.h"

namespace smile::experiment {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kOutcomeWords{"success", "failure", "impossible"};
constexpr std::size_t kMaxAttemptBytes = 1 << 20, kMaxManifestBytes = std::size_t{4} << 30;
constexpr std::size_t kMaxAttemptWordBytes = 64;
constexpr std::uint64_t kMaxAttemptSeed = std::uint64_t{1} << 53;

std::string TextOrEmpty(const JsonNode& node) {
  return node.IsNull() ? std::string() : node.ShortString(kMaxAttemptWordBytes);
}
Json TextOrNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

Outcome OutcomeIn(const JsonNode& node) {
  const std::string word = node.String();
  const auto found = std::ranges::find(kOutcomeWords, word);
  if (found == kOutcomeWords.end()) node.Fail("is \"" + word + "\", expected an outcome");
  return static_cast<Outcome>(found - kOutcomeWords.begin());
}

/// Returns the hash of a file or folder; empty if it is missing.
std::string HashIfAny(const fs::path& path) { return fs::exists(path) ? ContentOf(path) : ""; }

EndedAttempt ParseAttempt(std::string_view text, const std::string& file) {
  const Json json = ParseJson(text);
  return EndedAttemptIn(JsonNode(json, file, ""));
}

}  // namespace

std::string FolderNameOf(std::uint64_t seed) {
  char name[40];
  // Four digits, so that lists of folders are in order for the usual seeds; larger ones are longer.
  std::snprintf(name, sizeof name, "seed-%04llu", static_cast<unsigned long long>(seed));
  return name;
}

fs::path EndedAttempt::folder() const {
  if (outcome == Outcome::kImpossible) return {};
  return fs::path(outcome == Outcome::kSuccess ? "episodes" : "failures") /
         FolderNameOf(attempt.seed);
}

Json ToJson(const EndedAttempt& ended) {
  return {{"episode", ended.attempt.episode},
          {"try", ended.attempt.number},
          {"seed", ended.attempt.seed},
          {"variation", ToJson(ended.attempt.variation)},
          {"outcome", kOutcomeWords[static_cast<std::size_t>(ended.outcome)]},
          {"cause", task::ToJson(ended.cause)},
          {"score", ended.score},
          {"seconds", ended.seconds ? Json(*ended.seconds) : Json()},
          {"recording",
           ended.has_recording ? Json((ended.folder() / "imitation").generic_string()) : Json()},
          {"hash", TextOrNull(ended.recording_hash)},
          {"result_hash", TextOrNull(ended.result_hash)},
          {"state_hash", TextOrNull(ended.state_hash)}};
}

EndedAttempt EndedAttemptIn(const JsonNode& node) {
  node.ExpectObject();
  // By assignments: GCC 12 destroys members of an aggregate twice if a later one throws.
  EndedAttempt ended;
  ended.attempt.episode = node.Member("episode").Whole(0, kMaxAttemptSeed);
  ended.attempt.number = node.Member("try").Whole(1, kMaxAttemptSeed);
  ended.attempt.seed = node.Member("seed").Whole(0, kMaxAttemptSeed);
  ended.attempt.variation = VariationIn(node.Member("variation"));
  ended.outcome = OutcomeIn(node.Member("outcome"));
  ended.score = node.Member("score").Number(0, 1);
  if (!node.Member("seconds").IsNull()) ended.seconds = node.Member("seconds").Number();
  ended.has_recording = !node.Member("recording").IsNull();
  ended.recording_hash = TextOrEmpty(node.Member("hash"));
  ended.result_hash = TextOrEmpty(node.Member("result_hash"));
  ended.state_hash = TextOrEmpty(node.Member("state_hash"));
  ended.cause = task::FailureReasonIn(node.Member("cause"));
  return ended;
}

std::optional<EndedAttempt> FindAttempt(const Attempt& attempt, const fs::path& generation) {
  for (const Outcome outcome : {Outcome::kSuccess, Outcome::kFailure}) {
    const fs::path folder = EndedAttempt{.attempt = attempt, .outcome = outcome}.folder();
    const fs::path file = generation / folder / "attempt.json";
    if (!fs::exists(file)) continue;
    try {
      EndedAttempt ended = ParseAttempt(ReadFile(file, kMaxAttemptBytes), file.string());
      if (ended.attempt == attempt && ended.outcome == outcome &&
          !DifferenceOf(ended, generation)) {
        return ended;
      }
    } catch (const InputError&) {
      // Damaged files mean: not done. The attempt is then repeated.
    } catch (const std::invalid_argument&) {
    }
  }
  return std::nullopt;
}

std::optional<std::string> DifferenceOf(const EndedAttempt& ended, const fs::path& generation) {
  if (ended.outcome == Outcome::kImpossible) return std::nullopt;
  const fs::path folder = generation / ended.folder();
  for (const auto& [name, hash] : {std::pair{"imitation", ended.recording_hash},
                                   std::pair{"result.json", ended.result_hash}}) {
    const fs::path path = folder / name;
    if (!hash.empty() && !fs::exists(path)) return path.string() + " is missing";
    if (HashIfAny(path) != hash) {
      return path.string() + " was changed: its hash is " + HashIfAny(path) + ", recorded " +
             (hash.empty() ? "none" : hash);
    }
  }
  return std::nullopt;
}

Json Yield::json() const {
  if (attempts == 0) {
    return {{"attempts", 0}, {"successes", 0}, {"yield", nullptr}, {"interval", nullptr}};
  }
  const report::Interval interval = report::WilsonInterval(successes, attempts);
  return {{"attempts", attempts},
          {"successes", successes},
          {"yield", static_cast<double>(successes) / static_cast<double>(attempts)},
          {"interval", {interval.low, interval.high}}};
}

GenerationSummary SummaryOf(const std::vector<EndedAttempt>& attempts, std::size_t wanted) {
  GenerationSummary summary{.wanted = wanted};
  for (const EndedAttempt& ended : attempts) {
    if (ended.outcome == Outcome::kImpossible) {
      ++summary.impossible;
      continue;
    }
    for (Yield* yield : {&summary.yield, &summary.levels[ended.attempt.variation.level]}) {
      ++yield->attempts;
      if (ended.outcome == Outcome::kSuccess) ++yield->successes;
    }
    if (ended.cause) ++summary.causes[ended.cause->code];
  }
  return summary;
}

Json ToJson(const GenerationSummary& summary) {
  Json causes = Json::object(), levels = Json::object();
  for (const auto& [word, count] : summary.causes) causes[word] = count;
  for (const auto& [level, yield] : summary.levels) levels[level] = yield.json();
  Json json{{"format", 1}, {"wanted", summary.wanted}, {"episodes", summary.yield.successes}};
  json.update(summary.yield.json());
  json["impossible"] = summary.impossible;
  json["causes"] = causes;
  json["levels"] = levels;
  return json;
}

std::string SummaryText(const GenerationSummary& summary) {
  std::string text = std::to_string(summary.yield.successes) + " of " +
                     report::Plural(summary.wanted, "episode") + "\n";
  const auto line = [](const std::string& name, const Yield& yield) {
    return name + ": " + std::to_string(yield.successes) + " of " +
           report::Plural(yield.attempts, "attempt") + ", 95 %: " +
           report::PercentRange(report::WilsonInterval(yield.successes, yield.attempts)) + "\n";
  };
  if (summary.yield.attempts > 0) text += line("yield", summary.yield);
  if (summary.levels.size() > 1) {
    for (const auto& [level, yield] : summary.levels) text += line("  " + level, yield);
  }
  std::string causes;
  for (const auto& [word, count] : summary.causes) {
    causes += (causes.empty() ? "" : ", ") + std::to_string(count) + " x " + word;
  }
  if (!causes.empty()) text += "failures: " + causes + "\n";
  if (summary.impossible > 0) {
    text += "left out: " + report::Plural(summary.impossible, "layout") + "\n";
  }
  return text;
}

void WriteManifest(std::vector<EndedAttempt> attempts, const GenerationSummary& summary,
                   const fs::path& generation) {
  std::ranges::sort(attempts, {}, [](const EndedAttempt& ended) {
    return std::tuple(ended.attempt.episode, ended.attempt.number);
  });
  std::string lines;
  for (const EndedAttempt& ended : attempts) lines += ToText(ToJson(ended)) + "\n";
  WriteFile(generation / "manifest.jsonl", lines);
  // Written last: a generation with a summary is complete.
  WriteFile(generation / "summary.json", ToText(ToJson(summary), 2) + "\n");
}

std::vector<EndedAttempt> ReadManifest(const fs::path& generation) {
  const fs::path file = generation / "manifest.jsonl";
  std::istringstream lines(ReadFile(file, kMaxManifestBytes));
  std::vector<EndedAttempt> attempts;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    try {
      attempts.push_back(ParseAttempt(line, file.string()));
    } catch (const std::invalid_argument& error) {
      throw InputError({file.string(), number, "", error.what()});
    }
  }
  return attempts;
}

}  // namespace smile::experiment
