#include "record/recording_history.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "base/overloaded.h"
#include "base/wording.h"
#include "record/imported_history.h"
#include "record/trace_reader.h"

namespace smile::record {
namespace {

/// What each hand holds; empty: nothing.
using Holds = std::array<std::string, demonstrator::kHandNames.size()>;

std::string& HeldBy(demonstrator::HandName hand, Holds* holds) {
  return (*holds)[static_cast<std::size_t>(hand)];
}

Holds After(const sim::Command& action, Holds holds) {
  std::visit(Overloaded{[&](const sim::Grasp& grasp) { HeldBy(grasp.hand, &holds) = grasp.object; },
                        [&](const sim::Release& release) { HeldBy(release.hand, &holds).clear(); },
                        [&](const sim::Destroy& destroy) { HeldBy(destroy.hand, &holds).clear(); },
                        [](const auto&) {}},
             action);
  return holds;
}

/// What an action of the log was told as.
/// @param holds  before it.
sim::Event EventOf(const sim::Command& action, Holds holds) {
  using enum sim::EventKind;
  return std::visit(
      Overloaded{[&](const sim::Grasp& what) {
                   return sim::Event{.kind = kGrasped, .hand = what.hand, .object = what.object};
                 },
                 [&](const sim::Release& what) {
                   return sim::Event{
                       .kind = kReleased, .hand = what.hand, .object = HeldBy(what.hand, &holds)};
                 },
                 [&](const sim::Destroy& what) {
                   return sim::Event{
                       .kind = kDestroyed, .hand = what.hand, .object = HeldBy(what.hand, &holds)};
                 },
                 [](const sim::Point& what) {
                   return sim::Event{.kind = kPointed, .hand = what.hand, .part = what.part};
                 },
                 [](const sim::Trigger& what) {
                   return sim::Event{
                       .kind = kTriggered, .hand = what.hand, .control = what.control};
                 },
                 [](const sim::Fasten& what) {
                   return sim::Event{.kind = kFastened, .hand = what.hand, .object = what.object};
                 },
                 [](const sim::Loosen& what) {
                   return sim::Event{.kind = kLoosened, .hand = what.hand, .object = what.object};
                 },
                 [](const auto&) { return sim::Event(); }},
      action);
}

/// What hands let go of in a recording, and upon what.
class Releases {
 public:
  Releases(const Recording& recording, std::vector<HistoryStep>* steps)
      : recording_(recording), steps_(*steps) {}

  void Add(std::size_t step, sim::Event event) { waiting_.emplace(step, std::move(event)); }
  /// Finds it out for all of them: one reading of the trace for each way through the history.
  void Name() {
    while (!waiting_.empty()) NameAlongWayTo(waiting_.rbegin()->first);
  }

 private:
  void NameAlongWayTo(std::size_t last) {
    std::multimap<std::uint64_t, std::size_t> at_tick;
    for (std::optional<std::size_t> step = last; step; step = steps_[*step].parent) {
      if (waiting_.contains(*step)) at_tick.emplace(steps_[*step].begin.tick, *step);
    }
    TraceReader trace(recording_, steps_[last].begin);
    while (const auto moment = trace.Next()) {
      const auto [first, end] = at_tick.equal_range(moment->tick);
      for (auto found = first; found != end; ++found) NameOne(found->second, *moment);
    }
    // A trace may end before its log.
    for (const auto& [tick, step] : at_tick) waiting_.erase(step);
  }

  void NameOne(std::size_t step, const TraceTick& moment) {
    const sim::Event& event = waiting_.at(step);
    const auto& objects = recording_.scene.objects;
    const auto object = std::ranges::find(objects, event.object, &scene::ObjectSpec::id);
    steps_[step].deed =
        DeedOf(event, SupportOf(recording_.scene, moment.objects,
                                static_cast<std::size_t>(object - objects.begin())));
  }

  const Recording& recording_;
  std::vector<HistoryStep>& steps_;
  std::map<std::size_t, sim::Event> waiting_;  ///< by step
};

std::uint64_t LastTick(const Recording& recording) {
  TraceReader trace(recording);
  std::uint64_t tick = recording.info.start.tick;
  while (const auto moment = trace.Next()) tick = moment->tick;
  return tick;
}

}  // namespace

std::vector<HistoryStep> HistoryOf(const Recording& recording) {
  if (recording.info.origin == Origin::kImported) return ImportedHistoryOf(recording);
  const CommandLog& log = recording.log;
  std::vector<HistoryStep> steps;
  steps.push_back({.begin = recording.info.start, .end = recording.info.start});
  // What hands hold after each step; at the start that is what the commands before it left.
  std::vector<Holds> holds(1);
  for (const LoggedCommand& logged : log.WayTo(recording.info.start.line)) {
    holds[0] = After(logged.command, std::move(holds[0]));
  }
  Releases releases(recording, &steps);
  std::vector<std::size_t> step_of_line(log.lines().size() + 1);
  for (std::size_t line = recording.info.start.line + 1; line <= log.lines().size(); ++line) {
    const LogLine& logged = log.lines()[line - 1];
    const std::size_t step = step_of_line[line - 1];
    const auto* command = std::get_if<sim::Command>(&logged.what);
    const bool goes_on = command != nullptr && !IsAction(*command);
    steps[step].end = {.line = goes_on ? line : line - 1, .tick = logged.tick};
    if (command == nullptr || goes_on) {
      step_of_line[line] = step_of_line[goes_on ? line - 1 : log.After(line).line];
      continue;
    }
    step_of_line[line] = steps.size();
    const sim::Event event = EventOf(*command, holds[step]);
    steps.push_back({.parent = step,
                     .begin = {.line = line - 1, .tick = logged.tick},
                     .end = {.line = line, .tick = logged.tick},
                     .deed = DeedOf(event, std::nullopt)});
    if (event.kind == sim::EventKind::kReleased) releases.Add(steps.size() - 1, event);
    holds.push_back(After(*command, holds[step]));
  }
  const std::size_t last = log.lines().size();
  steps[step_of_line[last]].end = {.line = last, .tick = LastTick(recording)};
  for (std::optional<std::size_t> step = step_of_line[last]; step; step = steps[*step].parent) {
    steps[*step].is_on_way = true;
    // Whatever else was tried from there since.
    if (const auto& parent = steps[*step].parent) steps[*parent].end = steps[*step].begin;
  }
  releases.Name();
  return steps;
}

std::string WordsOf(const HistoryStep& step) {
  return step.deed ? WordsOf(*step.deed) : "the start";
}

std::optional<Moment> MomentIn(const Recording& recording, const HistoryStep& step,
                               std::uint64_t ticks) {
  if (ticks > step.end.tick - step.begin.tick) return std::nullopt;
  const std::uint64_t tick = step.begin.tick + ticks;
  // The last line on the way to the step's end that was not yet behind that tick.
  std::size_t line = step.end.line;
  while (line > step.begin.line) {
    const LogLine& logged = recording.log.lines()[line - 1];
    const auto* back = std::get_if<Return>(&logged.what);
    if ((back != nullptr ? back->to.tick : logged.tick) <= tick) break;
    line = back != nullptr ? back->to.line : line - 1;
  }
  return Moment{.line = line, .tick = tick};
}

Moment MomentOf(const Recording& recording, const std::vector<HistoryStep>& steps, std::size_t step,
                const std::optional<double>& after) {
  if (step >= steps.size()) {
    throw std::invalid_argument(recording.directory.string() + " has no step " +
                                std::to_string(step) + ", expected 0 to " +
                                std::to_string(steps.size() - 1) + " (see: smile history)");
  }
  if (!after) return steps[step].end;
  const auto ticks = static_cast<std::uint64_t>(std::llround(*after * sim::kTicksPerSecond));
  if (const auto moment = MomentIn(recording, steps[step], ticks)) return *moment;
  throw std::invalid_argument(
      "step " + std::to_string(step) + " lasted " +
      NumberText(sim::SecondsOf(steps[step].end.tick - steps[step].begin.tick)) +
      " s, expected a moment that is no later");
}

}  // namespace smile::record
