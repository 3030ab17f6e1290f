#include "scene/internal_lights.h"

namespace smile::scene {

Cylinder DiscOf(const IndicatorLights& lights) {
  return {.radius = lights.light_radius, .length = lights.light_height};
}

RigidTransform PoseOfLight(const IndicatorLights& lights, int number) {
  Matrix3 R_EDisc;  // the disc's y is the row's z
  R_EDisc << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const double radius = lights.light_radius;
  // The outermost lamps end at the ends of the row; a single one is in its middle.
  const double x = lights.num_lights < 2
                       ? 0
                       : -lights.x_span / 2 + radius +
                             number * (lights.x_span - 2 * radius) / (lights.num_lights - 1);
  return {R_EDisc, Vector3(x, 0, lights.light_height / 2)};
}

}  // namespace smile::scene
