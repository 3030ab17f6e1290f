#include "layout/layout_level.h"

#include <algorithm>

namespace smile::layout {

std::optional<LayoutLevel> ParseLayoutLevel(std::string_view word) {
  const auto* const found = std::ranges::find(kLayoutLevelWords, word);
  if (found == kLayoutLevelWords.end()) return std::nullopt;
  return static_cast<LayoutLevel>(found - kLayoutLevelWords.begin());
}

}  // namespace smile::layout
