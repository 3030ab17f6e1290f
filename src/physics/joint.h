#pragma once

#include <limits>
#include <variant>
#include <vector>

#include "math/rigid_transform.h"
#include "physics/ids.h"

namespace smile::physics {

/// Holds a body in a fixed place on a link of an articulation, as a gripper holds a block. The body
/// is carried (weightless) and does not collide with the links that are listed. What a kinematic
/// link holds moves as it does: it pushes others, and nothing pushes it.
struct WeldSpec {
  ArticulationId articulation;
  int link = -1;
  BodyId body;
  RigidTransform X_LB;
  std::vector<int> links_not_colliding;
  /// So much of the body's mass is held up for the articulation [kg]. Its motors feel the weight of
  /// the rest, and have just their listed effort then.
  double holds_up = std::numeric_limits<double>::infinity();

  bool operator==(const WeldSpec&) const = default;
};

/// Holds body B in a fixed place on body A. The two do not collide.
struct FixedJointSpec {
  BodyId a, b;
  RigidTransform X_AB;

  bool operator==(const FixedJointSpec&) const = default;
};

/// Lets B slide along a rail of A and do nothing else: frame K of B stays on the x axis of frame J
/// of A, turned like it. The offset is K's x in J.
struct SliderJointSpec {
  BodyId a, b;
  RigidTransform X_AJ, X_BK;
  double lower = 0, upper = 0;  ///< limits of the offset [m]
  bool do_collide = false;
  /// Share of the sliding speed lost in a second, by equal and opposite forces on both: 0 slides
  /// freely, 1 stays where it is put. While one of the two is carried, the other is free.
  double damping = 0;
  double restitution = 0;  ///< share of the speed with which it comes back from a limit
  /// Share of the way from the middle to a limit that is free; beyond it, the speed towards the
  /// limit is taken away more and more. 1: a hard stop.
  double softness = 1;

  bool operator==(const SliderJointSpec&) const = default;
};

/// Holds a point of B on a point of A; both turn freely about it. The two do not collide.
struct BallJointSpec {
  BodyId a, b;
  Vector3 p_AQ = Vector3::Zero(), p_BQ = Vector3::Zero();

  bool operator==(const BallJointSpec&) const = default;
};

using JointSpec = std::variant<WeldSpec, FixedJointSpec, SliderJointSpec, BallJointSpec>;

/// A joint between two things of a World.
struct Joint {
  JointId id;
  JointSpec spec;

  bool operator==(const Joint&) const = default;
};

/// True when the body is one of those the joint holds together.
bool Joins(const JointSpec& spec, BodyId body);

}  // namespace smile::physics
