#include "studio/internal_state_machine.h"
#include "texts/user_message.h"

#include <initializer_list>
#include <utility>

// Transitions between the states of a session. A transition happens between ticks, in the session's
// thread, and ends with a call of the listener if pages must draw something else.

namespace smile::studio {

using texts::Say;

std::optional<texts::UserMessage> StateMachine::Unmet(Need need) const {
  // First the needs that concern the machine itself, whatever the states are.
  switch (need) {
    case Need::kPlayback:
      if (playback_ != nullptr) return std::nullopt;
      return Say("session.noPlayback");
    case Need::kRobot:
      if (has_robot_) return std::nullopt;
      return Say("session.noRobot");
    case Need::kProgram:
      if (brain_.is_running()) return std::nullopt;
      return Say("brain.isIdle");
    case Need::kNoProgram:
      if (!brain_.is_running()) return std::nullopt;
      return Say("brain.isRunning");
    default:
      break;
  }
  // The first activity that prevents the need gives the reason; playback is the most visible one.
  const std::initializer_list<const Activity*> activities = {playback_.get(), restoring_.get(),
                                                             world_state_.get()};
  for (const Activity* activity : activities) {
    if (activity == nullptr) continue;
    if (auto reason = activity->Unmet(need)) return reason;
  }
  return std::nullopt;
}

bool StateMachine::Tick() {
  ++num_ticks_;
  // A program also starts while playback is shown or time is paused.
  brain_.Attend(&world_->simulation());
  // Only what is shown advances: the live world waits beneath a playback.
  SessionState& shown = playback_ ? *playback_ : *world_state_;
  const bool has_ticked = shown.Tick(pace_.is_paused);
  if (has_ticked && !playback_) EndIfOver();
  return has_ticked;
}

void StateMachine::Enter(std::unique_ptr<LiveWorld> world) {
  LeaveWorld();
  world_ = std::move(world);
  // Discards the picture that was recorded during the restoration.
  if (CapturingEye* eye = world_->eye()) (void)eye->Take();
  BeginWorld();
}

std::optional<sim::Refusal> StateMachine::Apply(const sim::Command& command) {
  const sim::Simulation& simulation = world_->simulation();
  // A command may replace the model: another start model is another world (load, or undo of one);
  // another model with the same start has other objects (spawn, or undo of one).
  const std::shared_ptr<const model::Model> model = simulation.shared_model();
  const std::shared_ptr<const model::Model> start_model = simulation.start_model();
  if (auto refusal = world_->Apply(command)) return refusal;
  // The brain and the running state refer to the former scene and end; LiveWorld itself stays.
  if (simulation.start_model() != start_model) {
    LeaveWorld();
    BeginWorld();
  } else if (simulation.shared_model() != model) {
    listener_->OnOtherScene();
  }
  return std::nullopt;
}

void StateMachine::LeaveWorld() {
  // In this order, since states refer to the world and the program.
  brain_.Leave();
  playback_.reset();
  world_state_.reset();
}

void StateMachine::BeginWorld() {
  world_state_ = std::make_unique<LiveState>(world_.get(), &brain_);
  // Caches of the former world go before anything draws the new one.
  listener_->OnOtherWorld();
  listener_->OnOtherScene();
}

void StateMachine::Imitate(task::ImitationTask imitation_task) {
  world_state_ = std::make_unique<ImitatingState>(std::move(imitation_task), world_.get(), &brain_);
}

void StateMachine::AnimateClearTable() {
  world_state_ = std::make_unique<ClearTableState>(world_.get());
}

void StateMachine::EndIfOver() {
  if (!world_state_->is_over()) return;
  // The next state is entered after the score has been computed from the world as it is.
  if (auto score = world_state_->End(pace_.measured_speed)) listener_->OnScore(*std::move(score));
  world_state_ = std::make_unique<LiveState>(world_.get(), &brain_);
}

void StateMachine::Show(std::unique_ptr<PlaybackState> playback) {
  // The state of the world stays as it is, and continues after GoLive().
  playback_ = std::move(playback);
  listener_->OnOtherScene();
}

void StateMachine::GoLive() {
  playback_.reset();
  listener_->OnOtherScene();
}

std::unique_ptr<LiveWorld> StateMachine::TakeRestored() {
  // Reset even if the restoration failed: other worlds and recordings are allowed again.
  return std::exchange(restoring_, nullptr)->TakeWorld();
}

}  // namespace smile::studio
