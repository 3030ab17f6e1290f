#include "interchange/exported_text.h"

#include <algorithm>

namespace smile::interchange {

bool HasUnequalFriction(const ExportedWorld& world) {
  return std::ranges::any_of(world.bodies, [&](const ExportedBody& body) {
    return body.spec.friction != world.bodies.front().spec.friction;
  });
}

}  // namespace smile::interchange
