#include "studio/timeline.h"

#include "record/time_range.h"
#include "record/trace_reader.h"

namespace smile::studio {
namespace {

/// Each step on the way is a segment.
std::vector<SegmentSpan> SpansOnWay(const std::vector<record::HistoryStep>& history) {
  std::vector<SegmentSpan> spans;
  for (const record::HistoryStep& step : history) {
    if (!step.is_on_way) continue;
    if (!spans.empty()) spans.back().end = step.begin.tick;
    spans.push_back({.deed = step.deed, .begin = step.begin.tick, .end = step.end.tick});
  }
  return spans;
}

/// Of a recording without commands: what was seen to be done.
std::vector<SegmentSpan> SpansOfTrace(const record::Recording& recording) {
  record::TraceReader trace(recording);
  std::vector<SegmentSpan> spans;
  while (const auto moment = trace.Next()) {
    if (spans.empty()) spans.push_back({.begin = moment->tick});
    spans.back().end = moment->tick;
    for (const sim::Event& event : moment->events) {
      if (!record::BeginsSegment(event)) continue;
      spans.push_back({.deed = record::DeedOf(event, std::nullopt),
                       .begin = moment->tick,
                       .end = moment->tick});
    }
  }
  return spans;
}

}  // namespace

std::vector<SegmentSpan> SegmentsOf(const record::Recording& recording,
                                    const std::vector<record::HistoryStep>& history) {
  const bool was_seen_only = recording.info.origin == record::Origin::kImported;
  return was_seen_only ? SpansOfTrace(recording) : SpansOnWay(history);
}

Json TimelineOf(const record::Recording& recording) {
  const std::vector<record::HistoryStep> history = record::HistoryOf(recording);
  const std::vector<SegmentSpan> spans = SegmentsOf(recording, history);
  const auto seconds = [&](std::uint64_t tick) { return SecondsInto(recording, tick); };
  Json segments = Json::array(), steps = Json::array();
  for (const SegmentSpan& span : spans) {
    segments.push_back({{"number", segments.size()},
                        {"deed", record::ToJson(span.deed)},
                        {"begin", seconds(span.begin)},
                        {"end", seconds(span.end)}});
  }
  for (const record::HistoryStep& step : history) {
    steps.push_back({{"step", steps.size()},
                     {"parent", step.parent ? Json(*step.parent) : Json()},
                     {"deed", record::ToJson(step.deed)},
                     {"begin", seconds(step.begin.tick)},
                     {"end", seconds(step.end.tick)},
                     {"on_way", step.is_on_way}});
  }
  return {{"segments", segments},
          {"steps", steps},
          {"seconds", spans.empty() ? 0.0 : seconds(spans.back().end)}};
}

}  // namespace smile::studio
