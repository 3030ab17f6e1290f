// Continuing a recording: replays it to the chosen point, checks that it is the same, then appends
// to its files.

#include <algorithm>
#include <stdexcept>

#include "base/diagnostic.h"
#include "base/files.h"
#include "recorder/internal_replay_along.h"
#include "recorder/recorder.h"
#include "recording/conflicts.h"
#include "recording/segment_files.h"
#include "recording/time_range.h"
#include "recording/trace_reader.h"

namespace smile::recorder {
namespace {

/// Returns the size of the first lines of a file [bytes].
std::uint64_t BytesOfLines(const std::filesystem::path& path, std::size_t num_lines) {
  const std::string text = ReadFile(path, std::size_t{1} << 30);
  std::size_t end = 0;
  // The log has been read already, so each of these lines has its newline.
  for (std::size_t i = 0; i < num_lines; ++i) end = text.find('\n', end) + 1;
  return end;
}

/// Fails if a file of the recording is a link, so that nothing outside is written to.
void RefuseLinks(const std::filesystem::path& directory) {
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    if (!entry.is_symlink()) continue;
    throw InputError({entry.path().string(), 0, "",
                      "is a link; only a recording with its own files can be continued"});
  }
}

}  // namespace

std::unique_ptr<Recorder> Recorder::Continue(const std::filesystem::path& directory,
                                             const recording::HistoryPoint& from, sim::Eye* eye,
                                             sim::Simulation* simulation,
                                             const recording::Progress& progress) {
  if (recording::IsRecording(directory)) RefuseLinks(directory);
  // Lock the log before reading it.
  std::unique_ptr<Recorder> recorder(new Recorder(directory));
  const auto log_path = directory / "commands.jsonl";
  recorder->log_.emplace(log_path, recording::AppendFile::kExisting);
  const recording::Recording recording = recording::OpenRecording(directory);
  if (recording.info.origin == recording::Origin::kImported) {
    Fail(recording, "was imported from a classic recording and has no commands to continue from");
  }
  if (recording.info.demonstrator != recording::DemonstratorAppearance::kInvisible) {
    Fail(recording,
         "is a copy that shows its demonstrator; continue the original recording instead");
  }
  const std::size_t num_lines = recording.log.lines().size();
  if (from.line > num_lines) {
    Fail(recording, "has no line " + std::to_string(from.line) + " in its log");
  }
  const Reached reached =
      ReplayAlong(recording, recording.log.PathTo(from.line), from, simulation).Go(progress);

  // The classic view is removed before log and trace change: it is rebuilt in any case, and an
  // interruption must not leave an outdated one.
  recording::RemoveClassicView(directory);
  const std::uint64_t since_start = from.tick - std::min(from.tick, recording.info.start.tick);
  recording::RemoveConflictsAfter(directory, sim::SecondsOf(since_start));
  // Removes what opening has dropped: an unfinished line, or a return that was not carried out.
  recorder->log_->Cut(BytesOfLines(log_path, num_lines));
  recorder->num_lines_ = num_lines;
  recorder->tick_ = recording::TicksOf(recording).last;
  const recording::TraceReader trace(recording);
  const recording::TracePlace end = trace.size();
  recorder->trace_.emplace(trace, from.tick);
  const recording::CommandLog& log = recording.log;
  // A checkout is needed only if the point is not where log and trace end anyway.
  if (log.LineBefore(num_lines + 1) != log.LineBefore(from.line + 1) || reached.place != end) {
    recorder->Return(recording::ReturnKind::kCheckout, {.point = from, .place = reached.place},
                     *simulation);
  }
  // Completes the trace: these events follow from commands that the log has.
  for (const sim::Event& event : reached.untold) recorder->trace_->Add(event);
  recorder->tick_ = from.tick;
  recorder->Rebuild(recording::OpenRecording(directory), eye, *simulation, progress);
  recorder->Flush();
  return recorder;
}

void Recorder::Rebuild(const recording::Recording& recording, sim::Eye* eye,
                       const sim::Simulation& simulation, const recording::Progress& progress) {
  // Marks for the actions on the path, so that they can be undone in the continued recording.
  std::vector<recording::HistoryPoint> before_actions;
  for (const recording::LoggedCommand& logged : recording.commands) {
    if (logged.line <= recording.info.start.line || !IsAction(logged.command)) continue;
    before_actions.push_back({.line = logged.line - 1, .tick = logged.tick});
  }
  // These are the last actions that the simulation executed.
  const auto actions = simulation.history().done().last(before_actions.size());
  recording::TraceReader trace(recording);
  while (const auto moment = trace.Next()) {
    if (classic_) {
      classic_->WriteFrameIfDue(*moment);
    } else {
      classic_.emplace(
          directory_,
          classic::ClassicOptions{.frames_per_second = recording.info.frames_per_second,
                                  .has_symbols = recording.info.has_symbols},
          eye, simulation.shared_model(), *moment, trace.events_before_start());
    }
    for (std::size_t i = 0; i < moment->events.size(); ++i) {
      // Actions of the trace, of the log and of the simulation are in the same order.
      if (BeginsAction(moment->events[i])) {
        const std::size_t number = action_savepoints_.size();
        action_savepoints_[actions[number].id] = {
            .before = {.point = before_actions.at(number), .place = trace.places()[i]},
            .classic_before = classic_->MakeSavepoint(),
            .at_undo = {}};
      }
      classic_->Note(moment->events[i]);
    }
    if (progress) progress(sim::SecondsOf(moment->tick), sim::SecondsOf(simulation.tick()));
  }
}

}  // namespace smile::recorder
