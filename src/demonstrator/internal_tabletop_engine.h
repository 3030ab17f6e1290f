#pragma once

#include "demonstrator/engine.h"
#include "world/refusal_names.h"
#include "world/tabletop.h"

namespace smile::demonstrator {

/// Our physics as the engine behind the hands. It has no state of its own.
class TabletopEngine : public Engine {
 public:
  /// Both must outlive this.
  TabletopEngine(physics::World* world, const world::Tabletop* tabletop)
      : world_(*world), tabletop_(*tabletop) {}

  double step_seconds() const override { return world_.config().step_seconds; }
  std::optional<world::Refusal> RefuseToReach(std::string_view object_id) const override {
    return tabletop_.RefuseToReach(object_id);
  }
  std::optional<world::Refusal> RefuseToCarry(physics::BodyId id) const override {
    const physics::Body& body = world_.body(id);
    if (body.is_static()) {
      return texts::Say("world.isFixed", {{"object", world::ObjectName(ObjectOf(id))}});
    }
    if (body.is_carried()) {
      return texts::Say("world.heldByRobot", {{"object", world::ObjectName(ObjectOf(id))}});
    }
    return std::nullopt;
  }
  physics::BodyId BodyOf(std::string_view object_id) const override {
    return tabletop_.Find(object_id)->body;
  }
  std::string ObjectOf(physics::BodyId body) const override { return tabletop_.Find(body)->id(); }
  BodyMotion MotionOf(physics::BodyId id) const override {
    const physics::Body& body = world_.body(id);
    return {body.pose_in_world(), body.linear_velocity(), body.angular_velocity()};
  }
  void SetCarried(physics::BodyId body, bool is_carried) override {
    world_.body(body).SetCarried(is_carried);
  }
  void SetVelocity(physics::BodyId body, const Vector3& v_WB, const Vector3& w_WB) override {
    world_.body(body).SetVelocity(v_WB, w_WB);
  }

 private:
  physics::World& world_;
  const world::Tabletop& tabletop_;
};

}  // namespace smile::demonstrator
