#include "record/imported_history.h"

#include "record/trace_reader.h"

namespace smile::record {

std::vector<HistoryStep> ImportedHistoryOf(const Recording& recording) {
  std::vector<HistoryStep> steps{
      {.begin = recording.info.start, .end = recording.info.start, .is_on_way = true}};
  TraceReader trace(recording);
  while (const auto moment = trace.Next()) {
    const Moment now{.line = recording.info.start.line, .tick = moment->tick};
    steps.back().end = now;
    for (const sim::Event& event : moment->events) {
      if (!BeginsAction(event)) continue;
      steps.push_back(
          {.parent = steps.size() - 1,
           .begin = now,
           .end = now,
           .summary = SummaryOf(event, SupportAt(*moment, event.object, recording.scene)),
           .is_on_way = true});
    }
  }
  return steps;
}

}  // namespace smile::record
