#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace smile::brain_client {

/// Returns the parts of a text between separators; at least one, which may be empty.
inline std::vector<std::string> SplitAt(char separator, std::string_view text) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// Returns the lines of a text.
inline std::vector<std::string> LinesOf(std::string_view text) { return SplitAt('\n', text); }

}  // namespace smile::brain_client
