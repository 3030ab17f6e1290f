#pragma once

#include "math/rigid_transform.h"

namespace smile::impulses {

/// Rigid body of an island, in the world's frame.
struct Body {
  double inverse_mass = 0;                    ///< [1/kg]; 0 for a body that does not answer
  Matrix3 inverse_inertia = Matrix3::Zero();  ///< about its center of mass [1/(kg m2)]
  Vector3 p_WBcm = Vector3::Zero();           ///< center of mass [m]
  Vector3 v = Vector3::Zero();                ///< of the center when the step begins [m/s]
  Vector3 w = Vector3::Zero();                ///< then [rad/s]
  Vector3 forced_v = Vector3::Zero();         ///< what forces add in this step [m/s]
  Vector3 forced_w = Vector3::Zero();         ///< [rad/s]
  /// What impulses add to the velocities in this step, three numbers each. They belong to the
  /// caller: other constraints change them, too, between sweeps.
  double* change_of_v = nullptr;
  double* change_of_w = nullptr;

  bool is_movable() const { return inverse_mass != 0; }
};

inline Eigen::Map<Vector3> ChangeOfV(const Body& body) {
  return Eigen::Map<Vector3>(body.change_of_v);
}
inline Eigen::Map<Vector3> ChangeOfW(const Body& body) {
  return Eigen::Map<Vector3>(body.change_of_w);
}

}  // namespace smile::impulses
