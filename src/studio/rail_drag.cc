#include "studio/rail_drag.h"

#include <algorithm>
#include <cmath>

namespace smile::studio {
namespace {

/// Returns the slider whose second member this body is; nullptr without one.
const physics::SliderJointSpec* RailOf(physics::BodyId body, const physics::World& world) {
  for (const physics::Joint& joint : world.joints()) {
    const auto* slider = std::get_if<physics::SliderJointSpec>(&joint.spec);
    if (slider != nullptr && slider->b == body) return slider;
  }
  return nullptr;
}

/// Returns where the second member is along +x of the rail [m].
double OffsetOn(const physics::SliderJointSpec& rail, const physics::World& world) {
  const RigidTransform X_WJ = world.body(rail.a).pose_in_world() * rail.X_AJ;
  const RigidTransform X_WK = world.body(rail.b).pose_in_world() * rail.X_BK;
  return X_WJ.rotation().col(0).dot(X_WK.translation() - X_WJ.translation());
}

/// Returns the distance from `p` along `u` to the point nearest to the ray; nullopt if both are
/// nearly parallel.
std::optional<double> NearestAlong(const Vector3& p, const Vector3& u, const sim::Drag& drag) {
  constexpr double kLeastSine = 0.17;  // of 10 degrees
  const Vector3 d = drag.direction_in_world.normalized();
  const Vector3 from_origin = p - drag.p_WOrigin;
  // The shortest line between two lines is perpendicular to both: two equations for the distances
  // along them, of which the ray's is eliminated.
  const double cosine = u.dot(d), sine_squared = 1 - cosine * cosine;
  if (!(sine_squared > kLeastSine * kLeastSine)) return std::nullopt;
  return (cosine * d.dot(from_origin) - u.dot(from_origin)) / sine_squared;
}

}  // namespace

bool IsOnRail(physics::BodyId body, const physics::World& world) {
  return RailOf(body, world) != nullptr;
}

physics::BodyId FindSlidingOn(physics::BodyId base, const physics::World& world) {
  constexpr double kAtEnd = 0.005;  // [m]
  for (const physics::Joint& joint : world.joints()) {
    const auto* slider = std::get_if<physics::SliderJointSpec>(&joint.spec);
    // Scenes count offsets along -x of the rail: things open toward the lower limit.
    if (slider != nullptr && slider->a == base &&
        OffsetOn(*slider, world) > slider->lower + kAtEnd) {
      return slider->b;
    }
  }
  return {};
}

std::optional<sim::MoveTo> MoveAlongRail(const sim::Drag& drag, const sim::Simulation& simulation) {
  const demonstrator::Hand& hand = simulation.demonstrator().hand(drag.hand);
  const physics::World& world = simulation.physics();
  const physics::SliderJointSpec* rail = hand.is_holding() ? RailOf(hand.held, world) : nullptr;
  if (rail == nullptr) return std::nullopt;
  const RigidTransform X_WJ = world.body(rail->a).pose_in_world() * rail->X_AJ;
  const RigidTransform X_WB = world.body(rail->b).pose_in_world();
  const Vector3 u = X_WJ.rotation().col(0);
  const Vector3 p_WH = X_WB * hand.p_BH;
  const Vector3 p_WH_goal = hand.X_WB_goal * hand.p_BH;
  // The hand goes along the line through the grasped point, as far as the rail allows.
  const double offset = OffsetOn(*rail, world);
  const double wanted = NearestAlong(p_WH, u, drag).value_or(u.dot(p_WH_goal - p_WH));
  const double distance = std::clamp(wanted, rail->lower - offset, rail->upper - offset);
  return sim::MoveTo{.hand = drag.hand, .p_WH = p_WH + distance * u, .speed = drag.speed};
}

}  // namespace smile::studio
