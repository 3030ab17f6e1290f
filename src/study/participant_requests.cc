#include "study/participant_requests.h"

#include <set>

namespace smile::study {
namespace {

/// Returns the `do` of a command; empty if there is none.
std::string CommandIn(const Json& fields) {
  if (!fields.is_object() || !fields.contains("command")) return "";
  const Json& command = fields["command"];
  if (!command.is_object() || !command.contains("do") || !command["do"].is_string()) return "";
  return command["do"].get<std::string>();
}

}  // namespace

std::optional<texts::UserMessage> RefuseToParticipant(const page::Request& request) {
  static const std::set<std::string> kRequests{"allowed", "command", "resting_place", "snap",
                                               "support"};
  static const std::set<std::string> kCommands{
      "",      "attend", "drag",    "fasten", "finish", "grasp",   "loosen", "move_to", "plane",
      "point", "redo",   "release", "rotate", "start",  "trigger", "undo",   "use"};
  if (!kRequests.contains(request.what)) return texts::Say("study.isNotPart");
  if (request.what == "command" && !kCommands.contains(CommandIn(request.fields)))
    return texts::Say("study.isNotPart");
  return std::nullopt;
}

}  // namespace smile::study
