// Converts the history of a recording into JSON for the page. `segments` are the steps that led to
// the final state; `steps` contain all branches, including those that were undone, with the index
// of the step that each one follows.

#include "library/timeline.h"

#include <vector>

#include "recording/conflicts.h"
#include "recording/recording_history.h"
#include "recording/time_range.h"

namespace smile::library {

Json TimelineOf(const recording::Recording& recording) {
  const std::vector<recording::Segment> history = recording::HistoryOf(recording);
  const auto seconds = [&](std::uint64_t tick) { return SecondsInto(recording, tick); };
  Json segments = Json::array(), steps = Json::array();
  double end = 0;
  for (const recording::Segment& segment : OnPath(history)) {
    end = seconds(segment.end.tick);
    segments.push_back({{"number", segments.size()},
                        {"deed", sim::ToJson(segment.summary)},
                        {"begin", seconds(segment.begin.tick)},
                        {"end", end}});
  }
  for (const recording::Segment& step : history) {
    steps.push_back({{"step", steps.size()},
                     {"parent", step.parent ? Json(*step.parent) : Json()},
                     {"deed", sim::ToJson(step.summary)},
                     {"begin", seconds(step.begin.tick)},
                     {"end", seconds(step.end.tick)},
                     {"on_way", step.is_on_path}});
  }
  return {{"segments", segments},
          {"steps", steps},
          {"seconds", end},
          {"conflicts", ToJson(recording::ReadConflicts(recording.directory))}};
}

}  // namespace smile::library
