#pragma once

#include <initializer_list>
#include <string>

#include "math/rigid_transform.h"

namespace smile::interchange {

/// Returns numbers as text with blanks between them, each the shortest that reads back the same; -0
/// is 0.
std::string Numbers(std::initializer_list<double> numbers);
std::string Numbers(const Vector3& v);

/// Returns the rotation from the axes of SMILE's cylinders, which lie along y, to those of formats
/// whose cylinders lie along z.
RigidTransform CylinderAlongZ();

}  // namespace smile::interchange
