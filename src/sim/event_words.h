#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/event.h"
#include "texts/user_message.h"

namespace smile::sim {

/// Returns the name of what an arm does for people: `left gripper`; `robot` for a part of the robot
/// that belongs to no arm.
texts::UserMessage GripperWords(std::string_view arm);

/// Returns a phrase for what contact or a tool did without a command: `Power pressed by left
/// gripper`, `Dial pressed by Ball`, `left gripper cuts String between link 4 and 5 with Scissors`;
/// `Driver fastens Screw` if a hand turned the tool. nullopt for other events: the summary of an
/// action reports it, see SummaryOf(), or it follows from an earlier one.
std::optional<texts::UserMessage> WordsOf(const Event& event);

}  // namespace smile::sim
