#include "robot/robot_visuals.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "robot/kinematics.h"

namespace smile::robot {

void AppendVisuals(const RobotModel& model, int first_frame, std::uint32_t object_id,
                   scene::VisualModel* visual_model) {
  // The caller decides where the robot's frames begin; these checks find mistakes of programs.
  if (first_frame < 1) {
    throw std::invalid_argument("first_frame is " + std::to_string(first_frame) +
                                ", expected at least 1: frame 0 is the world");
  }
  if (object_id == 0 || object_id >= visual_model->object_names.size()) {
    throw std::invalid_argument("object_id is " + std::to_string(object_id) +
                                ", expected the index of a named object");
  }
  // One choice for the face: its variants are the face expressions. All other visuals are always
  // visible.
  const int choice = visual_model->num_choices++;
  for (const LinkVisual& visual : model.visuals) {
    visual_model->visuals.push_back(
        {.shape = visual.shape,
         .color = visual.color,
         .X_FV = visual.X_LV,
         .frame = first_frame + VisualFrameOf(visual.link),
         .object_id = object_id,
         .choice = visual.face_expression ? choice : -1,
         .variant = visual.face_expression ? VariantOf(*visual.face_expression) : 0,
         .glows = visual.face_expression.has_value()});  // the face is a screen
  }
  visual_model->num_frames =
      std::max(visual_model->num_frames, first_frame + NumVisualFrames(model));
}

scene::FramePoses FramePosesOf(const RobotModel& model, const RigidTransform& X_WBase,
                               std::span<const double> q) {
  // The base first, then the links: VisualFrameOf() counts in this order.
  scene::FramePoses poses = LinkPoses(model, X_WBase, q);
  poses.insert(poses.begin(), X_WBase);
  return poses;
}

}  // namespace smile::robot
