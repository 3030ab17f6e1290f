#pragma once

#include <string>

#include "base/json_node.h"

namespace smile::robot::internal {

/// Maximum length of texts that are inserted into many others [bytes].
inline constexpr std::size_t kMaxShortText = 64;

/// A gripper of a side file after all its choices are made.
struct GripperChoice {
  std::string name;   ///< with one word per choice: `electric-extended-wide-2-paddle`
  std::string place;  ///< path in the file, for messages
  Json value;         ///< of the gripper, with `{slot}` and other placeholders replaced
};

/// Selects a gripper and its choices.
/// @param grippers  the side file's member of that name.
/// @param wanted    the gripper's name and some words of its choices, separated by `-`; choices not
///                  mentioned take their first word.
/// @throws InputError with the available grippers or words.
GripperChoice ChooseGripper(const JsonNode& grippers, const std::string& wanted);

}  // namespace smile::robot::internal
