#include "world/internal_ground.h"

#include "world/tabletop.h"

namespace smile::world {

scene::Solid TableSolid(const scene::TableSpec& table) {
  return {.shape = scene::Block{{table.x_span, table.y_span, table.thickness}},
          .X_BS = RigidTransform(Vector3(0, 0, -table.thickness / 2)),
          .color = {1, 1, 1},
          .part_id = "table"};
}

scene::Solid FloorSolid() {
  constexpr double kSpan = 40, kThickness = 1;
  return {.shape = scene::Block{{kSpan, kSpan, kThickness}},
          .X_BS = RigidTransform(Vector3(0, 0, -kFloorDepth - kThickness / 2)),
          .color = {},
          .part_id = "floor"};
}

}  // namespace smile::world
