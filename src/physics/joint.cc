#include "physics/joint.h"

#include "base/overloaded.h"

namespace smile::physics {

bool Joins(const JointSpec& spec, BodyId body) {
  return std::visit(
      Overloaded{[body](const WeldSpec& weld) { return weld.body == body; },
                 [body](const auto& pair) { return pair.a == body || pair.b == body; }},
      spec);
}

}  // namespace smile::physics
