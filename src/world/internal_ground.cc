#include "world/internal_ground.h"

#include "world/tabletop.h"

namespace smile::world {

scene::Solid FloorSolid() {
  // In meters: large enough that nothing rolls off it, thick enough that nothing falls through it.
  constexpr double kSpan = 40, kThickness = 1;
  return {.shape = scene::Block{{kSpan, kSpan, kThickness}},
          .X_BS = RigidTransform(Vector3(0, 0, -kFloorDepth - kThickness / 2)),
          .color = {},
          .part_id = "floor"};
}

}  // namespace smile::world
