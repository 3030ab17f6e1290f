#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/action_history.h"
#include "sim/command.h"
#include "sim/event.h"
#include "sim/running_model.h"
#include "sim/simulation_state.h"
#include "sim/tick.h"

namespace smile::sim {

using demonstrator::Refusal;

using model::RobotPlacement;

class Simulation;

/// Somebody who watches a simulation. Called on its thread, after the fact; must not change it.
/// What it throws goes to whoever sent the command; the world has changed all the same.
class Listener {
 public:
  virtual ~Listener() = default;
  /// Asked before a command is carried out: why it must not be.
  virtual std::optional<Refusal> Refuse(const Simulation&, const Command&) { return std::nullopt; }
  /// A command was carried out at the present tick. Not told of Undo, Redo and of recording.
  virtual void OnCommand(const Simulation&, const Command&) {}
  virtual void OnEvent(const Simulation&, const Event&) {}
  /// An undo or redo has moved the cursor of the history from one action to its neighbor. After an
  /// undo, `to < from`, the simulation and its tick are as before `from`; after a redo, `from <
  /// to`, as at the undo of `to`.
  virtual void OnMove(const Simulation&, ActionId /*from*/, ActionId /*to*/) {}
  /// A tick is over. What happened during it is told after this.
  virtual void OnTick(const Simulation&) {}
};

/// Interface of what records on command; see recorder/recording_controller.h.
class RecordingControl {
 public:
  virtual ~RecordingControl() = default;
  virtual std::optional<Refusal> Start(const Simulation&, const StartRecording&) = 0;
  virtual std::optional<Refusal> Finish(const Simulation&) = 0;
};

/// A running model and its history, behind the one door: applies commands between ticks, keeps what
/// can be undone, and tells listeners.
///
/// Same scene, same commands at the same ticks: same bits. Used from one thread.
class Simulation {
 public:
  /// The model at its start. Shares it, so that what shows the simulation may outlive it.
  /// @param model  not null.
  explicit Simulation(std::shared_ptr<const model::Model> model);
  /// Of a model of its own.
  /// @param robot  nullopt for a table without one.
  explicit Simulation(scene::SceneSpec scene, std::optional<RobotPlacement> robot = std::nullopt);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// The one door. Applies the command at once, before the next tick.
  /// @returns why it was refused; the world is then as before.
  std::optional<Refusal> Apply(const Command& command);
  /// Why a command would be refused, as far as that does not depend on hands, objects and robot:
  /// by listeners, or because there is nothing to undo, to redo or to record with.
  std::optional<Refusal> Refuse(const Command& command) const;
  /// Advances by 1/60 s.
  void Tick();

  /// Since the scene was loaded.
  std::uint64_t tick() const { return running_->tick(); }
  /// False until the first command or tick.
  bool has_begun() const { return has_begun_; }
  /// What was done and what is undone.
  const ActionHistory& history() const { return history_; }
  double seconds() const { return SecondsOf(tick()); }
  /// Of everything that decides what happens next, the tick included.
  std::uint64_t state_hash() const { return running_->state_hash(); }

  /// What does not change while it runs, but for commands that add or load objects and the undo of
  /// these: then it is another model. Who keeps it beyond a command shares it.
  const model::Model& model() const { return *shared_model(); }
  const std::shared_ptr<const model::Model>& shared_model() const { return running_->model(); }
  /// The model with which the scene began, when the simulation was made or the scene loaded.
  const std::shared_ptr<const model::Model>& start_model() const { return running_->start_model(); }
  const scene::SceneSpec& scene() const { return model().scene(); }
  /// What is in the running model. References to it are valid until the next Load, Undo or Redo.
  const world::Tabletop& tabletop() const { return running_->tabletop(); }
  const physics::World& physics() const { return running_->physics(); }
  const demonstrator::Demonstrator& demonstrator() const { return running_->demonstrator(); }
  /// nullptr without one.
  const world::RobotBody* robot() const {
    return running_->robot() != nullptr ? &running_->robot()->body() : nullptr;
  }
  bool is_robot_shown() const {
    return running_->robot() == nullptr || running_->robot()->is_shown();
  }
  /// True while joints of the robot are on their way to a pose or along a trajectory.
  bool is_robot_following() const {
    return running_->robot() != nullptr && running_->robot()->is_following();
  }
  /// What the robot's face shows; idle without one.
  robot::FaceExpression face_expression() const {
    return running_->robot() != nullptr ? running_->robot()->face_expression()
                                        : robot::FaceExpression::kIdle;
  }

  /// True when nothing but what hands hold moves faster than 2 mm/s or 0.02 rad/s.
  bool is_still() const { return running_->is_still(); }

  /// What an object stands on or lies in, or would if it were released, see model::SupportOf().
  std::optional<model::Support> SupportOf(model::ObjectIndex object) const {
    return running_->SupportOf(object);
  }

  /// The present moment, for the model's visual model.
  scene::VisualState visual_state() const { return running_->visual_state(); }

  /// Listeners are told in the order they were added, until they are removed.
  void AddListener(Listener* listener) { listeners_.push_back(listener); }
  void RemoveListener(Listener* listener) { std::erase(listeners_, listener); }
  /// Without one, commands to record are refused. nullptr takes it away.
  void SetRecordingControl(RecordingControl* control) { recording_control_ = control; }

  SimulationState Save() const { return running_->Save(); }
  /// Goes on from a saved state of this or of another simulation that was made of the same scene
  /// and robot, whatever was added to either since. What was done before can no more be undone.
  void Restore(const SimulationState& state);

 private:
  /// The state alone.
  void RestoreState(const SimulationState& state);
  /// Carries out a command that changes the world, keeps it, and tells what came of it.
  std::optional<Refusal> Perform(const Command& command);
  void Undo();
  void Redo();
  void Load(const sim::Load& load);
  /// Applies the releases a grasp implies, as commands of their own; none if it will be refused.
  void ReleaseFor(const Grasp& grasp);
  void Tell(const Event& event);
  void TellOfMove(ActionId from);

  std::unique_ptr<RunningModel> running_;  ///< never null; another one after a Load
  bool has_begun_ = false;
  ActionHistory history_;
  std::vector<Listener*> listeners_;
  RecordingControl* recording_control_ = nullptr;
};

}  // namespace smile::sim
