#include "report/task_table.h"

#include "base/wording.h"
#include "report/columns.h"
#include "report/evaluation_reader.h"
#include "report/wording.h"

namespace smile::report {
namespace {

/// Returns `tower` for `scenes/tower_robot.xml`.
std::string TaskOf(const std::string& scene) {
  constexpr std::string_view kEnding = "_robot";
  std::string name = std::filesystem::path(scene).stem().string();
  if (name.ends_with(kEnding)) name.resize(name.size() - kEnding.size());
  return name;
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
  const Evaluation evaluation = ReadEvaluation(path);
  std::vector<TaskRow> rows;
  for (const EvaluatedBrain& brain : evaluation.brains) {
    rows.push_back({.task = TaskOf(evaluation.scene),
                    .level = evaluation.level,
                    .brain = brain.name,
                    .summary = SummaryOf(brain),
                    .num_impossible = evaluation.impossible.size()});
  }
  return rows;
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
