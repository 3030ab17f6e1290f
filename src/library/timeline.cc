#include "library/timeline.h"

#include <algorithm>
#include <iterator>

#include "record/time_range.h"

namespace smile::library {
std::vector<record::HistoryStep> SegmentsOf(const std::vector<record::HistoryStep>& history) {
  std::vector<record::HistoryStep> on_way;
  std::ranges::copy_if(history, std::back_inserter(on_way), &record::HistoryStep::is_on_way);
  return on_way;
}

Json TimelineOf(const record::Recording& recording) {
  const std::vector<record::HistoryStep> history = record::HistoryOf(recording);
  const auto seconds = [&](std::uint64_t tick) { return SecondsInto(recording, tick); };
  Json segments = Json::array(), steps = Json::array();
  double end = 0;
  for (const record::HistoryStep& segment : SegmentsOf(history)) {
    end = seconds(segment.end.tick);
    segments.push_back({{"number", segments.size()},
                        {"deed", sim::ToJson(segment.summary)},
                        {"begin", seconds(segment.begin.tick)},
                        {"end", end}});
  }
  for (const record::HistoryStep& step : history) {
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
