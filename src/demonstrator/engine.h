#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "math/rigid_transform.h"
#include "mechanics/ids.h"
#include "world/refusal.h"

namespace smile::demonstrator {

/// Where a body is, and how it moves.
struct BodyMotion {
  RigidTransform X_WB;
  Vector3 v_WB = Vector3::Zero();  ///< of the origin [m/s]
  Vector3 w_WB = Vector3::Zero();  ///< [rad/s]
};

/// Physics engine behind the hands: everything that hands need of the simulator that moves bodies.
/// Ours is an Engine, and a simulator in Python can be one (python/smile/adapters).
///
/// Ids of bodies are above 0 and valid while RefuseToReach() returns nothing for their objects.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Returns the duration of a physics step [s].
  virtual double step_seconds() const = 0;
  /// Returns the reason why no hand can reach an object, as when it does not exist.
  virtual std::optional<world::Refusal> RefuseToReach(std::string_view object_id) const = 0;
  /// Returns the reason why a hand cannot carry a body that no hand holds.
  virtual std::optional<world::Refusal> RefuseToCarry(mechanics::BodyId body) const = 0;
  /// Returns the body of an object that can be reached.
  virtual mechanics::BodyId BodyOf(std::string_view object_id) const = 0;
  /// Returns the id of a body's object.
  virtual std::string ObjectOf(mechanics::BodyId body) const = 0;
  virtual BodyMotion MotionOf(mechanics::BodyId body) const = 0;

  /// Marks a body as carried, so that it weighs nothing, or as no longer carried.
  virtual void SetCarried(mechanics::BodyId body, bool is_carried) = 0;
  /// Sets v_WB of the origin [m/s] and w_WB [rad/s].
  virtual void SetVelocity(mechanics::BodyId body, const Vector3& v_WB, const Vector3& w_WB) = 0;
};

}  // namespace smile::demonstrator
