#include "sim/visual_state_cache.h"

#include <utility>

#include "sim/running_model.h"

// The visual state follows from the model, the bodies, the states of controls and the robot. Of
// these only the bodies are too many to be compared: the physics world reports those that may have
// changed. A body that is gone is not among them.

namespace smile::sim {

const scene::VisualState& VisualStateCache::Update() {
  // Objects are rarely added or removed.
  const bool is_other_scene = model_ != running_.model();
  if (is_other_scene || running_.physics().HasRemovedSince(moment_)) {
    ComputeAnew();
  } else {
    WriteChanged();
  }
  moment_ = running_.physics().now();
  return visual_;
}

void VisualStateCache::ComputeAnew() {
  model_ = running_.model();
  controls_ = running_.tabletop().controls().states();
  robot_ = RobotNow();
  visual_ =
      model_->VisualStateOf(running_.tabletop().scene_state(), robot_.q, robot_.face_expression);
}

void VisualStateCache::WriteChanged() {
  const world::Tabletop& tabletop = running_.tabletop();
  const std::vector<model::ControlState>& controls = tabletop.controls().states();
  std::vector<model::ObjectIndex> changed;
  if (controls_ != controls) {
    for (model::ControlIndex control : model_->controls()) {
      if (controls_[control] != controls[control]) {
        changed.push_back(model_->control(control).object);
      }
    }
    controls_ = controls;
  }
  for (physics::BodyId body : running_.physics().BodiesChangedSince(moment_)) {
    // The others are the table and the floor.
    if (const world::Object* object = tabletop.Find(body)) changed.push_back(object->index);
  }
  for (model::ObjectIndex object : changed) {
    model_->WriteObject(object, tabletop.PoseOf(tabletop.objects()[object]), controls_, &visual_);
  }
  if (model_->robot() == nullptr) return;
  VisibleRobot robot = RobotNow();
  if (robot == robot_) return;
  robot_ = std::move(robot);
  model_->WriteRobot(robot_.q, robot_.face_expression, &visual_);
}

VisualStateCache::VisibleRobot VisualStateCache::RobotNow() const {
  const SimulatedRobot* robot = running_.robot();
  if (robot == nullptr) return {};
  return {.q = robot->body().positions(), .face_expression = robot->face_expression()};
}

}  // namespace smile::sim
