// `smile tabulate`: one table of several evaluations, task by task and brain by brain.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/exit_code.h"
#include "report/task_table.h"

namespace smile::app {
namespace {

struct TabulateOptions {
  std::vector<std::string> evaluations;
  bool is_markdown = false;
};

int Tabulate(const TabulateOptions& options) {
  std::vector<report::TaskRow> rows;
  for (const std::string& evaluation : options.evaluations) {
    for (report::TaskRow& row : report::ReadTaskRows(evaluation)) rows.push_back(std::move(row));
  }
  const auto form = options.is_markdown ? report::TableForm::kMarkdown : report::TableForm::kText;
  std::printf("%s", report::TableOf(rows, form).c_str());
  return kDone;
}

}  // namespace

void AddTabulate(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<TabulateOptions>();
  CLI::App* tabulate =
      program->add_subcommand("tabulate", "Print one table of several evaluations: task by brain");
  tabulate
      ->add_option("EVALUATION", options->evaluations,
                   "directory of an evaluation, or its evaluation.json")
      ->required();
  tabulate->add_flag("--markdown", options->is_markdown, "as a table for a Markdown document");
  tabulate->callback([options, answer] { *answer = Tabulate(*options); });
}

}  // namespace smile::app
