#include "recording/recording_history.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "base/wording.h"
#include "recording/commanded_events.h"
#include "recording/imported_history.h"
#include "recording/trace_reader.h"
#include "sim/event_words.h"

namespace smile::recording {
namespace {

/// Adds to each step a summary of its action: from the event in the trace or, where the trace has
/// none, from the command in the log.
class Summaries {
 public:
  Summaries(const Recording& recording, std::vector<Segment>* steps)
      : recording_(recording), steps_(*steps) {}

  /// Reads the trace once for each path through the history.
  void AddToSteps() {
    // Backwards: the last step of a branch is reached first, and reading the path to it fills the
    // summaries of its ancestors too.
    for (std::size_t step = steps_.size() - 1; step > 0; --step) {
      if (!steps_[step].summary) AddAlongPathTo(step);
    }
  }

 private:
  void AddAlongPathTo(std::size_t last) {
    const std::vector<std::size_t> path = PathTo(last);
    // The action itself is the line after the point at which it began.
    const HistoryPoint until{.line = steps_[last].begin.line + 1, .tick = steps_[last].begin.tick};
    const std::vector<sim::Event> commanded = CommandedOnPathTo(until.line);
    TraceReader trace(recording_, until);
    scene_ = SceneAfter(recording_, until.line);
    std::size_t next = 0;
    // Events and steps of a path are in the same order, so they are paired one by one.
    for (const TracedEvent& traced : trace.Events()) {
      if (BeginsAction(traced.event) && next < path.size()) {
        Add(path[next++], traced.event, traced.tick, &trace);
      }
    }
    // A trace of an old version has no events: commands are placed by their ticks.
    const std::uint64_t last_tick = trace.LastTick().value_or(0);
    while (!trace.has_events() && next < path.size() &&
           steps_[path[next]].begin.tick <= last_tick) {
      Add(path[next], commanded[next], steps_[path[next]].begin.tick, &trace);
      ++next;
    }
    // The log is written before the trace, so the trace may end first.
    for (; next < path.size(); ++next) Add(path[next], commanded[next], 0, nullptr);
  }

  /// Returns the steps from the first action to `last`, in order.
  std::vector<std::size_t> PathTo(std::size_t last) const {
    std::vector<std::size_t> path;
    // Every step but the first has a parent with a smaller number.
    for (std::size_t step = last; step > 0; step = *steps_[step].parent) path.push_back(step);
    std::reverse(path.begin(), path.end());
    return path;
  }

  /// Returns one event for each action since the start, derived from the commands.
  std::vector<sim::Event> CommandedOnPathTo(std::size_t line) const {
    CommandedEvents commanded;
    std::vector<sim::Event> events;
    for (const LoggedCommand& logged : recording_.log.PathTo(line)) {
      auto event = commanded.Next(logged.command);
      if (event && logged.line > recording_.info.start.line) events.push_back(*std::move(event));
    }
    return events;
  }

  /// @param trace  has the moment at `tick`, at which the action was carried out; nullptr if it
  ///               lacks it.
  void Add(std::size_t step, const sim::Event& event, std::uint64_t tick, TraceReader* trace) {
    if (steps_[step].summary) return;
    std::optional<model::Support> support;
    // What an object was put on is known only from the poses at that moment.
    if (event.kind == sim::EventKind::kReleased && trace != nullptr) {
      if (const auto moment = trace->At(tick)) support = SupportAt(*moment, event.object, scene_);
    }
    steps_[step].summary = SummaryOf(event, support);
  }

  const Recording& recording_;
  scene::SceneSpec scene_;  ///< on the path that is being read
  std::vector<Segment>& steps_;
};

}  // namespace

/// One pass over the log. step_of_line[l] is the step that contains the point after line l; a
/// return continues the step of its target, and an action opens a new step.
std::vector<Segment> CutAtActions(const Recording& recording, std::uint64_t last_tick) {
  const CommandLog& log = recording.log;
  std::vector<Segment> steps;
  steps.push_back({.begin = recording.info.start, .end = recording.info.start});
  std::vector<std::size_t> step_of_line(log.lines().size() + 1);
  for (std::size_t line = recording.info.start.line + 1; line <= log.lines().size(); ++line) {
    const LogLine& logged = log.lines()[line - 1];
    const std::size_t step = step_of_line[line - 1];
    const auto* command = std::get_if<sim::Command>(&logged.what);
    // Each line extends the current step to its tick; only a command that is no action becomes part
    // of it.
    const bool extends_step = command != nullptr && !IsAction(*command);
    steps[step].end = {.line = extends_step ? line : line - 1, .tick = logged.tick};
    if (command == nullptr || extends_step) {
      step_of_line[line] = step_of_line[extends_step ? line - 1 : log.After(line).line];
      continue;
    }
    step_of_line[line] = steps.size();
    steps.push_back({.parent = step,
                     .begin = {.line = line - 1, .tick = logged.tick},
                     .end = {.line = line, .tick = logged.tick},
                     .summary = {}});
  }
  const std::size_t last = log.lines().size();
  steps[step_of_line[last]].end = {.line = last, .tick = last_tick};
  for (std::optional<std::size_t> step = step_of_line[last]; step; step = steps[*step].parent) {
    steps[*step].is_on_path = true;
    // The end of a step on the path is where the path leaves it, whatever branches were tried from
    // there later.
    if (const auto& parent = steps[*step].parent) steps[*parent].end = steps[*step].begin;
  }
  return steps;
}

std::vector<Segment> HistoryOf(const Recording& recording) {
  if (recording.info.origin == Origin::kImported) return ImportedHistoryOf(recording);
  std::vector<Segment> steps = CutAtActions(
      recording, TraceReader(recording).LastTick().value_or(recording.info.start.tick));
  Summaries(recording, &steps).AddToSteps();
  return steps;
}

std::vector<SegmentEffect> EffectsOf(const Recording& recording,
                                     const std::vector<Segment>& history) {
  std::vector<SegmentEffect> effects;
  for (const TracedEvent& traced : TraceReader(recording).Events()) {
    const std::optional<std::string> words = sim::WordsOf(traced.event);
    if (!words) continue;
    SegmentEffect effect{.tick = traced.tick, .words = *words};
    // An action is carried out after the events of its tick, so these belong to the step before.
    for (std::size_t step = 1; step < history.size(); ++step) {
      if (history[step].is_on_path && history[step].begin.tick < traced.tick) effect.step = step;
    }
    effects.push_back(std::move(effect));
  }
  return effects;
}

std::vector<Segment> OnPath(const std::vector<Segment>& history) {
  std::vector<Segment> on_path;
  std::ranges::copy_if(history, std::back_inserter(on_path), &Segment::is_on_path);
  return on_path;
}

std::string WordsOf(const Segment& step) {
  return step.summary ? WordsOf(*step.summary) : "the start";
}

std::optional<HistoryPoint> HistoryPointIn(const Recording& recording, const Segment& step,
                                           std::uint64_t ticks) {
  if (ticks > step.end.tick - step.begin.tick) return std::nullopt;
  const std::uint64_t tick = step.begin.tick + ticks;
  // Walks back along the path from the step's end to the last line that is not later than the tick.
  std::size_t line = step.end.line;
  while (line > step.begin.line) {
    const LogLine& logged = recording.log.lines()[line - 1];
    const auto* back = std::get_if<Return>(&logged.what);
    if ((back != nullptr ? back->to.tick : logged.tick) <= tick) break;
    line = back != nullptr ? back->to.line : line - 1;
  }
  return HistoryPoint{.line = line, .tick = tick};
}

HistoryPoint HistoryPointBefore(const Recording& recording, std::uint64_t tick) {
  HistoryPoint point{.line = recording.info.start.line, .tick = tick};
  for (const LoggedCommand& logged : recording.commands) {
    if (logged.tick < tick) point.line = std::max(point.line, logged.line);
  }
  return point;
}

HistoryPoint HistoryPointOf(const Recording& recording, const std::vector<Segment>& steps,
                            std::size_t step, const std::optional<double>& after) {
  if (step >= steps.size()) {
    throw std::invalid_argument(recording.directory.string() + " has no step " +
                                std::to_string(step) + ", expected 0 to " +
                                std::to_string(steps.size() - 1) + " (see: smile history)");
  }
  if (!after) return steps[step].end;
  const auto ticks = static_cast<std::uint64_t>(std::llround(*after * sim::kTicksPerSecond));
  if (const auto point = HistoryPointIn(recording, steps[step], ticks)) return *point;
  throw std::invalid_argument(
      "step " + std::to_string(step) + " lasted " +
      NumberText(sim::SecondsOf(steps[step].end.tick - steps[step].begin.tick)) +
      " s, expected a time within it");
}

}  // namespace smile::recording
