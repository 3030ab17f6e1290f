#include "report/task_table.h"

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json_node.h"
#include "base/wording.h"
#include "report/columns.h"
#include "report/wording.h"

namespace smile::report {
namespace {

/// Limits on files, which other programs may have written.
constexpr std::size_t kMaxFileBytes = 256 << 20, kMaxBrains = 1000, kMaxRuns = 10'000'000;
constexpr std::size_t kMaxNameBytes = 256, kMaxReasonBytes = 4096;
constexpr double kLargestNumber = 1e12;
constexpr int kFormat = 2;

std::optional<double> OptionalNumber(const JsonNode& node, const std::string& name) {
  if (!node.Has(name) || node.Member(name).IsNull()) return std::nullopt;
  return node.Member(name).Number(-kLargestNumber, kLargestNumber);
}

/// Returns what a summary needs of a run.
EvaluatedRun RunOf(const JsonNode& node) {
  EvaluatedRun run{.has_succeeded = node.Member("success").Flag(),
                   .gain = OptionalNumber(node, "gain"),
                   .error_mm = OptionalNumber(node, "error_mm"),
                   .seconds = OptionalNumber(node, "seconds")};
  if (node.Has("claim") && !node.Member("claim").IsNull()) {
    const JsonNode claim = node.Member("claim");
    run.claim = task::ClaimEnd{.is_done = claim.Member("done").Flag(),
                               .is_right = claim.Member("right").Flag(),
                               .reason = claim.Member("reason").ShortString(kMaxReasonBytes)};
  }
  if (!node.Member("cause").IsNull()) {
    run.failure_reason = task::FailureReason{
        .code = node.Member("cause").Member("word").ShortString(kMaxNameBytes), .text = ""};
  }
  return run;
}

/// Returns `tower` for `scenes/tower_robot.xml`.
std::string TaskOf(const std::string& scene) {
  constexpr std::string_view kEnding = "_robot";
  std::string name = std::filesystem::path(scene).stem().string();
  if (name.ends_with(kEnding)) name.resize(name.size() - kEnding.size());
  return name;
}

std::vector<TaskRow> RowsIn(const JsonNode& evaluation) {
  evaluation.Member("format").Number(kFormat, kFormat);
  const JsonNode level = evaluation.Member("level");
  const std::string task = TaskOf(evaluation.Member("scene").ShortString(kMaxReasonBytes));
  const std::size_t num_impossible =
      evaluation.Has("impossible_layouts")
          ? evaluation.Member("impossible_layouts").ItemsUpTo(kMaxRuns).size()
          : 0;
  std::vector<TaskRow> rows;
  for (const JsonNode& node : evaluation.Member("brains").ItemsUpTo(kMaxBrains)) {
    EvaluatedBrain brain{.name = node.Member("name").ShortString(kMaxNameBytes)};
    for (const JsonNode& run : node.Member("runs").ItemsUpTo(kMaxRuns)) {
      brain.runs.push_back(RunOf(run));
    }
    if (brain.runs.empty()) node.Fail("no runs, expected at least one");
    rows.push_back({.task = task,
                    .level = level.IsNull() ? "" : level.ShortString(kMaxNameBytes),
                    .brain = brain.name,
                    .summary = SummaryOf(brain),
                    .num_impossible = num_impossible});
  }
  return rows;
}

std::vector<std::string> CellsOf(const TaskRow& row) {
  const Summary& summary = row.summary;
  return {Printable(row.task),
          Printable(row.level),
          Printable(row.brain),
          std::to_string(summary.successes) + " of " + std::to_string(summary.runs),
          PercentRange(summary.success_interval),
          Fixed(summary.mean_gain, 2),
          summary.error_mm ? Fixed(summary.error_mm->value, 2) : kNone,
          RightClaimsText(summary),
          row.num_impossible == 0 ? "" : std::to_string(row.num_impossible),
          FailureCountsText(summary)};
}

/// Returns a cell of a Markdown table: names may contain bars.
std::string TableCell(const std::string& text) {
  std::string escaped;
  for (const char letter : text) escaped += letter == '|' ? "\\|" : std::string(1, letter);
  return escaped;
}

}  // namespace

std::vector<TaskRow> ReadTaskRows(const std::filesystem::path& path) {
  const std::filesystem::path file =
      std::filesystem::is_directory(path) ? path / "evaluation.json" : path;
  const std::string name = file.string();
  try {
    const Json json = ParseJson(ReadFile(file, kMaxFileBytes));
    const JsonNode evaluation(json, name, "");
    evaluation.ExpectObject();
    return RowsIn(evaluation);
  } catch (const std::invalid_argument& error) {
    // Line 0: the file as a whole is no JSON.
    throw InputError({name, 0, "", error.what()});
  }
}

std::string TableOf(const std::vector<TaskRow>& rows, TableForm form) {
  std::vector<std::vector<std::string>> cells{{"task", "level", "brain", "success", "95 %", "gain",
                                               "error mm", "right claims", "left out", "causes"}};
  bool has_level = false, has_impossible = false;
  for (const TaskRow& row : rows) {
    cells.push_back(CellsOf(row));
    has_level = has_level || !row.level.empty();
    has_impossible = has_impossible || row.num_impossible > 0;
  }
  // Columns that say nothing are left out.
  for (auto& row : cells) {
    if (!has_impossible) row.erase(row.begin() + 8);
    if (!has_level) row.erase(row.begin() + 1);
  }
  if (form == TableForm::kText) return InColumns(cells, has_level ? 3 : 2);
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const std::string& cell : cells[i]) text += "| " + TableCell(cell) + " ";
    text += "|\n";
    if (i > 0) continue;
    for (std::size_t k = 0; k < cells[i].size(); ++k) text += "|---";
    text += "|\n";
  }
  return text;
}

}  // namespace smile::report
