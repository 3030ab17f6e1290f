#pragma once

#include <memory>
#include <vector>

#include "model/control.h"
#include "model/model.h"
#include "physics/definitions.h"
#include "robot/face_expression.h"
#include "scene/visual_model.h"

namespace smile::sim {

class RunningModel;

/// Visual state of a running model, kept from one query to the next.
///
/// It always equals what Model::VisualStateOf() computes, but a query writes only what may have
/// changed since the last one: it takes a time that does not depend on the objects that sleep. It
/// is no part of the simulation's state.
class VisualStateCache {
 public:
  /// Keeps a reference to `running`, which may still be under construction.
  explicit VisualStateCache(const RunningModel* running) : running_(*running) {}
  VisualStateCache(const VisualStateCache&) = delete;
  VisualStateCache& operator=(const VisualStateCache&) = delete;

  /// Returns the present visual state. The next call changes it in place.
  const scene::VisualState& Update();

 private:
  /// State of the robot that is visible.
  struct VisibleRobot {
    std::vector<double> q;
    robot::FaceExpression face_expression = robot::FaceExpression::kIdle;

    bool operator==(const VisibleRobot&) const = default;
  };

  VisibleRobot RobotNow() const;
  void ComputeAnew();
  void WriteChanged();

  const RunningModel& running_;
  scene::VisualState visual_;
  // What visual_ was written from.
  std::shared_ptr<const model::Model> model_;  ///< null before the first query
  physics::Moment moment_;                     ///< of the bodies
  std::vector<model::ControlState> controls_;
  VisibleRobot robot_;
};

}  // namespace smile::sim
