#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace smile::layout {

/// Difficulty of a starting layout for the robot.
enum class LayoutLevel {
  kScattered,    ///< separate objects, with room for a finger all around
  kTouching,     ///< some equal blocks lie side by side, in contact
  kStacked,      ///< some equal blocks stand on others
  kEdges,        ///< every second object lies at the rim of the robot's reach and view
  kDistractors,  ///< three more blocks, of colors or sizes that the scene does not have
  kMixed,        ///< all of these
  kFixtures,     ///< kScattered, and the fixtures are displaced and turned
  kPiles         ///< kScattered, and piles of objects are placed anywhere, each as a whole
};

/// Words for the levels, in their order: `scattered`, `touching`, …
inline constexpr std::array<std::string_view, 8> kLayoutLevelWords{
    "scattered", "touching", "stacked", "edges", "distractors", "mixed", "fixtures", "piles"};

/// Returns the level of a word, or nullopt.
std::optional<LayoutLevel> ParseLayoutLevel(std::string_view word);

}  // namespace smile::layout
