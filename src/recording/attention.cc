#include "recording/attention.h"

#include "recording/trace_reader.h"

namespace smile::recording {

std::map<std::string, std::vector<std::string>> AttentionOf(const Recording& recording) {
  std::map<std::string, std::vector<std::string>> attention;
  const auto note = [&attention](const sim::Event& event) {
    if (event.kind != sim::EventKind::kAttended) return;
    // The last event on an object counts; one without properties revokes the earlier ones.
    attention.erase(event.object);
    if (!event.properties.empty()) attention[event.object] = event.properties;
  };
  TraceReader trace(recording);
  // Properties that were marked before the recording began still hold.
  for (const sim::Event& event : trace.events_before_start()) note(event);
  for (const TracedEvent& traced : trace.Events()) note(traced.event);
  return attention;
}

}  // namespace smile::recording
