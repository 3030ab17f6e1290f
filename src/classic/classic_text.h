#pragma once

#include <array>
#include <string>
#include <string_view>

#include "sim/event.h"

namespace smile::classic {

/// Returns a number in the form of the classic text logs: the shortest text that reads back to the
/// same single-precision value, always with a decimal point, with `E` below 1e-3 and from 1e7 on
/// (`2.0`, `-0.0`, `3.4144908E-4`, `1.0E7`).
std::string ClassicNumber(double number);

/// Returns a description value with its commas escaped as `\,`.
std::string ClassicValue(std::string_view text);

/// Returns `LeftHand`, `RightHand`, `BothHands` or `AnyHand`.
std::string_view ClassicHandName(demonstrator::HandName hand);

/// Word of the classic format for an action of a hand.
struct ClassicWord {
  std::string_view word;
  sim::EventKind kind;
};
inline constexpr std::array<ClassicWord, 9> kClassicWords{{{"grasp", sim::EventKind::kGrasped},
                                                           {"release", sim::EventKind::kReleased},
                                                           {"destroy", sim::EventKind::kDestroyed},
                                                           {"trigger", sim::EventKind::kTriggered},
                                                           {"pointTo", sim::EventKind::kPointed},
                                                           {"fasten", sim::EventKind::kFastened},
                                                           {"loosen", sim::EventKind::kLoosened},
                                                           {"attend", sim::EventKind::kAttended},
                                                           {"use", sim::EventKind::kUsed}}};
/// Word of the classic format for a press by contact.
inline constexpr std::string_view kPressWord = "press";
/// What follows the name of an arm that pressed a control or used a tool.
inline constexpr std::string_view kGripperSuffix = "_gripper";
/// Name of a hand that turned a tool without a command to use it.
inline constexpr std::string_view kTurningHand = "hand";
/// Returns the word for an event; empty if the format has none.
std::string_view ClassicWordFor(sim::EventKind kind);

}  // namespace smile::classic
