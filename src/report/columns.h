#pragma once

#include <string>
#include <vector>

namespace smile::report {

/// Returns rows of cells as text, each column as wide as its widest cell; the first columns are
/// left-aligned, the others right-aligned. A column without any text is left out.
/// @param rows  at least one, all of the same number of cells.
std::string InColumns(const std::vector<std::vector<std::string>>& rows,
                      std::size_t num_left_aligned = 1);

}  // namespace smile::report
