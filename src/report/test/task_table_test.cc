#include "report/task_table.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/diagnostic.h"
#include "base/files.h"

namespace smile::report {
namespace {

EvaluatedRun RunWith(bool has_succeeded, double gain, bool is_right) {
  EvaluatedRun run{.has_succeeded = has_succeeded,
                   .score = gain,
                   .gain = gain,
                   .claim = task::ClaimEnd{.is_done = true, .is_right = is_right},
                   .error_mm = 0.5};
  if (!has_succeeded) run.failure_reason = task::FailureReason{"misplaced", "a is away"};
  return run;
}

class TaskTable : public ::testing::Test {
 protected:
  TaskTable() { MakeDirectories(folder_); }
  ~TaskTable() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path Write(const std::string& text) const {
    WriteFile(folder_ / "evaluation.json", text);
    return folder_;
  }

  std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                  ("smile_" + std::to_string(getpid()) + "_task_table");
};

TEST_F(TaskTable, HasARowForEachTaskAndBrain) {
  Evaluation evaluation{.scene = "scenes/tower_robot.xml",
                        .brains = {{"idle", "idle", {RunWith(false, 0, false)}},
                                   {"a|b", "b", {RunWith(true, 1, true)}}}};
  std::vector<TaskRow> rows = ReadTaskRows(Write(smile::ToText(ToJson(evaluation), 2)));
  EXPECT_EQ(
      TableOf(rows, TableForm::kText),
      "task    brain   success              95 %   gain   error mm   right claims          causes\n"
      "tower   idle     0 of 1     0.0 to 79.3 %   0.00          –         0 of 1   1 x misplaced\n"
      "tower   a|b      1 of 1   20.7 to 100.0 %   1.00       0.50         1 of 1\n");
  evaluation.scene = "hatch.xml";
  evaluation.level = "fixtures";
  evaluation.impossible = {{3, "no room"}};
  for (const TaskRow& row : ReadTaskRows(Write(smile::ToText(ToJson(evaluation), 2)))) {
    rows.push_back(row);
  }
  EXPECT_EQ(
      TableOf({rows[3]}, TableForm::kMarkdown),
      "| task | level | brain | success | 95 % | gain | error mm | right claims | left out | "
      "causes |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n"
      "| hatch | fixtures | a\\|b | 1 of 1 | 20.7 to 100.0 % | 1.00 | 0.50 | 1 of 1 | 1 |  |\n");
}

TEST_F(TaskTable, NamesWhatIsWrongInAFile) {
  EXPECT_THROW(ReadTaskRows(Write("{")), InputError);
  EXPECT_THROW(ReadTaskRows(Write(R"({"format":2,"level":null,"scene":"a","brains":[{"name":"b",
"runs":[]}]})")),
               InputError);
  EXPECT_THROW(ReadTaskRows(Write(R"({"format":1})")), InputError);
}

}  // namespace
}  // namespace smile::report
