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

/// Observer of a simulation. Called on its thread, after each change; must not change the
/// simulation. Exceptions reach the sender of the command; the world has changed all the same.
class Listener {
 public:
  virtual ~Listener() = default;
  /// Called before a command is applied; returns a reason to refuse it.
  virtual std::optional<Refusal> Refuse(const Simulation&, const Command&) { return std::nullopt; }
  /// A command was applied at the present tick. Not called for Undo, Redo and recording commands.
  virtual void OnCommand(const Simulation&, const Command&) {}
  virtual void OnEvent(const Simulation&, const Event&) {}
  /// An undo or redo has moved the cursor of the history from one action to its neighbor. After an
  /// undo, `to < from`, the simulation and its tick are as before `from`; after a redo, `from <
  /// to`, as at the undo of `to`.
  virtual void OnMove(const Simulation&, ActionId /*from*/, ActionId /*to*/) {}
  /// A tick is over. Its events are reported after this.
  virtual void OnTick(const Simulation&) {}
};

/// Interface of a recorder that is controlled by commands; see recorder/recording_controller.h.
class RecordingControl {
 public:
  virtual ~RecordingControl() = default;
  virtual std::optional<Refusal> Start(const Simulation&, const StartRecording&) = 0;
  virtual std::optional<Refusal> Finish(const Simulation&) = 0;
};

/// A running model and its history: applies commands between ticks, keeps the states for undo, and
/// notifies listeners.
///
/// Deterministic: the same scene and the same commands at the same ticks give the same bits. Used
/// from one thread.
class Simulation {
 public:
  /// Starts a model, which is shared, so that views of the simulation may outlive it.
  /// @param model  not null.
  explicit Simulation(std::shared_ptr<const model::Model> model);
  /// Starts a model of its own.
  /// @param robot  nullopt for a table without a robot.
  explicit Simulation(scene::SceneSpec scene, std::optional<RobotPlacement> robot = std::nullopt);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Applies a command at once, before the next tick. All changes come through here.
  /// @returns the reason if it was refused; the world has then not changed.
  std::optional<Refusal> Apply(const Command& command);
  /// Returns the reason why a command would be refused, as far as it does not depend on hands,
  /// objects and robot: by listeners, or because there is nothing to undo, to redo or to record
  /// with.
  std::optional<Refusal> Refuse(const Command& command) const;
  /// Advances by 1/60 s.
  void Tick();

  /// Returns the number of ticks since the scene was loaded.
  std::uint64_t tick() const { return running_->tick(); }
  /// Returns false until the first command or tick.
  bool has_begun() const { return has_begun_; }
  /// Returns the done and undone actions.
  const ActionHistory& history() const { return history_; }
  double seconds() const { return SecondsOf(tick()); }
  /// Returns a hash of all state that affects the future, including the tick.
  std::uint64_t state_hash() const { return running_->state_hash(); }

  /// Returns the model, which changes only by commands that add or load objects and by their undo:
  /// it is then another model. Share it to keep it beyond a command.
  const model::Model& model() const { return *shared_model(); }
  const std::shared_ptr<const model::Model>& shared_model() const { return running_->model(); }
  /// Returns the model with which the scene began, when the simulation was made or the scene
  /// loaded.
  const std::shared_ptr<const model::Model>& start_model() const { return running_->start_model(); }
  const scene::SceneSpec& scene() const { return model().scene(); }
  /// Parts of the running model. References to them are valid until the next Load, Undo or Redo.
  const world::Tabletop& tabletop() const { return running_->tabletop(); }
  const physics::World& physics() const { return running_->physics(); }
  const demonstrator::Demonstrator& demonstrator() const { return running_->demonstrator(); }
  /// Returns the robot's body, or nullptr.
  const world::RobotBody* robot() const {
    return running_->robot() != nullptr ? &running_->robot()->body() : nullptr;
  }
  bool is_robot_shown() const {
    return running_->robot() == nullptr || running_->robot()->is_shown();
  }
  /// Returns true while joints of the robot move to a pose or along a trajectory.
  bool is_robot_following() const {
    return running_->robot() != nullptr && running_->robot()->is_following();
  }
  /// Returns the expression of the robot's face; idle without a robot.
  robot::FaceExpression face_expression() const {
    return running_->robot() != nullptr ? running_->robot()->face_expression()
                                        : robot::FaceExpression::kIdle;
  }

  /// Returns true if no object except held ones moves faster than 2 mm/s or 0.02 rad/s.
  bool is_still() const { return running_->is_still(); }

  /// Returns the support of an object, now or if it were released, see model::SupportOf().
  std::optional<model::Support> SupportOf(model::ObjectIndex object) const {
    return running_->SupportOf(object);
  }

  /// Returns what the tools that hands and grippers hold would do if they were used now.
  std::vector<world::ToolUse> PossibleUses() const { return running_->PossibleUses(); }

  /// Returns the present state for the model's visual model. Only what may have changed since the
  /// last call is computed. The reference is valid until the next change of the simulation; copy
  /// the state to keep it.
  const scene::VisualState& visual_state() const { return running_->visual_state(); }

  /// Adds a listener. Listeners are notified in the order in which they were added, until they are
  /// removed.
  void AddListener(Listener* listener) { listeners_.push_back(listener); }
  void RemoveListener(Listener* listener) { std::erase(listeners_, listener); }
  /// Sets the recorder; without one, recording commands are refused. nullptr removes it.
  void SetRecordingControl(RecordingControl* control) { recording_control_ = control; }

  SimulationState Save() const { return running_->Save(); }
  /// Continues from a saved state of this or of another simulation of the same scene and robot,
  /// whatever was added to either since. Earlier actions can no longer be undone.
  void Restore(const SimulationState& state);

 private:
  /// Restores the state without changing the history.
  void RestoreState(const SimulationState& state);
  /// Applies a command that changes the world, records it in the history, and reports its events.
  std::optional<Refusal> Perform(const Command& command);
  void Undo();
  void Redo();
  void Load(const sim::Load& load);
  /// Applies the releases that a grasp implies, as commands of their own; none if it will be
  /// refused.
  void ReleaseFor(const Grasp& grasp);
  void Notify(const Event& event);
  void NotifyMove(ActionId from);

  std::unique_ptr<RunningModel> running_;  ///< never null; replaced by a Load
  bool has_begun_ = false;
  ActionHistory history_;
  std::vector<Listener*> listeners_;
  RecordingControl* recording_control_ = nullptr;
};

}  // namespace smile::sim
