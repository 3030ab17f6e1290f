// Going on with a recording.

#include "base/diagnostic.h"
#include "base/files.h"
#include "record/log_player.h"
#include "record/recorder.h"
#include "record/trace_reader.h"

namespace smile::record {
namespace {

[[noreturn]] void Fail(const Recording& recording, const std::string& message) {
  throw InputError({recording.directory.string(), 0, "", message});
}

/// Runs a fresh simulation along the recording to a moment, and makes sure that it is the same.
/// @returns its place in the trace.
TracePlace RunTo(const Moment& until, const Recording& recording,
                 const std::vector<LoggedCommand>& way, sim::Simulation* simulation) {
  const auto differs = [&](std::uint64_t tick) {
    Fail(recording, "cannot go on: run again, it differs at tick " + std::to_string(tick) +
                        " (it was made by " + recording.info.program + ")");
  };
  LogPlayer player(way, recording.info.start);
  TraceReader trace(recording, until);
  if (player.RunToStart(simulation)) differs(simulation->tick());
  bool has_begun = false;
  while (const auto moment = trace.Next()) {
    if (has_begun) simulation->Tick();
    has_begun = true;
    if (simulation->state_hash() != moment->hash) differs(moment->tick);
    if (player.ApplyDue(simulation)) differs(moment->tick);
  }
  if (!has_begun || simulation->tick() != until.tick || player.next() != nullptr) {
    Fail(recording, "has no moment at tick " + std::to_string(until.tick) + " after line " +
                        std::to_string(until.line) + " of its log");
  }
  return trace.places().back();
}

/// How many bytes the first lines of a file are.
std::uint64_t BytesOfLines(const std::filesystem::path& path, std::size_t num_lines) {
  const std::string text = ReadFile(path, std::size_t{1} << 30);
  std::size_t end = 0;
  for (std::size_t i = 0; i < num_lines; ++i) end = text.find('\n', end) + 1;
  return end;
}

void RemoveClassicView(const std::filesystem::path& directory) {
  for (int segment = 0;; ++segment) {
    const auto folder = directory / std::to_string(segment);
    const bool had_text =
        std::filesystem::remove(directory / (folder.filename().string() + ".txt"));
    if (std::filesystem::remove_all(folder) == 0 && !had_text) break;
  }
  std::filesystem::remove(directory / "frames.csv");
}

}  // namespace

std::unique_ptr<Recorder> Recorder::Continue(const std::filesystem::path& directory,
                                             const Moment& from, sim::Eye* eye,
                                             sim::Simulation* simulation) {
  // First the log is ours, then it is read.
  std::unique_ptr<Recorder> recorder(new Recorder(directory));
  const auto log_path = directory / "commands.jsonl";
  recorder->log_.emplace(log_path, AppendFile::kExisting);
  const Recording recording = OpenRecording(directory);
  if (recording.info.origin == Origin::kImported) {
    Fail(recording, "was imported from a classic recording; it has no commands to go on from");
  }
  const std::size_t num_lines = recording.log.lines().size();
  if (from.line > num_lines) {
    Fail(recording, "has no line " + std::to_string(from.line) + " in its log");
  }
  const std::vector<LoggedCommand> way = recording.log.WayTo(from.line);
  const TracePlace place = RunTo(from, recording, way, simulation);

  recorder->log_->Cut(BytesOfLines(log_path, num_lines));
  recorder->num_lines_ = num_lines;
  recorder->tick_ = recording.log.After(num_lines).tick;
  const TracePlace end = TraceReader(recording).size();
  recorder->trace_.emplace(directory / "trace.bin", end, from.tick);
  const CommandLog& log = recording.log;
  if (log.LineBefore(num_lines + 1) != log.LineBefore(from.line + 1) || place != end) {
    recorder->Return(ReturnKind::kCheckout, {.moment = from, .place = place}, *simulation);
  }
  recorder->tick_ = from.tick;
  RemoveClassicView(directory);
  recorder->Rebuild(recording, way, from, eye, *simulation);
  return recorder;
}

void Recorder::Rebuild(const Recording& recording, const std::vector<LoggedCommand>& way,
                       const Moment& until, sim::Eye* eye, const sim::Simulation& simulation) {
  std::vector<Moment> before_actions;
  for (const LoggedCommand& logged : way) {
    if (logged.line <= recording.info.start.line || !IsAction(logged.command)) continue;
    before_actions.push_back({.line = logged.line - 1, .tick = logged.tick});
  }
  TraceReader trace(recording, until);
  while (const auto moment = trace.Next()) {
    if (classic_) {
      classic_->Watch(*moment);
    } else {
      classic_.emplace(directory_,
                       ClassicOptions{.frames_per_second = recording.info.frames_per_second,
                                      .has_symbols = recording.info.has_symbols},
                       eye, simulation, *moment, trace.events_before_start());
    }
    for (std::size_t i = 0; i < moment->events.size(); ++i) {
      if (BeginsSegment(moment->events[i])) {
        const std::size_t action = before_action_.size();
        if (action == before_actions.size()) Fail(recording, "has more actions than its log");
        before_action_.push_back({.moment = before_actions[action],
                                  .place = trace.places()[i],
                                  .classic = classic_->mark()});
      }
      classic_->Note(moment->events[i]);
    }
  }
}

}  // namespace smile::record
