#include "demonstrator/servo.h"

#include <algorithm>

#include "math/angles.h"

namespace smile::demonstrator {
namespace {

/// Returns a vector shortened to a length.
Vector3 Limited(const Vector3& v, double max_length) {
  const double length = v.norm();
  // Scales the whole vector: limits per axis would bend the path.
  return length > max_length ? Vector3(v * (max_length / length)) : v;
}

}  // namespace

void DriveTowards(const RigidTransform& X_WB_goal, double speed, const ServoConfig& config,
                  mechanics::BodyId body, Engine* engine) {
  const auto [X_WB, v, w] = engine->MotionOf(body);
  // Position and rotation are driven independently: a blocked rotation does not stop the
  // translation.
  const Vector3 gap = X_WB_goal.translation() - X_WB.translation();
  const Vector3 turn = RotationVectorBetween(X_WB.quaternion(), X_WB_goal.quaternion());

  // Proportional to the error near the goal, limited farther away.
  const Vector3 v_wanted =
      Limited(gap / config.response_seconds, std::min(speed, config.max_speed));
  const Vector3 w_wanted = Limited(turn / config.response_seconds, config.max_angular_speed);
  // The change per step is limited, that is, force per mass: a blocked object pushes no harder
  // however far away its goal is.
  const double step_seconds = engine->step_seconds();
  engine->SetVelocity(body, v + Limited(v_wanted - v, config.max_acceleration * step_seconds),
                      w + Limited(w_wanted - w, config.max_angular_acceleration * step_seconds));
}

}  // namespace smile::demonstrator
