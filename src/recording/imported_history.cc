#include "recording/imported_history.h"

#include <utility>

#include "recording/trace_reader.h"

namespace smile::recording {

std::vector<Segment> ImportedHistoryOf(const Recording& recording) {
  // A classic recording has no branches, so each step follows the one before. All points have the
  // same line: there is no log.
  std::vector<Segment> steps{
      {.begin = recording.info.start, .end = recording.info.start, .is_on_path = true}};
  // Actions whose summary is computed again at the next moment: the classic format writes an action
  // with the frame after it, and only there an object lies where it was put.
  std::vector<std::pair<std::size_t, sim::Event>> of_next_moment;
  TraceReader trace(recording);
  while (const auto moment = trace.Next()) {
    const HistoryPoint now{.line = recording.info.start.line, .tick = moment->tick};
    const auto summary_of = [&](const sim::Event& event) {
      return SummaryOf(event, SupportAt(*moment, event.object, recording.scene()));
    };
    // Replaces the preliminary summaries; the last action keeps its own if no moment follows.
    for (const auto& [step, event] : of_next_moment) steps[step].summary = summary_of(event);
    of_next_moment.clear();
    steps.back().end = now;
    for (const sim::Event& event : moment->events) {
      if (!BeginsAction(event)) continue;
      of_next_moment.emplace_back(steps.size(), event);
      steps.push_back({.parent = steps.size() - 1,
                       .begin = now,
                       .end = now,
                       .summary = summary_of(event),
                       .is_on_path = true});
    }
  }
  return steps;
}

}  // namespace smile::recording
