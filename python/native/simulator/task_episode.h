#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "control.h"
#include "handle.h"
#include "task/goal_space.h"

namespace smile::python {

/// What an agent learns after an action.
struct StepResult {
  std::vector<double> observation;  ///< see TaskEpisode::observation_names()
  std::vector<double> achieved;     ///< goal, see task::GoalSpace
  std::vector<double> desired;      ///< goal; the same in all steps of an episode
  task::GoalScore score;
  std::optional<std::string> refusal;  ///< what of the action was impossible
};

/// An episode of a task: a robot is controlled by actions, and what it achieves is compared with
/// the task's goal. It begins with the present state of a simulation, and lasts as long as that.
class TaskEpisode {
 public:
  /// @param handle   must outlive this.
  /// @param objects  ids of those that are observed.
  /// @throws InputError if the task is impossible in this scene, or done before anything happens.
  TaskEpisode(Handle* handle, std::shared_ptr<const task::GoalSpace> space, ControlOptions options,
              const std::vector<std::string>& objects);

  /// Names of the numbers of an observation: of the robot first, then of its environment.
  std::vector<std::string> observation_names() const;
  std::size_t num_robot_numbers() const;
  const Control& control() const { return control_; }

  /// Return what is the case, now or after an action. They need the simulation, but not the
  /// interpreter's lock.
  StepResult Now();
  StepResult Step(std::span<const double> action);

  /// How long the last step took: a hint how to share out the next ones, of which no result
  /// depends.
  std::chrono::steady_clock::duration last_step_time{};

 private:
  StepResult Measure(const sim::Simulation& simulation);
  void AppendRobot(const sim::Simulation& simulation, std::vector<double>* out) const;
  void AppendObjects(const sim::Simulation& simulation, std::vector<double>* out) const;
  void AppendMechanisms(const sim::Simulation& simulation, std::vector<double>* out) const;

  Handle& handle_;
  std::shared_ptr<const model::Model> model_;
  std::shared_ptr<const task::GoalSpace> space_;
  Control control_;
  std::vector<model::ObjectIndex> objects_;
  std::size_t observer_ = 0;
  std::vector<double> desired_;
  task::GoalComparer comparer_;
};

}  // namespace smile::python
