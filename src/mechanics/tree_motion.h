#pragma once

#include <span>
#include <vector>

#include "math/rigid_transform.h"

namespace smile::mechanics {

/// Link of a tree on a fixed base, where it is now. Its frame has the center of mass as origin and
/// the principal axes of inertia as axes; all vectors are in that frame.
struct TreeLink {
  int parent = -1;                     ///< index of a link before it; -1: the base
  Matrix3 R_LP = Matrix3::Identity();  ///< turns vectors from the parent's frame to this one
  Vector3 p_PL = Vector3::Zero();      ///< from the parent's center of mass to its own [m]
  Vector3 p_JL = Vector3::Zero();      ///< from its joint to its center of mass [m]
  Vector3 axis = Vector3::UnitZ();     ///< of the joint, unit
  bool is_revolute = true;             ///< otherwise it slides along the axis
  double mass = 0;                     ///< [kg]
  Vector3 inertia = Vector3::Zero();   ///< principal moments [kg m2]
};

/// Range of velocities of a joint [rad/s or m/s].
struct JointSpeeds {
  double least = 0, most = 0;
};

/// What the motor of a joint is to do in a step.
struct JointGoal {
  double v = 0;            ///< velocity now [rad/s or m/s]
  double wanted = 0;       ///< velocity at the end; of a follower: beyond that of its leader
  JointSpeeds allowed;     ///< by its limits
  double max_impulse = 0;  ///< of its motor [N m s or N s]; followers have none
  int leader = -1;         ///< joint that it follows; -1: none
  double ratio = 1;        ///< of its velocity to the leader's
};

/// Motion of a tree of links in a step in which nothing touches it and gravity is compensated: its
/// joints do exactly what is wanted of them, if the motors are strong enough.
class TreeMotion {
 public:
  /// One for each link; links before their children.
  std::vector<TreeLink> links;
  std::vector<JointGoal> goals;

  /// Returns false if a limit or a motor prevents it.
  bool Solve(double seconds);
  /// Velocities of the joints at the end of the step, after Solve() [rad/s or m/s].
  std::span<const double> velocities() const { return next_; }

  /// Computes the efforts of the joints [N m or N] that accelerate them so [rad/s2 or m/s2],
  /// without gravity (recursive Newton-Euler algorithm: R. Featherstone, Rigid Body Dynamics
  /// Algorithms, chapter 5).
  std::span<const double> EffortsFor(std::span<const double> accelerations);

 private:
  /// Motion of a link, and the force and torque on it, at its center of mass.
  struct LinkState {
    Vector3 w, w_dot;  ///< angular velocity and acceleration
    Vector3 a;         ///< acceleration of the center of mass
    Vector3 force, torque;
  };

  std::vector<LinkState> states_;
  std::vector<double> next_, accelerations_, efforts_;
};

}  // namespace smile::mechanics
