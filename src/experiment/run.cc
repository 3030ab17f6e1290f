// A run without a window: one loop in which, for each tick, the script acts, then the brain, then
// physics; recorder and observer listen to the simulation. The wall clock only delays it (pacing)
// or ends it (timeouts, cancellation), so equal plans give equal recordings.

#include "experiment/run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "base/diagnostic.h"
#include "base/hash_text.h"
#include "brain/brain_log.h"
#include "experiment/brain_setup.h"
#include "experiment/content_hash.h"
#include "experiment/refusal_reporter.h"
#include "experiment/world_description.h"
#include "picture/rendered_eye.h"
#include "recording/notes.h"
#include "task/comparison.h"

namespace smile::experiment {
namespace {

using Clock = std::chrono::steady_clock;

/// Returns the directory in which the run records; empty if it does not record from the start.
std::filesystem::path RecordingOf(const RunPlan& plan) {
  return plan.continuation ? plan.continuation->recording : plan.record;
}

/// Objects of one run. Members are in the order of construction, which is reversed on destruction:
/// the brain ends first, the eye last.
class LiveRun {
 public:
  LiveRun(const RunPlan& plan, const Callbacks& callbacks)
      : plan_(plan),
        callbacks_(callbacks),
        simulation_(plan.scene, plan.robot),
        refusals_(&callbacks),
        brain_log_(RecordingOf(plan)),
        notes_(RecordingOf(plan), recording::kNotesFile) {
    simulation_.AddListener(&refusals_);
    // Found first, so that a missing brain does not leave an empty recording behind.
    if (HasBrain()) FindBrain();
    const bool records = !plan.record.empty() || plan.continuation || StartsRecordings();
    const bool takes_pictures = records && plan.has_pictures;
    if (takes_pictures || HasBrain()) {
      sim::EyeView(simulation_, plan.eye);  // throws if the camera does not exist
      eye_.emplace(plan.eye);
    }
    if (records) {
      controller_.emplace(&simulation_, recorder::RecordingController::Options{
                                            .root = plan.recordings,
                                            .recording = plan.recording,
                                            .eye = takes_pictures ? &*eye_ : nullptr});
    }
    // The recorder must see the initial state, before anything acts.
    if (!plan.record.empty() && !plan.correction) controller_->StartIn(plan.record, simulation_);
    if (plan.correction) {
      controller_->Correct(recording::OpenRecording(plan.correction->recording),
                           plan.correction->seconds, plan.record, &simulation_,
                           callbacks_.ProgressOf(plan.label));
    }
    if (plan.continuation) {
      controller_->Continue(plan.continuation->recording, plan.continuation->from, &simulation_,
                            callbacks_.ProgressOf(plan.label));
    }
    if (plan.goal != nullptr) episode_.emplace(&simulation_);
    first_tick_ = simulation_.tick();
    // The recording is started before script and brain, so that it contains their first commands.
    if (plan.script) player_.emplace(*plan.script);
    if (HasBrain()) StartBrain();
    if (plan.disturbance) disturber_.emplace(*plan.disturbance);
  }

  RunResult Go() {
    const auto start = Clock::now();
    // Counts the time of the run, which advances evenly even if an undo sets the simulation's back.
    while (!IsOver()) {
      refusals_.Tick(&simulation_);
      passed_ += 1.0 / sim::kTicksPerSecond;
      ReportProgress();
      if (plan_.is_realtime) WaitUntil(start + std::chrono::duration<double>(passed_));
    }
    if (controller_) controller_->Flush();
    const std::chrono::duration<double> wall = Clock::now() - start;
    ThrowIfNotRecorded();
    if (player_ && !player_->is_finished() && !callbacks_.IsCancelled()) {
      callbacks_.Say(player_->place() + ": the time limit was reached before this line");
    }
    return Describe(wall.count());
  }

 private:
  bool HasBrain() const { return plan_.brain_function || !plan_.brain.empty(); }

  /// Finds the brain, which starts later. Its output goes to the callbacks and its log.
  void FindBrain() {
    if (plan_.brain_function) {
      function_.emplace(plan_.brain_function);
      return;
    }
    brain::BrainOptions options = brain::WithTimeout(plan_.callback_seconds);
    options.on_output = [this](std::string_view line) {
      callbacks_.Say("brain: " + std::string(line));
      brain_log_.Write(line);
    };
    options.is_cancelled = [this] { return callbacks_.IsCancelled(); };
    options.is_attached = plan_.is_attached;
    options.on_waiting = [this](std::string_view instructions) {
      callbacks_.Say("smile: waiting for the brain (Ctrl-C ends); " + std::string(instructions));
    };
    process_.emplace(plan_.brain, std::move(options));
  }

  /// Reports how long the run has lasted, and how many objects of its goal are in place.
  void ReportProgress() {
    // Comparing takes milliseconds: once per simulated second is often enough for people.
    if (episode_ && simulation_.tick() % sim::kTicksPerSecond == 0) {
      const task::Episode episode = episode_->episode();
      const task::StructureComparison comparison = task::CompareWith(*plan_.goal, episode);
      // The structure may stand anywhere: before the first contact, one object is always in place.
      std::size_t num_placed = 0;
      if (!episode.contacts.empty()) {
        for (const auto& [id, error] : comparison.errors) num_placed += error.is_within();
      }
      label_ = plan_.label + ", " + std::to_string(num_placed) + " of " +
               std::to_string(comparison.errors.size()) + " objects in place";
    }
    callbacks_.Report(label_, passed_, plan_.seconds.value_or(0));
  }

  /// Waits until a time, or notes by how much it has passed already.
  template <class Time>
  void WaitUntil(Time due) {
    const std::chrono::duration<double> delay = Clock::now() - due;
    if (delay.count() > 0) {
      ++late_ticks_;
      worst_delay_ = std::max(worst_delay_, delay.count());
    }
    std::this_thread::sleep_until(due);
  }

  void StartBrain() {
    brain::BrainDriverOptions options = DriverOptionsFor(plan_.brain, plan_.demonstration, &*eye_);
    options.plan = plan_.plan;
    options.image_seconds = plan_.image_seconds;
    options.noise = plan_.noise;
    options.variation = plan_.behavior;
    options.gives_poses = plan_.gives_poses;
    options.on_note = [this](const sim::Note& note) {
      notes_.Write(recording::LineOf({.tick = simulation_.tick(), .note = note}));
    };
    // The brain starts here and not with its first step: its init may set the posture of the robot,
    // which must precede the first tick.
    driver_.emplace(std::move(options));
    DriveBrain();
  }

  /// Exchanges sensor and motor values with the program if its next step is due.
  void DriveBrain() {
    if (function_) {
      const auto question = driver_->NextQuestion(&simulation_);
      if (question) driver_->Take(function_->Answer(*question), &simulation_);
    } else {
      driver_->Drive(&*process_, &simulation_);
    }
    LogBrainError();
  }

  void LogBrainError() {
    if (driver_->error()) brain_log_.Write(ToString(*driver_->error()));
  }

  /// Returns true if the script contains a command that begins a recording.
  bool StartsRecordings() const {
    if (!plan_.script) return false;
    for (const sim::ScriptLine& line : plan_.script->lines) {
      const auto* command = std::get_if<sim::Command>(&line.what);
      if (command != nullptr && std::holds_alternative<sim::StartRecording>(*command)) return true;
    }
    return false;
  }

  /// Applies the commands that are due. On a faulty line, names what has been recorded until then.
  void AdvanceScript() {
    try {
      player_->Advance(&simulation_);
    } catch (const InputError&) {
      ThrowIfNotRecorded();  // a failed recording is the real cause
      if (controller_) {
        for (const auto& directory : controller_->directories()) {
          callbacks_.Say("recorded in " + directory.string());
        }
      }
      throw;
    }
  }

  /// Throws the failure of a recording, for example on a full disk, without which the run is
  /// useless.
  void ThrowIfNotRecorded() const {
    if (controller_ && controller_->failure()) throw std::runtime_error(*controller_->failure());
  }

  void BeginFarewell() {
    farewell_ticks_ = std::lround(plan_.seconds_after_brain * sim::kTicksPerSecond);
    brain_end_tick_ = simulation_.tick();
  }

  bool is_brain_running() const {
    return driver_ && driver_->status() == brain::BrainStatus::kRunning;
  }

  /// Its time counts from the end of watching.
  void Disturb() {
    const std::uint64_t start = first_tick_ + driver_->watched_ticks();
    disturber_->Advance(std::max(simulation_.tick(), start) - start, &simulation_);
  }

  /// Applies the next commands of script and brain; true at the end of the run.
  bool IsOver() {
    if (callbacks_.IsCancelled()) return true;
    ThrowIfNotRecorded();
    auto limit = static_cast<std::uint64_t>(
        std::llround(plan_.seconds.value_or(plan_.max_seconds) * sim::kTicksPerSecond));
    // The time limit of a brain counts from the end of watching.
    if (!plan_.seconds && driver_) limit += driver_->watched_ticks();
    // By the simulation's clock: after an undo in the script, the run lasts longer in wall-clock
    // time but ends at the same simulated time.
    const bool is_at_limit = simulation_.tick() >= first_tick_ + limit;
    // A brain that ended in time has ended in time, so what it did is observed to the end.
    if (is_at_limit && (plan_.seconds || farewell_ticks_ == 0)) return true;
    // Script before brain, in every tick, so that runs are deterministic.
    if (player_) AdvanceScript();
    if (is_brain_running()) {
      if (disturber_) Disturb();
      DriveBrain();
      if (!is_brain_running()) BeginFarewell();
    }
    // The script continues during these ticks, but the brain has ended.
    if (farewell_ticks_ > 0) {
      --farewell_ticks_;
      return false;
    }
    if (driver_ && driver_->status() == brain::BrainStatus::kFailed) return true;
    // With an exact length, a run continues although nothing acts.
    if (plan_.seconds) return false;
    return (!player_ || player_->is_finished()) && !is_brain_running();
  }

  RunResult Describe(double wall_seconds) const {
    RunResult result{.ticks = simulation_.tick(),
                     .seconds = simulation_.seconds(),
                     .state_hash = simulation_.state_hash(),
                     .wall_seconds = wall_seconds,
                     .realtime_factor = wall_seconds > 0 ? passed_ / wall_seconds : 0,
                     .is_realtime = plan_.is_realtime,
                     .late_ticks = late_ticks_,
                     .worst_delay = worst_delay_,
                     .objects = DescribeObjects(simulation_),
                     .controls = DescribeControls(simulation_),
                     .robot = DescribeRobot(simulation_)};
    if (driver_) {
      result.brain_status = driver_->status();
      result.brain_error = driver_->error();
      result.brain_claim = driver_->claim();
      result.watched_seconds = sim::SecondsOf(driver_->watched_ticks());
      if (brain_end_tick_) {
        result.seconds_after_brain = sim::SecondsOf(simulation_.tick() - *brain_end_tick_);
      }
    }
    if (controller_) result.recordings = controller_->directories();
    if (disturber_) result.disturbance = disturber_->json();
    return result;
  }

  const RunPlan& plan_;
  const Callbacks& callbacks_;
  std::optional<picture::RenderedEye> eye_;
  std::optional<recorder::RecordingController> controller_;
  sim::Simulation simulation_;
  RefusalReporter refusals_;
  std::uint64_t first_tick_ = 0;
  std::optional<std::uint64_t> brain_end_tick_;
  std::int64_t farewell_ticks_ = 0;  ///< remaining after the end of the brain
  std::string label_ = plan_.label;
  std::optional<task::EpisodeObserver> episode_;  ///< if there is a goal
  double passed_ = 0;  ///< simulated since then, also what was undone [s]
  std::uint64_t late_ticks_ = 0;
  double worst_delay_ = 0;
  std::optional<sim::ScriptPlayer> player_;
  std::optional<Disturber> disturber_;
  brain::BrainLog brain_log_;  ///< written to by the process's thread
  brain::BrainLog notes_;
  std::optional<brain::FunctionBrain> function_;
  std::optional<brain::BrainProcess> process_;
  std::optional<brain::BrainDriver> driver_;
};

}  // namespace

Json BrainJson(const RunResult& result) {
  return {{"status", result.brain_status ? ToString(*result.brain_status) : "none"},
          {"message", result.brain_error ? ToString(*result.brain_error) : ""},
          {"claim", ClaimJson(result.brain_claim)}};
}

Json ToJson(const RunResult& result) {
  Json json = {{"ticks", result.ticks},
               {"seconds", result.seconds},
               {"hash", HashText(result.state_hash)},
               {"realtime_factor", result.realtime_factor},
               {"objects", result.objects},
               {"controls", result.controls},
               {"robot", result.robot},
               {"brain", BrainJson(result)},
               {"recordings", Json::array()}};
  // Measurements of the machine, left out otherwise: equal runs then have equal JSON, except for
  // the factor.
  if (result.is_realtime) {
    json["late_ticks"] = result.late_ticks;
    json["worst_delay"] = result.worst_delay;
  }
  for (const auto& directory : result.recordings) {
    json["recordings"].push_back(directory.string());
  }
  return json;
}

RunResult Run(const RunPlan& plan, const Callbacks& callbacks) {
  return LiveRun(plan, callbacks).Go();
}

}  // namespace smile::experiment
