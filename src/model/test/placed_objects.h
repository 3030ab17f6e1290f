#pragma once

#include <string>
#include <utility>

#include "math/angles.h"
#include "scene/scene_spec.h"

namespace smile::model {

inline scene::ObjectSpec ObjectAt(std::string id, const scene::Shape& shape, const Vector3& p,
                                  const Color& color = {}, double yaw_deg = 0) {
  return {.whole = {.id = std::move(id),
                    .X_PE = RigidTransform(RotationFromFixedAxes({0, 0, yaw_deg}), p),
                    .color = color,
                    .shape = shape}};
}

inline scene::ObjectSpec CubeAt(std::string id, const Vector3& p, const Color& color = {}) {
  return ObjectAt(std::move(id), scene::Block{}, p, color);
}

}  // namespace smile::model
