#include "recording/commanded_events.h"

#include <type_traits>
#include <utility>

// For traces of old versions, which have no events: derives from a command the event that it
// reports. Less is known than from the trace, for example not what an object was put on.

namespace smile::recording {

std::optional<sim::Event> CommandedEvents::Next(const sim::Command& command) {
  return std::visit(
      [this]<class Kind>(const Kind& action) -> std::optional<sim::Event> {
        constexpr std::optional<sim::EventKind> kEvent = sim::EventOfAction<Kind>();
        if constexpr (kEvent.has_value()) {
          sim::Event event{.kind = *kEvent};
          if constexpr (std::is_same_v<Kind, sim::Remove>) {
            event.objects = {action.object};
            return event;
          }
          if constexpr (std::is_same_v<Kind, sim::Displace>) event.objects = action.objects;
          if constexpr (requires { action.hand; }) event.hand = action.hand;
          // A release does not name its object: it is the one that the hand grasped last.
          if constexpr (std::is_same_v<Kind, sim::Release> || std::is_same_v<Kind, sim::Destroy>) {
            event.object = std::exchange(HeldBy(action.hand), "");
          }
          if constexpr (std::is_same_v<Kind, sim::Grasp>) HeldBy(action.hand) = action.object;
          if constexpr (requires { action.object; }) event.object = action.object;
          if constexpr (std::is_same_v<Kind, sim::Point>) event.part = action.part;
          if constexpr (std::is_same_v<Kind, sim::Trigger>) event.control = action.control;
          return event;
        }
        return std::nullopt;
      },
      command);
}

}  // namespace smile::recording
