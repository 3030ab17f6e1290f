#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace smile::layout {

/// How hard a starting layout makes it for the robot.
enum class LayoutLevel {
  kScattered,    ///< each thing by itself, with room for a finger all around
  kTouching,     ///< some equal blocks lie side by side, in contact
  kStacked,      ///< some equal blocks stand upon others
  kEdges,        ///< every second thing lies at the rim of what the robot reaches and sees
  kDistractors,  ///< three blocks more, of colors or sizes that the scene does not have
  kMixed         ///< all of these
};

/// The words for the levels, in their order: `scattered`, `touching`, …
inline constexpr std::array<std::string_view, 6> kLayoutLevelWords{
    "scattered", "touching", "stacked", "edges", "distractors", "mixed"};

/// nullopt for a word that is none of them.
std::optional<LayoutLevel> ParseLayoutLevel(std::string_view word);

}  // namespace smile::layout
