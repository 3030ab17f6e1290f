#pragma once

#include <string>

#include "base/json_node.h"

namespace smile::robot::internal {

/// Of texts that are put into many others [bytes].
inline constexpr std::size_t kMaxShortText = 64;

/// One of the grippers a side file offers, its choices made.
struct GripperChoice {
  std::string name;   ///< with a word for each choice: `electric-extended-wide-2-paddle`
  std::string place;  ///< in the file
  Json value;         ///< of the gripper, `{slot}` and the like replaced
};

/// @param grippers  the side file's member of that name.
/// @param wanted    the gripper's name and some words of its choices, `-` between them; what is not
///                  said is the first word of each choice.
/// @throws InputError naming the grippers or words there are.
GripperChoice ChooseGripper(const JsonNode& grippers, const std::string& wanted);

}  // namespace smile::robot::internal
