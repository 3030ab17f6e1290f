#pragma once

#include "math/rigid_transform.h"

namespace smile {

/// Axes along which an inertia tensor is diagonal, and its diagonal. Already diagonal tensors keep
/// their axes, so that a plain block is not turned.
struct PrincipalInertia {
  Matrix3 axes = Matrix3::Identity();  ///< R_BA, columns are the axes in B
  Vector3 moments = Vector3::Zero();   ///< [kg m2]
};
PrincipalInertia PrincipalInertiaOf(const Matrix3& inertia);

}  // namespace smile
