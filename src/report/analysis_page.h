#pragma once

#include <string>
#include <string_view>

#include "analysis/analysis.h"

namespace smile::report {

/// Returns `report.html` of an analysis: a graph of the order of the subtasks, and tables that give
/// the reasons, as one self-contained page.
/// @param name  of the demonstration.
std::string PageOf(const analysis::Analysis& analysis, std::string_view name);

/// Returns the graph alone, as SVG with the classes `subtask`, `redundant` and `edge`.
std::string GraphOf(const analysis::Analysis& analysis);

}  // namespace smile::report
