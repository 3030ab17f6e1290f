#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "demonstrator/demonstrator.h"
#include "model/model.h"
#include "physics/world.h"
#include "sim/action_history.h"
#include "sim/command.h"
#include "sim/event.h"
#include "sim/simulation_state.h"
#include "sim/tick.h"
#include "sim/trajectory_follower.h"
#include "world/robot_body.h"
#include "world/tabletop.h"

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

/// Who records when told to; see recorder/recording_desk.h.
class RecordingControl {
 public:
  virtual ~RecordingControl() = default;
  virtual std::optional<Refusal> Start(const Simulation&, const StartRecording&) = 0;
  virtual std::optional<Refusal> Finish(const Simulation&) = 0;
};

/// The one owner of a running world: applies commands between ticks, keeps time, tells listeners.
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

  std::uint64_t tick() const { return tick_; }
  /// False until the first command or tick.
  bool has_begun() const { return has_begun_; }
  /// What was done and what is undone.
  const ActionHistory& history() const { return history_; }
  double seconds() const { return SecondsOf(tick_); }
  /// Of everything that decides what happens next, the tick included.
  std::uint64_t state_hash() const;

  /// What does not change while it runs, but for a spawn or the undo of one: then it is another
  /// model, with more or fewer objects. Who keeps it beyond a command shares it.
  const model::Model& model() const { return *model_; }
  const std::shared_ptr<const model::Model>& shared_model() const { return model_; }
  /// With which it was made.
  const std::shared_ptr<const model::Model>& start_model() const { return start_model_; }
  const scene::SceneSpec& scene() const { return model_->scene(); }
  const world::Tabletop& tabletop() const { return tabletop_; }
  const physics::World& physics() const { return physics_; }
  const demonstrator::Demonstrator& demonstrator() const { return demonstrator_; }
  /// nullptr without one.
  const world::RobotBody* robot() const { return robot_.get(); }
  bool is_robot_shown() const { return is_robot_shown_; }
  /// True while joints of the robot are on their way to a pose or along a trajectory.
  bool is_robot_following() const { return follower_ && follower_->is_following(); }
  /// What the robot's face shows; idle without one.
  robot::Mood mood() const { return mood_; }

  /// True when nothing but what hands hold moves faster than 2 mm/s or 0.02 rad/s.
  bool is_still() const;

  /// What an object stands on or lies in, or would if it were released, see model::SupportOf().
  std::optional<model::Support> SupportOf(model::ObjectIndex object) const;

  /// The present moment, for the model's visual model.
  scene::VisualState visual_state() const;

  /// Listeners are told in the order they were added, until they are removed.
  void AddListener(Listener* listener) { listeners_.push_back(listener); }
  void RemoveListener(Listener* listener) { std::erase(listeners_, listener); }
  /// Without one, commands to record are refused. nullptr takes it away.
  void SetRecordingControl(RecordingControl* control) { recording_control_ = control; }

  SimulationState Save() const;
  /// Goes on from a saved state of this or of another simulation that was made of the same scene
  /// and robot, whatever was added to either since. What was done before can no more be undone.
  void Restore(const SimulationState& state);

 private:
  /// The state alone.
  void PutBack(const SimulationState& state);
  /// Carries out a command that changes the world, and tells what came of it.
  std::optional<Refusal> Perform(const Command& command);
  std::optional<Refusal> Carry(const Command& command);
  std::optional<Refusal> Carry(const Grasp& grasp);
  std::optional<Refusal> Carry(const MoveTo& move);
  std::optional<Refusal> Carry(const Plane& plane);
  std::optional<Refusal> Carry(const Attend& attend);
  std::optional<Refusal> Carry(const Rotate& rotate);
  std::optional<Refusal> Carry(const Release& release);
  std::optional<Refusal> Carry(const Destroy& destroy);
  std::optional<Refusal> Carry(const Point& point);
  std::optional<Refusal> Carry(const Trigger& trigger);
  std::optional<Refusal> Carry(const Fasten& fasten);
  std::optional<Refusal> Carry(const Loosen& loosen);
  std::optional<Refusal> Carry(const JointVelocities& velocities);
  std::optional<Refusal> Carry(const JointAngles& angles);
  std::optional<Refusal> Carry(const TurnJoint& turn);
  std::optional<Refusal> Carry(const MoveGripper& move);
  std::optional<Refusal> Carry(const TakePose& pose);
  std::optional<Refusal> Carry(const FollowTrajectory& follow);
  std::optional<Refusal> Carry(const ShowRobot& show);
  std::optional<Refusal> Carry(const Face& face);
  std::optional<Refusal> Carry(const Markers& markers);
  std::optional<Refusal> Carry(const Spawn& spawn);
  std::optional<Refusal> Carry(const Remove& remove);
  std::optional<Refusal> Carry(const Clear& clear);
  std::optional<Refusal> Carry(const Undo& undo);
  std::optional<Refusal> Carry(const Redo& redo);
  std::optional<Refusal> Carry(const StartRecording& start);
  std::optional<Refusal> Carry(const FinishRecording& finish);
  /// An arm's joints are commanded by somebody: they follow nothing any more.
  void LeaveArm(int arm);
  void LeaveGripper(int arm);
  void LeaveHead();
  std::optional<Refusal> RefuseArm(const std::optional<std::vector<double>>& values, int arm) const;
  /// Applies the releases a grasp implies, as commands of their own; none if it will be refused.
  void ReleaseFor(const Grasp& grasp);
  void Tell(const Event& event);
  /// What an event of a command has to say of the moment before it.
  struct Before {
    std::string held;                ///< id of what its hand held
    std::vector<bool> were_present;  ///< of each object, where the command may change that
  };
  Before LookBefore(const Command& command) const;
  /// What a command did to the objects it is about.
  void TellOfCommand(const Command& command, const Before& before);
  /// Ids of the objects that came or went.
  std::vector<std::string> ChangedSince(const Before& before) const;
  /// Notice what changed since `before`. A bond that ended because an object was destroyed is no
  /// hand's.
  void TellOfBonds(const std::vector<world::BondState>& before, std::optional<HandName> hand);
  void TellOfControls(const std::vector<model::ControlState>& before);
  /// Notices what grippers got or lost since `before`.
  void TellOfGrippers(const std::vector<std::vector<physics::BodyId>>& before);
  std::vector<std::vector<physics::BodyId>> HeldByGrippers() const;

  std::shared_ptr<const model::Model> start_model_;
  std::shared_ptr<const model::Model> model_;
  physics::World physics_;
  world::Tabletop tabletop_;
  demonstrator::Demonstrator demonstrator_;
  std::unique_ptr<world::RobotBody> robot_;
  std::optional<TrajectoryFollower> follower_;  ///< of the robot, where there is one
  bool is_robot_shown_ = true;
  robot::Mood mood_ = robot::Mood::kIdle;
  std::uint64_t tick_ = 0;
  bool has_begun_ = false;
  ActionHistory history_;
  std::vector<Listener*> listeners_;
  RecordingControl* recording_control_ = nullptr;
};

}  // namespace smile::sim
