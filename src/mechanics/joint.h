#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "base/overloaded.h"
#include "math/rigid_transform.h"
#include "mechanics/ids.h"

namespace smile::mechanics {

/// Weld: holds a body in a fixed place on a link of an articulation, as a gripper holds a block.
/// The body is carried (weightless) and does not collide with the listed links. A body on a
/// kinematic link moves with it: it pushes others and is not pushed.
struct WeldSpec {
  ArticulationId articulation;
  int link = -1;
  BodyId body;
  RigidTransform X_LB;
  std::vector<int> links_not_colliding;
  /// Mass of the body that is held up for the articulation [kg]. Its motors feel the weight of the
  /// rest, and then have only their listed effort.
  double holds_up = std::numeric_limits<double>::infinity();

  bool operator==(const WeldSpec&) const = default;
};

/// Fixed joint: holds body B in a fixed place on body A. The two do not collide.
struct FixedJointSpec {
  BodyId a, b;
  RigidTransform X_AB;

  bool operator==(const FixedJointSpec&) const = default;
};

/// Slider: B moves along a rail of A only. Frame K of B stays on the x axis of frame J of A, with
/// the same orientation. The offset is K's x in J.
struct SliderJointSpec {
  BodyId a, b;
  RigidTransform X_AJ, X_BK;
  double lower = 0, upper = 0;  ///< limits of the offset [m]
  bool do_collide = false;
  /// Fraction of the sliding speed lost per second, by equal and opposite forces on both: 0 slides
  /// freely, 1 stays at its offset. While one of the two is carried, the other is free.
  double damping = 0;
  double restitution = 0;  ///< fraction of the speed kept in a rebound from a limit
  /// Fraction of the distance from the middle to a limit that is free; beyond it, the speed towards
  /// the limit is reduced progressively. 1: a hard stop.
  double softness = 1;

  bool operator==(const SliderJointSpec&) const = default;
};

/// Ball joint: holds a point of B on a point of A; both rotate freely about it. The two do not
/// collide.
struct BallJointSpec {
  BodyId a, b;
  Vector3 p_AQ = Vector3::Zero(), p_BQ = Vector3::Zero();

  bool operator==(const BallJointSpec&) const = default;
};

using JointSpec = std::variant<WeldSpec, FixedJointSpec, SliderJointSpec, BallJointSpec>;

/// Joint of a World.
struct Joint {
  JointId id;
  JointSpec spec;

  bool operator==(const Joint&) const = default;
};

/// Returns the two bodies that a joint holds together; nothing for a weld, which holds one body on
/// a link.
inline std::optional<std::pair<BodyId, BodyId>> BodyPairOf(const JointSpec& spec) {
  using Pair = std::optional<std::pair<BodyId, BodyId>>;
  return std::visit(
      Overloaded{[](const WeldSpec&) -> Pair { return {}; },
                 [](const auto& joint) -> Pair { return std::pair(joint.a, joint.b); }},
      spec);
}

/// Returns false if the bodies of the joint pass through each other while it exists.
inline bool DoCollide(const JointSpec& spec) {
  const auto* slider = std::get_if<SliderJointSpec>(&spec);
  return slider != nullptr && slider->do_collide;
}

/// Returns true if the joint holds this body.
inline bool Joins(const JointSpec& spec, BodyId body) {
  return std::visit(
      Overloaded{[body](const WeldSpec& weld) { return weld.body == body; },
                 [body](const auto& pair) { return pair.a == body || pair.b == body; }},
      spec);
}

}  // namespace smile::mechanics
