#include "model/robot_placement.h"

namespace smile::model {

RigidTransform RobotBasePose(const scene::TableSpec& table, double gap, double height) {
  Matrix3 R_WBase;  // forward is the table's y, left its -x
  R_WBase << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  return {R_WBase, Vector3(0, -table.y_span / 2 - gap, height)};
}

}  // namespace smile::model
