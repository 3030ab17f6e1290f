#include "replay/replay.h"

#include <algorithm>

#include "base/diagnostic.h"
#include "recording/trace_reader.h"
#include "replay/event_collector.h"
#include "replay/internal_comparison.h"
#include "replay/log_player.h"

// Replays a recording and compares it tick by tick with its trace. The simulation begins with the
// scene at its start, runs the commands before the recording without comparison, and then keeps
// step with the trace.

namespace smile::replay {
namespace {

/// A running replay.
class ReplayRun {
 public:
  ReplayRun(const recording::Recording& recording, const ReplayOptions& options)
      : options_(options),
        range_(recording::TicksOf(options.range, recording)),
        trace_(recording),
        start_tick_(recording.info.start.tick),
        model_(*recording.model),
        simulation_(recording.start_model),
        player_(recording.commands, recording.info.start),
        meter_(model_) {
    report_.compared = {.first = range_.first, .last = range_.first};
    simulation_.AddListener(&collector_);
  }

  ReplayReport Go(const std::function<bool(std::uint64_t tick)>& on_tick) {
    // After each refusal the replay continues, so that all refused commands are listed.
    while (const auto failure = player_.RunToStart(&simulation_, on_tick)) Note(*failure);
    if (simulation_.tick() < start_tick_) return std::move(report_);  // stopped
    // Events before the recording are not in its trace.
    collector_.Clear();
    while (!is_over() && Step() && !is_over() && on_tick(simulation_.tick())) {
    }
    report_.deviations = meter_.Deviations();
    return std::move(report_);
  }
  const recording::TickRange& range() const { return range_; }

 private:
  bool is_over() const { return options_.stops_at_difference && has_visible_difference_; }

  /// Advances by one tick and compares it; returns false after the last one.
  bool Step() {
    const auto recorded = trace_.Next();
    if (!recorded) {
      NoteTheEnd();
      return false;
    }
    // The first record is the start, before any tick.
    if (has_begun_) simulation_.Tick();
    has_begun_ = true;
    // Before the commands of this tick: the trace has the state before them.
    if (recorded->tick >= range_.first) Compare(*recorded);
    if (is_over()) return false;
    const bool is_last = recorded->tick == range_.last;
    while (const auto failure = player_.ApplyDue(&simulation_)) Note(*failure);
    // Events of the last tick of the range are complete if a further record follows.
    const bool has_more = is_last && trace_.Next().has_value();
    if (recorded->tick >= range_.first) CompareEvents(*recorded, is_last && !has_more);
    if (is_last && !has_more) NoteTheEnd();
    return !is_last;
  }

  /// Compares the events since a tick. At the end of the trace some may be missing.
  void CompareEvents(const recording::TraceTick& recorded, bool is_end) {
    if (!trace_.has_events()) return;
    const std::vector<sim::Event>& replayed = collector_.events();
    const auto words = [](const std::vector<sim::Event>& events, std::size_t i) {
      if (i >= events.size()) return std::string("nothing");
      return events[i].object + " is " + std::string(ToString(events[i].kind));
    };
    for (std::size_t i = 0; i < std::max(recorded.events.size(), replayed.size()); ++i) {
      const bool was_recorded = i < recorded.events.size();
      if (was_recorded && i < replayed.size() && recorded.events[i] == replayed[i]) continue;
      if (!was_recorded && is_end) return;
      const std::string& object = was_recorded ? recorded.events[i].object : replayed[i].object;
      // The first different event only: those after it are shifted.
      return Note(Difference{recorded.tick, object, "event", words(recorded.events, i),
                             words(replayed, i)});
    }
  }

  void Compare(const recording::TraceTick& recorded) {
    const recording::TraceTick replayed =
        recording::WithAbsent(recording::Observe(simulation_), model_);
    report_.compared.last = recorded.tick;
    report_.hash = replayed.hash;
    const TickComparison comparison(recorded, replayed, model_);
    if (const auto difference = comparison.First()) Note(*difference);
    // As long as nothing visible differs, all deviations are zero and need not be measured.
    if (!has_visible_difference_ || is_over()) return;
    meter_.Compare(recorded, replayed);
    report_.state_differences = comparison.States();
  }

  /// Records a difference. Hidden state, such as the goal of a hand, differs before anything
  /// visible does: a visible difference replaces it, so that the report can name an object.
  void Note(const Difference& difference) {
    const bool is_visible = IsVisible(difference);
    if (!report_.first_difference || (is_visible && !has_visible_difference_)) {
      report_.first_difference = difference;
    }
    has_visible_difference_ = has_visible_difference_ || is_visible;
  }
  void Note(const LogPlayer::Failure& failure) {
    const recording::LoggedCommand& command = failure.command;
    report_.refused.push_back({command.tick, command.line, failure.refusal});
    Note(Difference{command.tick, "simulation", "command", "carried out", failure.refusal});
  }

  /// Notes the end of the trace; commands that remain are a difference.
  void NoteTheEnd() {
    report_.is_cut = trace_.is_cut();
    // A recording that was cut off may have commands whose ticks are missing.
    if (player_.next() == nullptr || report_.is_cut) return;
    Note(Difference{player_.next()->tick, "simulation", "command", "carried out",
                    "the trace ends before"});
  }

  const ReplayOptions& options_;
  recording::TickRange range_;
  recording::TraceReader trace_;
  std::uint64_t start_tick_;
  const model::Model& model_;  ///< with all objects added during the recording
  sim::Simulation simulation_;
  LogPlayer player_;
  EventCollector collector_;
  DeviationMeter meter_;
  ReplayReport report_;
  bool has_begun_ = false, has_visible_difference_ = false;
};

}  // namespace

ReplayReport Replay(const recording::Recording& recording, const ReplayOptions& options,
                    const recording::Progress& progress) {
  if (recording.info.origin == recording::Origin::kImported) {
    throw InputError({recording.directory.string(), 0, "",
                      "was imported from a classic recording and has no commands to replay"});
  }
  ReplayRun run(recording, options);
  const double total = recording::SecondsInto(recording, run.range().last);
  return run.Go([&](std::uint64_t tick) {
    return !progress || progress(recording::SecondsInto(recording, tick), total);
  });
}

}  // namespace smile::replay
