#include "record/recording_history.h"

#include <array>
#include <utility>

#include "base/overloaded.h"
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

/// @param holds  before the action.
std::string WordsOf(const sim::Command& action, Holds holds) {
  const auto hand = [](demonstrator::HandName name) {
    return std::string(ToString(name)) +
           (name == demonstrator::HandName::kBoth ? " hands " : " hand ");
  };
  // `takes` or, of both hands, `take`.
  const auto does = [&](demonstrator::HandName name, const std::string& verb) {
    return hand(name) + verb + (name == demonstrator::HandName::kBoth ? " " : "s ");
  };
  return std::visit(
      Overloaded{
          [&](const sim::Grasp& what) { return does(what.hand, "take") + what.object; },
          [&](const sim::Release& what) {
            return does(what.hand, "release") + HeldBy(what.hand, &holds);
          },
          [&](const sim::Destroy& what) {
            return does(what.hand, "destroy") + HeldBy(what.hand, &holds);
          },
          [&](const sim::Point& what) { return does(what.hand, "point") + "at " + what.part; },
          [&](const sim::Trigger& what) { return does(what.hand, "trigger") + what.control; },
          [&](const sim::Fasten& what) { return does(what.hand, "fasten") + what.object; },
          [&](const sim::Loosen& what) { return does(what.hand, "loosen") + what.object; },
          [](const auto&) { return std::string(); }},
      action);
}

std::uint64_t LastTick(const Recording& recording) {
  TraceReader trace(recording);
  std::uint64_t tick = recording.info.start.tick;
  while (const auto moment = trace.Next()) tick = moment->tick;
  return tick;
}

}  // namespace

std::vector<HistoryStep> HistoryOf(const Recording& recording) {
  const CommandLog& log = recording.log;
  std::vector<HistoryStep> steps;
  steps.push_back(
      {.begin = recording.info.start, .end = recording.info.start, .words = "the start"});
  // What hands hold after each step; at the start that is what the commands before it left.
  std::vector<Holds> holds(1);
  for (const LoggedCommand& logged : log.WayTo(recording.info.start.line)) {
    holds[0] = After(logged.command, std::move(holds[0]));
  }
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
    steps.push_back({.parent = step,
                     .begin = {.line = line - 1, .tick = logged.tick},
                     .end = {.line = line, .tick = logged.tick},
                     .words = WordsOf(*command, holds[step])});
    holds.push_back(After(*command, holds[step]));
  }
  const std::size_t last = log.lines().size();
  steps[step_of_line[last]].end = {.line = last, .tick = LastTick(recording)};
  for (std::optional<std::size_t> step = step_of_line[last]; step; step = steps[*step].parent) {
    steps[*step].is_on_way = true;
  }
  return steps;
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

}  // namespace smile::record
