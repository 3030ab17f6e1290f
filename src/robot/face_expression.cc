#include "robot/mood.h"

#include <algorithm>
#include <cstddef>

namespace smile::robot {

std::string_view ToString(Mood mood) { return kMoodNames[static_cast<std::size_t>(mood)]; }

std::optional<Mood> ParseMood(std::string_view name) {
  const auto found = std::find(kMoodNames.begin(), kMoodNames.end(), name);
  if (found == kMoodNames.end()) return std::nullopt;
  return kMoods[static_cast<std::size_t>(found - kMoodNames.begin())];
}

}  // namespace smile::robot
