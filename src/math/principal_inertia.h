#pragma once

#include "math/rigid_transform.h"

namespace smile {

/// Principal axes and moments of an inertia tensor. Tensors that are already diagonal keep their
/// axes, so that a plain block is not rotated.
struct PrincipalInertia {
  Matrix3 axes = Matrix3::Identity();  ///< R_BA, columns are the axes in B
  Vector3 moments = Vector3::Zero();   ///< [kg m2]
};
PrincipalInertia PrincipalInertiaOf(const Matrix3& inertia);

}  // namespace smile
