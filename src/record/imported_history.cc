#include "record/imported_history.h"

#include <algorithm>

#include "record/trace_reader.h"

namespace smile::record {
namespace {

std::optional<Support> SupportIn(const Recording& recording, const TraceTick& moment,
                                 const std::string& id) {
  const auto& objects = recording.scene.objects;
  const auto object = std::ranges::find(objects, id, &scene::ObjectSpec::id);
  if (object == objects.end()) return std::nullopt;
  return SupportOf(recording.scene, moment.objects,
                   static_cast<std::size_t>(object - objects.begin()));
}

}  // namespace

std::vector<HistoryStep> ImportedHistoryOf(const Recording& recording) {
  std::vector<HistoryStep> steps{
      {.begin = recording.info.start, .end = recording.info.start, .is_on_way = true}};
  TraceReader trace(recording);
  while (const auto moment = trace.Next()) {
    const Moment now{.line = recording.info.start.line, .tick = moment->tick};
    steps.back().end = now;
    for (const sim::Event& event : moment->events) {
      if (!BeginsSegment(event)) continue;
      steps.push_back({.parent = steps.size() - 1,
                       .begin = now,
                       .end = now,
                       .deed = DeedOf(event, SupportIn(recording, *moment, event.object)),
                       .is_on_way = true});
    }
  }
  return steps;
}

}  // namespace smile::record
