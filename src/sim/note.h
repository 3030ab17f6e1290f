#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "math/rigid_transform.h"

namespace smile::sim {

/// First words of notes: what they are about.
inline constexpr std::array<std::string_view, 7> kNoteWords{
    "understood", "plan", "saw", "action", "as expected", "hidden", "contradicted"};

/// Level top of an object, as a robot's program knows it: a rectangle, or an ellipse.
struct NotedTop {
  Vector3 middle = Vector3::Zero();  ///< in the world [units]
  double length = 0, width = 0;      ///< of its sides, or its diameters [units]
  double yaw = 0;                    ///< direction of its length, about the vertical [rad]
  bool is_round = false;

  bool operator==(const NotedTop&) const = default;
};

/// Note of a robot's program about its work, for people.
struct Note {
  std::string word;  ///< one of kNoteWords
  std::string text;
  std::vector<NotedTop> expected, found;  ///< what it expected to see, and what it saw instead
  std::string camera;                     ///< in whose picture it saw that; empty: the robot's eye

  bool operator==(const Note&) const = default;
};

}  // namespace smile::sim
