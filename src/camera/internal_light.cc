#include "camera/internal_light.h"

#include <cmath>

namespace smile::camera::internal {

Vector3 LightColor(const scene::Lighting& lighting) {
  const Color& color = lighting.color;
  return lighting.brightness * Vector3(color.red, color.green, color.blue);
}

Vector3 DirectionToLamp(const scene::Lighting& lighting) {
  constexpr double kX = -0.45, kY = -0.5;
  const double c = std::cos(lighting.turn), s = std::sin(lighting.turn);
  return Vector3(c * kX - s * kY, s * kX + c * kY, 1.0).normalized();
}

}  // namespace smile::camera::internal
