#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace smile::robot {

/// What a robot's face shows; without a face, nothing.
enum class Mood { kIdle, kWatching, kWorking, kPuzzled, kDone };

inline constexpr std::array kMoods = {Mood::kIdle, Mood::kWatching, Mood::kWorking, Mood::kPuzzled,
                                      Mood::kDone};
/// In the order of kMoods.
inline constexpr std::array<std::string_view, 5> kMoodNames = {"idle", "watching", "working",
                                                               "puzzled", "done"};

std::string_view ToString(Mood mood);
/// nullopt for what is none of kMoodNames.
[[nodiscard]] std::optional<Mood> ParseMood(std::string_view name);

}  // namespace smile::robot
