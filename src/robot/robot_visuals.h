#pragma once

#include <cstdint>
#include <span>

#include "robot/robot_model.h"
#include "scene/visual_model.h"

namespace smile::robot {

/// Returns the number of frames of a VisualModel that a robot takes: the base, then each link in
/// the order of `model.links`.
inline int NumVisualFrames(const RobotModel& model) { return 1 + model.num_joints(); }
/// Returns the index of a link's frame among these; `link` is -1 for the base, as in Frame and
/// LinkVisual.
inline int VisualFrameOf(int link) { return 1 + link; }

/// Appends the visuals of a robot, as NumVisualFrames() frames from `first_frame` on. Its face
/// expression is one more choice, whose variants are numbered as kFaceExpressions; see VariantOf().
///
/// @param first_frame  at least 1, since frame 0 is the world; `visual_model->num_frames` grows to
///                     include the robot's frames if necessary.
/// @param object_id    id of the robot's pixels, an index into `visual_model->object_names`.
/// @throws std::invalid_argument if the frame or the id is out of range.
void AppendVisuals(const RobotModel& model, int first_frame, std::uint32_t object_id,
                   scene::VisualModel* visual_model);

/// Returns the value of the choice that AppendVisuals() added for a face expression.
inline int VariantOf(FaceExpression expression) { return static_cast<int>(expression); }

/// Returns the poses X_WF of the frames that AppendVisuals() made: the base, then each link.
/// @throws std::invalid_argument if `q` has the wrong size.
scene::FramePoses FramePosesOf(const RobotModel& model, const RigidTransform& X_WBase,
                               std::span<const double> q);

}  // namespace smile::robot
