#include "sim/event_words.h"

namespace smile::sim {
namespace {

/// Name in events of the parts of the robot that belong to no arm.
constexpr std::string_view kBody = "robot";

std::string WordsOfPress(const Event& event) {
  std::string words = event.control + " pressed";
  if (!event.by.empty()) return words + " by " + event.by;
  // Neither: the fixed body of the table.
  return event.arm.empty() ? words : words + " by " + GripperWords(event.arm);
}

std::string WordsOfUse(const Event& event) {
  // A hand that turns the tool is not known: the turn is no command.
  if (event.arm.empty()) return event.by + " " + event.state + "s " + event.part;
  return GripperWords(event.arm) + " " + event.state + "s " + event.part + " with " + event.by;
}

}  // namespace

std::string GripperWords(std::string_view arm) {
  return std::string(arm) + (arm == kBody ? "" : " gripper");
}

std::optional<std::string> WordsOf(const Event& event) {
  if (event.kind == EventKind::kPressed) return WordsOfPress(event);
  // By a command of a hand, it is an action.
  if (event.kind == EventKind::kUsed && !event.hand) return WordsOfUse(event);
  return std::nullopt;
}

}  // namespace smile::sim
