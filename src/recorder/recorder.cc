#include "recorder/recorder.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/demand.h"
#include "base/files.h"
#include "recording/beginning.h"
#include "recording/recording_files.h"
#include "recording/trace_reader.h"
#include "sim/eye.h"
#include "texts/user_message.h"

// Follows a simulation and writes log, trace and classic view as it goes. Log first, trace second:
// a line without its record can be recognized when the recording is opened, a record without its
// line could not. Marks of actions are positions in all three, so that an undo can lead back.

namespace smile::recorder {

using texts::Say;
namespace {

/// Checks everything that can be checked before a directory is made.
void CheckBefore(const std::filesystem::path& directory, const RecorderOptions& options,
                 const sim::Simulation& simulation) {
  if (!(options.frames_per_second > 0 && options.frames_per_second <= sim::kTicksPerSecond)) {
    throw std::invalid_argument("recording: frames per second are " +
                                std::to_string(options.frames_per_second) +
                                ", expected more than 0 and at most 60");
  }
  if (recording::IsBlank(options.title))
    throw std::invalid_argument("recording: " + recording::BlankTitle());
  const auto& placement = simulation.model().robot_placement();
  if (placement && placement->files.empty()) {
    throw std::invalid_argument("recording: a robot without its files cannot be recorded");
  }
  recording::RequireNewDirectory(directory);
}

/// Returns the contents of demo.json.
recording::DemoInfo InfoOf(const RecorderOptions& options, const sim::Eye* eye,
                           const sim::Simulation& simulation,
                           const recording::HistoryPoint& start) {
  recording::DemoInfo info{.scene = simulation.scene().name,
                           .title = options.title,
                           .notes = options.notes,
                           .meters_per_unit = simulation.scene().meters_per_unit,
                           .physics_version = simulation.scene().physics_version,
                           .origin = options.origin,
                           .start = start,
                           .frames_per_second = options.frames_per_second,
                           .has_symbols = options.has_symbols,
                           .corrects = options.corrects};
  if (const auto& placement = simulation.model().robot_placement()) {
    info.robot = recording::RobotInfo{
        .name = placement->model.name,
        .gap = placement->gap,
        .height = placement->height,
        .urdf = (std::filesystem::path(recording::kRobotFolder) / placement->files.front().name)
                    .string(),
        .gripper = placement->gripper,
        .body = placement->body};
  }
  if (eye != nullptr) {
    info.eye = EyeView(simulation, eye->spec());
    info.eye_camera = eye->spec().camera;
  }
  return info;
}

classic::ClassicOptions ClassicOptionsOf(const RecorderOptions& options) {
  return {.frames_per_second = options.frames_per_second, .has_symbols = options.has_symbols};
}

/// Returns events from before a recording that still matter: fallen objects, held objects, and
/// properties that were pointed out.
std::vector<sim::Event> StandingOf(const sim::Simulation& simulation) {
  using enum sim::EventKind;
  // These events come before the first tick's record; readers learn from them what the poses do not
  // show.
  std::vector<sim::Event> standing;
  for (const world::Object& object : simulation.tabletop().objects()) {
    if (simulation.tabletop().HasFallen(object)) {
      standing.push_back({.kind = kFell, .object = object.id()});
    }
    const auto& properties = simulation.demonstrator().PropertiesThatMatter(object);
    if (properties.empty()) continue;
    standing.push_back({.kind = kAttended,
                        .hand = demonstrator::HandName::kAny,
                        .object = object.id(),
                        .properties = properties});
  }
  for (demonstrator::HandName name : demonstrator::kHandNames) {
    const demonstrator::Hand& hand = simulation.demonstrator().hand(name);
    if (!hand.is_holding()) continue;
    standing.push_back(
        {.kind = kGrasped, .hand = name, .object = simulation.tabletop().Find(hand.held)->id()});
  }
  return standing;
}

}  // namespace

Recorder::Recorder(const std::filesystem::path& directory, const RecorderOptions& options,
                   sim::Eye* eye, const sim::Simulation& simulation)
    : directory_(directory), tick_(simulation.tick()) {
  if (!simulation.history().is_complete()) {
    throw std::invalid_argument("recording: the simulation was restored from a saved state");
  }
  CheckBefore(directory, options, simulation);
  try {
    Begin(options, eye, simulation);
  } catch (...) {
    // It never began: leave nothing behind, also no picture that still waits.
    classic_.reset();
    std::error_code error;
    std::filesystem::remove_all(directory, error);
    throw;
  }
}

void Recorder::Begin(const RecorderOptions& options, sim::Eye* eye,
                     const sim::Simulation& simulation) {
  recording::BeginningMark mark(directory_);
  // With the commands of the log that added objects, it becomes the present model.
  recording::WriteWorld(directory_, *simulation.start_model());
  const recording::TraceTick first = recording::Observe(simulation);
  const std::vector<sim::Event> standing = StandingOf(simulation);
  log_.emplace(directory_ / "commands.jsonl");
  // A replay runs these first and arrives at the state in which the recording begins.
  for (const sim::TimedCommand& past : simulation.history().CommandsDone()) {
    Write({.tick = past.tick, .what = past.command}, simulation.scene().meters_per_unit);
  }
  trace_.emplace(directory_ / "trace.bin", *simulation.start_model());
  for (const sim::Event& event : standing) trace_->Add(event);
  trace_->Add(first);
  classic_.emplace(directory_, ClassicOptionsOf(options), eye, simulation.shared_model(), first,
                   standing);
  classic_->Flush();
  // Written last: a directory that contains it can be opened.
  const recording::HistoryPoint start{.line = num_lines_, .tick = tick_};
  WriteFile(directory_ / "demo.json",
            recording::ToJsonText(InfoOf(options, eye, simulation, start)));
  mark.Remove();
}

void Recorder::Write(const recording::LogLine& line, double meters_per_unit) {
  log_->Append(recording::ToJsonLine(line, meters_per_unit));
  ++num_lines_;
}

Recorder::Savepoint Recorder::MakeSavepoint() const {
  return {.point = {.line = num_lines_, .tick = tick_}, .place = trace_->place()};
}

std::optional<sim::Refusal> Recorder::Refuse(const sim::Simulation& simulation,
                                             const sim::Command& command) {
  const sim::ActionHistory& history = simulation.history();
  // Only actions since the start of the recording have savepoints.
  if (std::holds_alternative<sim::Undo>(command) &&
      action_savepoints_.Find(history.current().id) == nullptr) {
    return history.can_undo() ? Say("recorder.nothingToUndoYet") : Say("recorder.nothingToUndo");
  }
  if (std::holds_alternative<sim::Redo>(command) &&
      (!history.can_redo() || action_savepoints_.Find(history.undone().front().id) == nullptr)) {
    return Say("recorder.nothingToRedo");
  }
  if (std::holds_alternative<sim::Load>(command)) {
    return Say("recorder.hasOneScene");
  }
  return std::nullopt;
}

void Recorder::OnCommand(const sim::Simulation& simulation, const sim::Command& command) {
  // The savepoint is made before the line is written: an undo leads back to before the action.
  if (IsAction(command))
    action_savepoints_.Begin(
        simulation.history(),
        {.before = MakeSavepoint(), .classic_before = classic_->MakeSavepoint(), .at_undo = {}});
  Write({.tick = simulation.tick(), .what = command}, simulation.scene().meters_per_unit);
}

void Recorder::OnEvent(const sim::Simulation& simulation, const sim::Event& event) {
  if (event.kind == sim::EventKind::kCommandRefused) return;
  trace_->Add(event);
  classic_->Use(simulation.shared_model());
  classic_->Note(event);
}

void Recorder::OnTick(const sim::Simulation& simulation) {
  tick_ = simulation.tick();
  const recording::TraceTick now = recording::Observe(simulation);
  trace_->Add(now);
  classic_->WriteFrameIfDue(now);
}

void Recorder::OnMove(const sim::Simulation& simulation, sim::ActionId from, sim::ActionId to) {
  // Refuse() allows the cursor to move only over actions with savepoints.
  // Ids increase along the history: the later one is the action that is undone or redone.
  ActionSavepoints* savepoints = action_savepoints_.Find(std::max(from, to));
  SMILE_DEMAND(savepoints != nullptr);
  if (to < from) {
    Undo(simulation, savepoints);
  } else {
    Redo(simulation, *savepoints);
  }
}

void Recorder::Undo(const sim::Simulation& simulation, ActionSavepoints* undone) {
  // A redo returns here, to the state at the undo.
  undone->at_undo = MakeSavepoint();
  Return(recording::ReturnKind::kUndo, undone->before, simulation);
  classic_->Use(simulation.shared_model());
  classic_->Return(undone->classic_before);
}

void Recorder::Redo(const sim::Simulation& simulation, const ActionSavepoints& redone) {
  Return(recording::ReturnKind::kRedo, redone.at_undo, simulation);
  classic_->Use(simulation.shared_model());
  // The classic view has no undone branches: go back to before the action, then add it again from
  // the trace.
  classic_->Return(redone.classic_before);
  ShowAgain(redone, simulation);
}

void Recorder::Return(recording::ReturnKind kind, const Savepoint& to,
                      const sim::Simulation& simulation) {
  // The line has the tick at which the button was pressed; the state afterwards has that of the
  // target.
  Write({.tick = tick_, .what = recording::Return{.kind = kind, .to = to.point}},
        simulation.scene().meters_per_unit);
  tick_ = simulation.tick();
  trace_->Return(to.place, num_lines_, tick_);
}

void Recorder::ShowAgain(const ActionSavepoints& redone, const sim::Simulation& simulation) {
  recording::TraceReader trace({.directory = directory_,
                                .start_model = simulation.start_model(),
                                .model = simulation.shared_model()},
                               redone.at_undo.place);
  // On one path, later records are farther back in the file, so a comparison of places selects
  // those after the action began.
  for (auto moment = trace.At(redone.before.point.tick); moment; moment = trace.Next()) {
    if (trace.places()[0] > redone.before.place) classic_->WriteFrameIfDue(*moment);
    for (std::size_t i = 0; i < moment->events.size(); ++i) {
      if (trace.places()[i + 1] > redone.before.place) classic_->Note(moment->events[i]);
    }
  }
}

}  // namespace smile::recorder
