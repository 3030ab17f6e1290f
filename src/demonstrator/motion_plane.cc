#include "demonstrator/motion_plane.h"

#include <cmath>
#include <utility>

#include "math/angles.h"

namespace smile::demonstrator {

using texts::Say;

namespace {

Vector3 NormalOf(const MotionPlane& plane) {
  const double angle = DegreesToRadians(plane.angle_deg);
  return plane.is_level ? Vector3::UnitZ() : Vector3(-std::sin(angle), std::cos(angle), 0);
}

Refusal NameOf(const MotionPlane& plane, HandName hand) {
  return plane.is_level ? Say("hands.levelPlane", {{"hand", ToString(hand)}})
                        : Say("hands.motionPlane", {{"hand", ToString(hand)}});
}

}  // namespace

std::optional<Vector3> MeetPlane(HandName name, const Hand& hand, const MotionPlane& plane,
                                 const Ray& ray, Refusal* refusal) {
  constexpr double kParallel = 1e-9, kFar = 100;  // sine of an angle, [m]
  const auto no = [refusal](Refusal why) {
    *refusal = std::move(why);
    return std::nullopt;
  };
  // Directions of any length come from clients; a zero or infinite one has no norm of 1.
  const Vector3 direction = ray.direction_in_world.stableNormalized();
  if (!(direction.norm() > 0.5)) return no(Say("hands.rayWithoutDirection"));
  const Vector3 normal = NormalOf(plane);
  const double approach = normal.dot(direction);
  if (!(std::abs(approach) > kParallel)) {
    return no(Say("hands.rayIsParallel", {{"plane", NameOf(plane, name)}}));
  }
  // Through the goal and not the body, which lags behind: the plane must not move while people
  // drag.
  const Vector3 p_WH = hand.X_WB_goal * hand.p_BH;
  const double distance = normal.dot(p_WH - ray.p_WOrigin) / approach;
  if (!(distance >= 0)) return no(Say("hands.rayPointsAway", {{"plane", NameOf(plane, name)}}));
  const Vector3 p_WHit = ray.p_WOrigin + distance * direction;
  if (!(distance <= kFar)) {
    return no(Say("hands.rayMeetsFar", {{"plane", NameOf(plane, name)}}));
  }
  return p_WHit;
}

}  // namespace smile::demonstrator
