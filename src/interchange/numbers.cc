#include "interchange/numbers.h"

#include <numbers>

#include "base/wording.h"

namespace smile::interchange {

std::string Numbers(std::initializer_list<double> numbers) {
  std::string text;
  // Adding 0 makes -0 a plain 0.
  for (const double number : numbers) text += (text.empty() ? "" : " ") + NumberText(number + 0.0);
  return text;
}

std::string Numbers(const Vector3& v) { return Numbers({v.x(), v.y(), v.z()}); }

RigidTransform CylinderAlongZ() {
  return {Quaternion(Eigen::AngleAxisd(-std::numbers::pi / 2, Vector3::UnitX())), Vector3::Zero()};
}

}  // namespace smile::interchange
