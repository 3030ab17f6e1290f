// Simulates an edited demonstration from the start of its recording and compares both ends. The
// past before the start cannot be edited and must run exactly; in the edited part, a command may
// have become impossible (its object is gone, a hand is full) and is skipped and reported.

#include "editing/re_simulation.h"

#include <cmath>
#include <stdexcept>
#include <system_error>

#include "base/diagnostic.h"
#include "editing/track_conflicts.h"
#include "recorder/recorder.h"
#include "replay/log_player.h"

namespace smile::editing {
namespace {

recorder::RecorderOptions OptionsFor(const recording::Recording& recording) {
  return {.frames_per_second = recording.info.frames_per_second,
          .has_symbols = recording.info.has_symbols,
          .title = recording.info.title,
          .notes = recording.info.notes,
          .origin = recording::Origin::kEdited};
}

/// Reports objects that end elsewhere, and objects that exist only before or only after the edit.
void CompareObjects(const recording::TraceTick& before, const recording::TraceTick& after,
                    const model::Model& model, EditReport* report) {
  // Both ticks have the indices of the same model here, see AsOf().
  for (std::size_t i = 0; i < after.objects.size(); ++i) {
    const recording::TracePose &was = before.objects[i], &is = after.objects[i];
    const std::string& id = model.id(model::ObjectIndex(i));
    if (was.is_present && is.is_present) {
      const recording::PoseGap gap = recording::GapBetween(was, is);
      if (gap.IsBeyond(kSamePlace)) report->displaced.push_back({id, gap});
    } else if (was.is_present) {
      report->gone.push_back(id);
    } else if (is.is_present) {
      report->there_again.push_back(id);
    }
  }
}

/// Converts a tick to the indices of the recording's model, by ids: an edit may drop the addition
/// of objects, or change its order. Missing objects are absent.
recording::TraceTick AsOf(const model::Model& recorded, const recording::TraceTick& moment,
                          const model::Model& model) {
  recording::TraceTick same = moment;
  same.objects.assign(recorded.objects().size(), recording::TracePose{.is_present = false});
  same.controls.assign(recorded.controls().size(), {});
  same.bonds.assign(recorded.hosts().size(), {});
  for (model::ObjectIndex i : recorded.objects()) {
    if (const auto index = model.FindObject(recorded.id(i)))
      same.objects[i] = moment.objects[*index];
  }
  for (model::ControlIndex i : recorded.controls()) {
    const auto index = model.FindControl(recorded.control(i).id());
    if (index) same.controls[i] = moment.controls[*index];
  }
  for (model::HostIndex i : recorded.hosts()) {
    const auto index = model.FindHost(recorded.host(i).point->id);
    if (index) same.bonds[i] = moment.bonds[*index];
  }
  return same;
}

/// Compares the controls of objects that are present before and after.
void CompareControls(const recording::TraceTick& before, const recording::TraceTick& after,
                     const model::Model& model, EditReport* report) {
  for (model::ControlIndex i : model.controls()) {
    const model::Control& control = model.control(i);
    // A missing object is reported as such; its controls would only repeat it.
    if (!before.objects[control.object].is_present || !after.objects[control.object].is_present) {
      continue;
    }
    const std::string was = RecordedState(control, before.controls[i]);
    const std::string is = RecordedState(control, after.controls[i]);
    if (was != is) report->controls.push_back({control.id(), was, is});
  }
}

void CompareHostPoints(const recording::TraceTick& before, const recording::TraceTick& after,
                       const model::Model& model, EditReport* report) {
  for (std::size_t i = 0; i < after.bonds.size(); ++i) {
    const int was = before.bonds[i].tightness, is = after.bonds[i].tightness;
    if (was == is) continue;
    report->host_points.push_back(
        {model.host(model::HostIndex(i)).point->id, std::to_string(was), std::to_string(is)});
  }
}

/// Returns the end of the recording. The trace has the state before the commands of its last tick;
/// if there are any, the recording is simulated again.
recording::TraceTick EndOf(const recording::Recording& recording,
                           const recording::Demonstration& edited,
                           const recording::Progress& progress) {
  const bool is_complete =
      recording.commands.empty() || recording.commands.back().tick < edited.recorded_end.tick;
  if (is_complete) return edited.recorded_end;
  sim::Simulation simulation(recording.start_model);
  replay::LogPlayer player(recording.commands, recording.info.start);
  RunToStart(recording, &player, &simulation);
  RunFor(edited.recorded_duration(), &player, &simulation, progress);
  return recording::Observe(simulation);
}

void CompareJoints(const recording::TraceTick& before, const recording::TraceTick& after,
                   const model::Model& model, EditReport* report) {
  for (std::size_t i = 0; i < after.joints.size(); ++i) {
    const scene::LinkSpec& link = model.robot()->links[i];
    const bool slides = link.joint_type == scene::JointType::kPrismatic;
    // Fingers slide, so their tolerance is a length.
    const double allowed = slides ? kSamePlace.distance : kSameAngle;
    if (std::abs(after.joints[i] - before.joints[i]) > allowed) {
      report->joints.push_back(link.joint_name);
    }
  }
}

}  // namespace

void RunToStart(const recording::Recording& recording, replay::LogPlayer* player,
                sim::Simulation* simulation) {
  const auto failure = player->RunToStart(simulation);
  if (!failure) return;
  throw InputError({(recording.directory / "commands.jsonl").string(),
                    static_cast<int>(failure->command.line), "",
                    "was carried out in the recording, but is refused now: " + failure->refusal});
}

std::vector<SkippedCommand> RunFor(std::uint64_t ticks, replay::LogPlayer* player,
                                   sim::Simulation* simulation, const recording::Progress& progress,
                                   const CommandObserver& observer) {
  std::vector<SkippedCommand> skipped;
  for (std::uint64_t tick = 0;; ++tick) {
    // Commands of a tick come before the tick, as in a live simulation; at the end one more round
    // applies those of the last tick.
    while (player->IsDue(*simulation)) {
      const recording::LoggedCommand& next = *player->next();
      if (observer.before) observer.before(next);
      auto refused = player->ApplyNext(simulation);
      if (observer.after) {
        observer.after(next, refused ? std::optional(refused->refusal) : std::nullopt);
      }
      if (refused) skipped.push_back({next.line, std::move(refused->refusal)});
    }
    if (tick == ticks) return skipped;
    simulation->Tick();
    if (progress && !progress(sim::SecondsOf(tick + 1), sim::SecondsOf(ticks))) return skipped;
  }
}

EditReport ReSimulate(const recording::Recording& recording, const recording::Demonstration& edited,
                      const std::optional<EditOutput>& output,
                      const recording::Progress& progress) {
  std::optional<recorder::Recorder> recorder;  // destroyed after the simulation that it observes
  sim::Simulation simulation(recording.start_model);
  replay::LogPlayer player(edited.Schedule(), edited.start);
  RunToStart(recording, &player, &simulation);
  if (output) {
    // Attached only now, so that the new recording begins where the old one did.
    recorder.emplace(output->directory, OptionsFor(recording), output->eye, simulation);
    simulation.AddListener(&*recorder);
  }
  EditReport report{.ticks_before = edited.recorded_duration(), .ticks_after = edited.duration()};
  TrackConflicts conflicts(edited);
  const CommandObserver observer{
      .before = [&](const auto& command) { conflicts.Before(command, simulation); },
      .after = [&](const auto& command,
                   const auto& refusal) { conflicts.After(command, refusal); }};
  report.skipped = RunFor(report.ticks_after, &player, &simulation, progress, observer);
  report.conflicts = conflicts.conflicts();
  for (SkippedCommand& command : report.skipped) {
    const std::size_t num_lines = recording.log.lines().size();
    command.is_of_overlay = command.line > num_lines;
    if (command.is_of_overlay) command.line -= num_lines;
  }
  if (recorder) {
    recorder->Flush();
    recording::WriteConflicts(output->directory, report.conflicts);
  }
  const model::Model& model = *recording.model;
  // Both ends are compared in terms of the recording's model.
  const recording::TraceTick before = EndOf(recording, edited, progress);
  const recording::TraceTick after =
      AsOf(model, recording::Observe(simulation), simulation.model());
  CompareObjects(before, after, model, &report);
  CompareControls(before, after, model, &report);
  CompareHostPoints(before, after, model, &report);
  CompareJoints(before, after, model, &report);
  return report;
}

EditReport MakeEdited(const recording::Recording& recording, const recording::Demonstration& edited,
                      const EditOutput& output, const recording::Progress& progress) {
  std::error_code error;
  const bool was_there = std::filesystem::exists(output.directory, error);
  bool should_continue = true;
  const auto watch = [&](double done, double total) {
    should_continue = !progress || progress(done, total);
    return should_continue;
  };
  try {
    const EditReport report = ReSimulate(recording, edited, output, watch);
    if (!should_continue) throw std::runtime_error("interrupted");
    return report;
    // A partial recording would look like a complete one.
  } catch (...) {
    if (!was_there) std::filesystem::remove_all(output.directory, error);
    throw;
  }
}

}  // namespace smile::editing
