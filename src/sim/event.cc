#include "sim/event.h"

namespace smile::sim {

std::string_view ToString(EventKind kind) {
  // Words of messages to pages and programs, which compare them.
  switch (kind) {
    case EventKind::kGrasped:
      return "grasped";
    case EventKind::kReleased:
      return "released";
    case EventKind::kDestroyed:
      return "destroyed";
    case EventKind::kPointed:
      return "pointed";
    case EventKind::kTriggered:
      return "triggered";
    case EventKind::kControlChanged:
      return "control_changed";
    case EventKind::kFastened:
      return "fastened";
    case EventKind::kLoosened:
      return "loosened";
    case EventKind::kAttended:
      return "attended";
    case EventKind::kFell:
      return "fell";
    case EventKind::kGripperHolds:
      return "gripper_holds";
    case EventKind::kGripperReleased:
      return "gripper_let_go";
    case EventKind::kCommandRefused:
      return "command_refused";
    case EventKind::kAdded:
      return "added";
    case EventKind::kRemoved:
      return "removed";
    case EventKind::kCleared:
      return "cleared";
    case EventKind::kLoaded:
      return "loaded";
    case EventKind::kPressed:
      return "pressed";
    case EventKind::kUsed:
      return "used";
    case EventKind::kDisplaced:
      return "displaced";
  }
  return "";
}

}  // namespace smile::sim
