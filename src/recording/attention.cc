#include "recording/attention.h"

#include "recording/trace_reader.h"

namespace smile::recording {

std::map<std::string, std::vector<std::string>> AttentionOf(const Recording& recording) {
  std::map<std::string, std::vector<std::string>> attention;
  const auto note = [&attention](const std::vector<sim::Event>& events) {
    for (const sim::Event& event : events) {
      if (event.kind != sim::EventKind::kAttended) continue;
      // The last event on an object counts; one without properties revokes the earlier ones.
      attention.erase(event.object);
      if (!event.properties.empty()) attention[event.object] = event.properties;
    }
  };
  TraceReader trace(recording);
  // Properties that were marked before the recording began still hold.
  note(trace.events_before_start());
  while (const auto moment = trace.Next()) note(moment->events);
  return attention;
}

}  // namespace smile::recording
