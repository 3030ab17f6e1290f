#include "report/columns.h"

#include <algorithm>

namespace smile::report {
namespace {

/// Returns the width of a text on a terminal: the number of bytes that begin a UTF-8 letter.
/// Sufficient for names and our own texts.
std::size_t WidthOf(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

}  // namespace

std::string InColumns(const std::vector<std::vector<std::string>>& rows,
                      std::size_t num_left_aligned) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], WidthOf(row[k]));
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (widths[k] == 0) continue;
      const std::string blanks(widths[k] - WidthOf(row[k]), ' ');
      // Names are left-aligned, numbers right-aligned.
      line +=
          (line.empty() ? "" : "   ") + (k < num_left_aligned ? row[k] + blanks : blanks + row[k]);
    }
    // Nothing is left after the last cell.
    line.resize(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace smile::report
