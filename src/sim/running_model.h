#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "demonstrator/demonstrator.h"
#include "model/model.h"
#include "model/relations.h"
#include "physics/world.h"
#include "sim/command.h"
#include "sim/simulated_robot.h"
#include "sim/simulation_state.h"
#include "sim/visual_state_cache.h"
#include "world/tabletop.h"

namespace smile::sim {

/// What happened in a tick by itself, without a command.
struct TickReport {
  std::vector<const world::Object*> fallen;  ///< to the floor, in order of time
  std::vector<world::Press> presses;         ///< of controls, by control
  std::vector<world::ToolUse> uses;          ///< of tools that grippers squeezed or that turned
  std::vector<Refusal> refusals;             ///< of such uses
};

/// A model in motion: its physics world with tabletop, hands and robot, and the tick. Applies
/// commands and advances; it has no history, listeners or recordings.
///
/// Deterministic: the same model and the same commands at the same ticks give the same bits.
class RunningModel {
 public:
  /// Starts the model.
  explicit RunningModel(std::shared_ptr<const model::Model> model);
  RunningModel(const RunningModel&) = delete;
  RunningModel& operator=(const RunningModel&) = delete;

  /// Applies one command for hands, objects or the robot. Others have no effect here.
  /// @returns the reason if it was refused; nothing has then changed.
  std::optional<Refusal> Execute(const Command& command);
  /// Advances by 1/60 s.
  TickReport Tick();

  /// Returns what the last command did with a tool, if it was a Use.
  const world::ToolUse& last_use() const { return last_use_; }
  std::uint64_t tick() const { return tick_; }
  /// See Simulation::model().
  const std::shared_ptr<const model::Model>& model() const { return model_; }
  const std::shared_ptr<const model::Model>& start_model() const { return start_model_; }
  const world::Tabletop& tabletop() const { return tabletop_; }
  const physics::World& physics() const { return physics_; }
  const demonstrator::Demonstrator& demonstrator() const { return demonstrator_; }
  /// Returns the robot, or nullptr.
  const SimulatedRobot* robot() const { return robot_ ? &*robot_ : nullptr; }
  /// Returns what the tools that hands and grippers hold would do if they were used now.
  std::vector<world::ToolUse> PossibleUses() const;
  /// Returns the bodies that each gripper holds, by arm; empty without a robot.
  std::vector<std::vector<physics::BodyId>> HeldByGrippers() const;
  /// See Simulation.
  bool is_still() const;
  std::optional<model::Support> SupportOf(model::ObjectIndex object) const;
  const scene::VisualState& visual_state() const { return visual_state_.Update(); }

  std::uint64_t state_hash() const;
  SimulationState Save() const;
  /// Restores a saved state.
  /// @param state  of this or of another running model that began with the same scene and robot.
  void Restore(const SimulationState& state);

 private:
  /// Returns what hands and grippers hold.
  std::vector<world::Holder> Holders() const;
  std::optional<Refusal> ExecuteOne(const Grasp& grasp);
  std::optional<Refusal> ExecuteOne(const MoveTo& move);
  std::optional<Refusal> ExecuteOne(const Plane& plane);
  std::optional<Refusal> ExecuteOne(const Attend& attend);
  std::optional<Refusal> ExecuteOne(const Rotate& rotate);
  std::optional<Refusal> ExecuteOne(const Release& release);
  std::optional<Refusal> ExecuteOne(const Destroy& destroy);
  std::optional<Refusal> ExecuteOne(const Point& point);
  std::optional<Refusal> ExecuteOne(const Trigger& trigger);
  std::optional<Refusal> ExecuteOne(const Fasten& fasten);
  std::optional<Refusal> ExecuteOne(const Loosen& loosen);
  std::optional<Refusal> ExecuteOne(const Use& use);
  std::optional<Refusal> ExecuteOne(const Markers& markers);
  std::optional<Refusal> ExecuteOne(const Spawn& spawn);
  std::optional<Refusal> ExecuteOne(const Remove& remove);
  std::optional<Refusal> ExecuteOne(const Displace& displace);
  std::optional<Refusal> ExecuteOne(const Clear& clear);

  std::shared_ptr<const model::Model> start_model_;
  std::shared_ptr<const model::Model> model_;
  physics::World physics_;
  world::Tabletop tabletop_;
  demonstrator::Demonstrator demonstrator_;
  std::optional<SimulatedRobot> robot_;
  std::uint64_t tick_ = 0;
  world::ToolUse last_use_;  ///< a report, not state
  mutable VisualStateCache visual_state_{this};
};

}  // namespace smile::sim
