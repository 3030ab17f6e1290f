#include "report/evaluation_reader.h"

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json_node.h"

namespace smile::report {
namespace {

/// Limits on files, which other programs may have written.
constexpr std::size_t kMaxFileBytes = 256 << 20, kMaxBrains = 1000, kMaxRuns = 10'000'000;
constexpr std::size_t kMaxNameBytes = 256, kMaxReasonBytes = 4096, kMaxOptions = 1000;
constexpr int kMaxKeys = 200'000'000;
constexpr std::uint64_t kMaxReadCount = 1'000'000'000, kMaxReadSeed = std::uint64_t{1} << 53;
constexpr double kLargestNumber = 1e12;
constexpr int kReadFormat = 2;

/// True if a member exists and is not null: older versions have fewer.
bool HasValue(const JsonNode& node, const std::string& name) {
  return node.Has(name) && !node.Member(name).IsNull();
}

std::optional<double> OptionalNumber(const JsonNode& node, const std::string& name) {
  if (!HasValue(node, name)) return std::nullopt;
  return node.Member(name).Number(-kLargestNumber, kLargestNumber);
}

std::optional<std::uint64_t> OptionalCount(const JsonNode& node, const std::string& name) {
  if (!HasValue(node, name)) return std::nullopt;
  return node.Member(name).Whole(0, kMaxReadCount);
}

std::string OptionalText(const JsonNode& node, const std::string& name) {
  return HasValue(node, name) ? node.Member(name).ShortString(kMaxReasonBytes) : "";
}

task::ClaimEnd ClaimIn(const JsonNode& node) {
  return {.is_done = node.Member("done").Flag(),
          .is_right = node.Member("right").Flag(),
          .reason = node.Member("reason").ShortString(kMaxReasonBytes)};
}

EvaluatedRun EvaluatedRunIn(const JsonNode& node) {
  EvaluatedRun run;
  run.seed = HasValue(node, "seed") ? node.Member("seed").Whole(0, kMaxReadSeed) : 0;
  run.has_succeeded = node.Member("success").Flag();
  run.score = OptionalNumber(node, "score").value_or(0);
  run.gain = OptionalNumber(node, "gain");
  run.error_mm = OptionalNumber(node, "error_mm");
  run.error_degrees = OptionalNumber(node, "error_degrees");
  run.seconds = OptionalNumber(node, "seconds");
  run.grasps = OptionalCount(node, "grasps");
  run.retries = OptionalCount(node, "retries");
  run.realtime_factor = OptionalNumber(node, "realtime_factor");
  run.recording = OptionalText(node, "recording");
  if (HasValue(node, "claim")) run.claim = ClaimIn(node.Member("claim"));
  run.failure_reason = task::FailureReasonIn(node.Member("cause"));
  return run;
}

EvaluatedBrain BrainIn(const JsonNode& node) {
  EvaluatedBrain brain;
  brain.name = node.Member("name").ShortString(kMaxNameBytes);
  brain.brain = OptionalText(node, "brain");
  brain.demonstrator = OptionalText(node, "demonstrator");
  for (const JsonNode& run : node.Member("runs").ItemsUpTo(kMaxRuns)) {
    brain.runs.push_back(EvaluatedRunIn(run));
  }
  if (brain.runs.empty()) node.Fail("no runs, expected at least one");
  return brain;
}

std::vector<std::string> OptionsIn(const JsonNode& node) {
  std::vector<std::string> options;
  if (!HasValue(node, "options")) return options;
  for (const JsonNode& option : node.Member("options").ItemsUpTo(kMaxOptions)) {
    options.push_back(option.ShortString(kMaxReasonBytes));
  }
  return options;
}

std::vector<ImpossibleLayout> ImpossibleLayoutsIn(const JsonNode& node) {
  std::vector<ImpossibleLayout> layouts;
  if (!HasValue(node, "impossible_layouts")) return layouts;
  for (const JsonNode& layout : node.Member("impossible_layouts").ItemsUpTo(kMaxRuns)) {
    layouts.push_back({.seed = layout.Member("seed").Whole(0, kMaxReadSeed),
                       .reason = OptionalText(layout, "reason")});
  }
  return layouts;
}

Evaluation EvaluationIn(const JsonNode& node) {
  node.ExpectObject();
  node.Member("format").Number(kReadFormat, kReadFormat);
  Evaluation evaluation;
  evaluation.program = OptionalText(node, "program");
  evaluation.demo = OptionalText(node, "demo");
  evaluation.scene = node.Member("scene").ShortString(kMaxReasonBytes);
  evaluation.level = OptionalText(node, "level");
  evaluation.options = OptionsIn(node);
  evaluation.impossible = ImpossibleLayoutsIn(node);
  for (const JsonNode& brain : node.Member("brains").ItemsUpTo(kMaxBrains)) {
    evaluation.brains.push_back(BrainIn(brain));
  }
  return evaluation;
}

}  // namespace

Evaluation ReadEvaluation(const std::filesystem::path& path) {
  const std::filesystem::path file =
      std::filesystem::is_directory(path) ? path / "evaluation.json" : path;
  const std::string name = file.string();
  try {
    const Json json = ParseJson(ReadFile(file, kMaxFileBytes), kMaxKeys);
    return EvaluationIn(JsonNode(json, name, ""));
  } catch (const std::invalid_argument& error) {
    // Line 0: the file as a whole is no JSON.
    throw InputError({name, 0, "", error.what()});
  }
}

}  // namespace smile::report
