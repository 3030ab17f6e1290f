#include "app/run_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include "app/interrupt.h"
#include "app/progress.h"
#include "base/diagnostic.h"
#include "brain/brain_log.h"
#include "math/angles.h"
#include "picture/rendered_eye.h"
#include "scene/units.h"

namespace smile::app {
namespace {

using Clock = std::chrono::steady_clock;

Json ArrayOf(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Json DescribeRobot(const sim::Simulation& simulation) {
  const world::RobotBody* robot = simulation.robot();
  if (robot == nullptr) return nullptr;
  const double unit = simulation.scene().meters_per_unit;
  Json json;
  for (int arm = 0; arm < robot->num_arms(); ++arm) {
    json[robot->model().arms[arm].name] = {
        {"joints", robot->ArmAngles(arm)},
        {"gripper", scene::ToFileUnits(robot->GripperOpening(arm), unit)},
        {"end_effector", ArrayOf(scene::ToFileUnits(robot->ToolPose(arm).translation(), unit))}};
  }
  json["head"] = robot->HeadAngle();
  return json;
}

std::string HashText(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

/// From the end of a robot program to the end of its run: the face it ends with is to be in films.
constexpr int kFarewellTicks = sim::kTicksPerSecond / 4;
constexpr double kInitPatience = 12;  ///< as much more for init as for a callback

std::filesystem::path RecordingOf(const RunPlan& plan) {
  return plan.continuation ? plan.continuation->recording : plan.record;
}

/// Everything alive during one run, in the order in which it must be taken down.
class LiveRun {
 public:
  explicit LiveRun(const RunPlan& plan)
      : plan_(plan), simulation_(plan.scene, plan.robot), brain_log_(RecordingOf(plan)) {
    // A brain that does not exist must not leave an empty recording behind.
    if (!plan.brain.empty()) FindBrain();
    const bool records = !plan.record.empty() || plan.continuation || StartsRecordings();
    const bool takes_pictures = records && plan.has_pictures;
    if (takes_pictures || !plan.brain.empty()) {
      sim::EyeView(simulation_, plan.eye);  // refuses a camera that is not there
      eye_.emplace(plan.eye);
    }
    if (records) {
      desk_.emplace(&simulation_,
                    record::RecordingDesk::Options{.root = plan.recordings,
                                                   .recording = plan.recording,
                                                   .eye = takes_pictures ? &*eye_ : nullptr});
    }
    if (!plan.record.empty()) desk_->StartIn(plan.record, simulation_);
    if (plan.continuation) {
      ProgressLine progress(plan.label);
      desk_->Continue(plan.continuation->recording, plan.continuation->from, &simulation_,
                      [&progress](double done, double total) {
                        progress.Show(done, total);
                        return !IsInterrupted();
                      });
    }
    first_tick_ = simulation_.tick();
    if (plan.script) player_.emplace(*plan.script);
    if (process_) StartBrain();
  }

  RunOutcome Go() {
    const auto start = Clock::now();
    ProgressLine progress(plan_.label);
    // Time passes evenly, also when the simulation's goes back by an undo.
    while (!IsOver()) {
      simulation_.Tick();
      passed_ += 1.0 / sim::kTicksPerSecond;
      progress.Show(passed_, plan_.seconds.value_or(0));
      if (plan_.is_realtime) WaitUntil(start + std::chrono::duration<double>(passed_));
    }
    const std::chrono::duration<double> wall = Clock::now() - start;
    ThrowIfNotRecorded();
    if (player_ && !player_->is_finished() && !IsInterrupted()) {
      std::fprintf(stderr, "%s: time was up before this line\n", player_->place().c_str());
    }
    return Describe(wall.count());
  }

 private:
  void FindBrain() {
    process_.emplace(plan_.brain,
                     brain::BrainOptions{.start_seconds = kInitPatience * plan_.patience,
                                         .callback_seconds = plan_.patience,
                                         .on_output =
                                             [this](std::string_view line) {
                                               std::fprintf(stderr, "brain: %.*s\n",
                                                            static_cast<int>(line.size()),
                                                            line.data());
                                               brain_log_.Write(line);
                                             },
                                         .is_cancelled = &IsInterrupted,
                                         .is_attached = plan_.is_attached,
                                         .on_waiting = &TellHowToAttach});
  }

  static void TellHowToAttach(std::string_view instructions) {
    std::fprintf(stderr, "smile: waiting for the brain (Ctrl-C ends); %.*s\n",
                 static_cast<int>(instructions.size()), instructions.data());
  }

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
    driver_.emplace(brain::BrainDriverOptions{.eye = &*eye_,
                                              .image_seconds = plan_.image_seconds,
                                              .has_trackers = brain::MayReadTrackers(plan_.brain),
                                              .demonstration = plan_.demonstration,
                                              .attention = plan_.attention,
                                              .noise = plan_.noise});
    DriveBrain();
  }

  void DriveBrain() {
    driver_->Drive(&*process_, &simulation_);
    LogBrainError();
  }

  void LogBrainError() {
    if (driver_->error()) brain_log_.Write(ToString(*driver_->error()));
  }

  bool StartsRecordings() const {
    if (!plan_.script) return false;
    for (const sim::ScriptLine& line : plan_.script->lines) {
      const auto* command = std::get_if<sim::Command>(&line.what);
      if (command != nullptr && std::holds_alternative<sim::StartRecording>(*command)) return true;
    }
    return false;
  }

  void AdvanceScript() {
    try {
      player_->Advance(&simulation_);
    } catch (const InputError&) {
      ThrowIfNotRecorded();  // then that is why
      if (desk_) {
        for (const auto& directory : desk_->directories()) {
          std::fprintf(stderr, "recorded in %s\n", directory.c_str());
        }
      }
      throw;
    }
  }

  void ThrowIfNotRecorded() const {
    if (desk_ && desk_->failure()) throw std::runtime_error(*desk_->failure());
  }

  bool is_brain_running() const {
    return driver_ && driver_->status() == brain::BrainStatus::kRunning;
  }

  /// Lets script and brain speak; true when nothing more is to come.
  bool IsOver() {
    if (IsInterrupted()) return true;
    ThrowIfNotRecorded();
    const auto limit = static_cast<std::uint64_t>(
        std::llround(plan_.seconds.value_or(plan_.max_seconds) * sim::kTicksPerSecond));
    if (simulation_.tick() >= first_tick_ + limit) return true;
    if (player_) AdvanceScript();
    if (is_brain_running()) {
      DriveBrain();
      if (!is_brain_running()) farewell_ticks_ = kFarewellTicks;
    }
    if (farewell_ticks_ > 0) {
      --farewell_ticks_;
      return false;
    }
    if (driver_ && driver_->status() == brain::BrainStatus::kFailed) return true;
    if (plan_.seconds) return false;
    return (!player_ || player_->is_finished()) && !is_brain_running();
  }

  RunOutcome Describe(double wall_seconds) {
    RunOutcome outcome{.ticks = simulation_.tick(),
                       .wall_seconds = wall_seconds,
                       .late_ticks = late_ticks_,
                       .worst_delay = worst_delay_};
    Json brain = {{"status", "none"}, {"message", ""}};
    if (driver_) {
      brain["status"] = ToString(driver_->status());
      outcome.brain_error = driver_->error();
      if (outcome.brain_error) brain["message"] = ToString(*outcome.brain_error);
    }
    outcome.json = {{"ticks", simulation_.tick()},
                    {"seconds", simulation_.seconds()},
                    {"hash", HashText(simulation_.state_hash())},
                    {"realtime_factor", wall_seconds > 0 ? passed_ / wall_seconds : 0.0},
                    {"objects", DescribeObjects(simulation_)},
                    {"controls", DescribeControls(simulation_)},
                    {"robot", DescribeRobot(simulation_)},
                    {"brain", brain}};
    if (plan_.is_realtime) {
      outcome.json["late_ticks"] = late_ticks_;
      outcome.json["worst_delay"] = worst_delay_;
    }
    if (desk_) outcome.recordings = desk_->directories();
    outcome.json["recordings"] = Json::array();
    for (const auto& directory : outcome.recordings) {
      outcome.json["recordings"].push_back(directory.string());
    }
    return outcome;
  }

  const RunPlan& plan_;
  std::optional<picture::RenderedEye> eye_;
  std::optional<record::RecordingDesk> desk_;
  sim::Simulation simulation_;
  std::uint64_t first_tick_ = 0;
  int farewell_ticks_ = 0;  ///< to go on, though the brain has ended
  double passed_ = 0;       ///< simulated since then, also what was undone [s]
  std::uint64_t late_ticks_ = 0;
  double worst_delay_ = 0;
  std::optional<sim::ScriptPlayer> player_;
  brain::BrainLog brain_log_;  ///< written to by the process's thread
  std::optional<brain::BrainProcess> process_;
  std::optional<brain::BrainDriver> driver_;
};

}  // namespace

Json DescribeControls(const sim::Simulation& simulation) {
  Json json = Json::object();
  const world::Tabletop& tabletop = simulation.tabletop();
  for (model::ControlIndex i : simulation.model().controls()) {
    const model::Control& control = simulation.model().control(i);
    if (!tabletop.IsPresent(control)) continue;
    json[control.id()] = RecordedState(control, tabletop.controls().states()[i]);
  }
  return json;
}

Json DescribeObjects(const sim::Simulation& simulation) {
  Json json = Json::object();
  for (const world::Object& object : simulation.tabletop().objects()) {
    if (!simulation.tabletop().IsPresent(object)) continue;
    const RigidTransform X_WB = simulation.physics().body(object.body).pose_in_world();
    json[object.id()] = {{"position", ArrayOf(scene::ToFileUnits(
                                          X_WB.translation(), simulation.scene().meters_per_unit))},
                         {"rotation", ArrayOf(FixedAxesAngles(X_WB.rotation()))}};
  }
  return json;
}

RunOutcome Run(const RunPlan& plan) { return LiveRun(plan).Go(); }

}  // namespace smile::app
