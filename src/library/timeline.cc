#include "library/timeline.h"

#include <algorithm>
#include <iterator>

#include "recording/time_range.h"

namespace smile::library {
std::vector<recording::HistoryStep> SegmentsOf(const std::vector<recording::HistoryStep>& history) {
  std::vector<recording::HistoryStep> on_way;
  std::ranges::copy_if(history, std::back_inserter(on_way), &recording::HistoryStep::is_on_way);
  return on_way;
}

Json TimelineOf(const recording::Recording& recording) {
  const std::vector<recording::HistoryStep> history = recording::HistoryOf(recording);
  const auto seconds = [&](std::uint64_t tick) { return SecondsInto(recording, tick); };
  Json segments = Json::array(), steps = Json::array();
  double end = 0;
  for (const recording::HistoryStep& segment : SegmentsOf(history)) {
    end = seconds(segment.end.tick);
    segments.push_back({{"number", segments.size()},
                        {"deed", sim::ToJson(segment.summary)},
                        {"begin", seconds(segment.begin.tick)},
                        {"end", end}});
  }
  for (const recording::HistoryStep& step : history) {
    steps.push_back({{"step", steps.size()},
                     {"parent", step.parent ? Json(*step.parent) : Json()},
                     {"deed", sim::ToJson(step.summary)},
                     {"begin", seconds(step.begin.tick)},
                     {"end", seconds(step.end.tick)},
                     {"on_way", step.is_on_way}});
  }
  return {{"segments", segments}, {"steps", steps}, {"seconds", end}};
}

}  // namespace smile::library
