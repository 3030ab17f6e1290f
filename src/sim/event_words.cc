#include "sim/event_words.h"

namespace smile::sim {

using texts::Say;
namespace {

/// Name in events of the parts of the robot that belong to no arm.
constexpr std::string_view kBody = "robot";

texts::UserMessage WordsOfPress(const Event& event) {
  if (!event.by.empty()) {
    return Say("events.pressedBy", {{"control", event.control}, {"by", event.by}});
  }
  // Neither: the fixed body of the table.
  if (event.arm.empty()) return Say("events.pressed", {{"control", event.control}});
  return Say("events.pressedBy", {{"control", event.control}, {"by", GripperWords(event.arm)}});
}

texts::UserMessage WordsOfUse(const Event& event) {
  // A hand that turns the tool is not known: the turn is no command.
  if (event.arm.empty()) {
    return Say("events.used", {{"tool", event.by}, {"verb", event.state}, {"part", event.part}});
  }
  return Say("events.usedByGripper", {{"gripper", GripperWords(event.arm)},
                                      {"verb", event.state},
                                      {"part", event.part},
                                      {"tool", event.by}});
}

}  // namespace

texts::UserMessage GripperWords(std::string_view arm) {
  if (arm == kBody) return Say("events.robot");
  return Say("events.gripper", {{"arm", arm}});
}

std::optional<texts::UserMessage> WordsOf(const Event& event) {
  if (event.kind == EventKind::kPressed) return WordsOfPress(event);
  // By a command of a hand, it is an action.
  if (event.kind == EventKind::kUsed && !event.hand) return WordsOfUse(event);
  return std::nullopt;
}

}  // namespace smile::sim
