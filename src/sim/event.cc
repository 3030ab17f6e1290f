#include "sim/event.h"

namespace smile::sim {

std::string_view ToString(EventKind kind) {
  switch (kind) {
    case EventKind::kGrasped:
      return "grasped";
    case EventKind::kReleased:
      return "released";
    case EventKind::kGripperHolds:
      return "gripper_holds";
    case EventKind::kGripperLetGo:
      return "gripper_let_go";
    case EventKind::kCommandRefused:
      return "command_refused";
  }
  return "";
}

}  // namespace smile::sim
