#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/evaluation.h"

namespace smile::report {

/// Results of one brain at one task: a row of a table of several evaluations.
struct TaskRow {
  std::string task;   ///< name of the scene without `_robot`
  std::string level;  ///< of the layouts; empty: the usual one
  std::string brain;  ///< its name in the evaluation
  Summary summary;
  std::size_t num_impossible = 0;  ///< layouts that were left out
};

/// Reads an `evaluation.json`.
/// @param path  that file or its folder.
/// @throws InputError if it is missing or inconsistent.
std::vector<TaskRow> ReadTaskRows(const std::filesystem::path& path);

enum class TableForm { kText, kMarkdown };
/// Returns a table of tasks and brains: success with Wilson's interval, mean gain, mean error,
/// right claims and causes of failures. As text for a terminal, or for a Markdown document.
std::string TableOf(const std::vector<TaskRow>& rows, TableForm form);

}  // namespace smile::report
