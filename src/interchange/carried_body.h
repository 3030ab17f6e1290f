#pragma once

#include <span>

#include "interchange/exported_world.h"

namespace smile::interchange {

/// Slider as formats describe it that have trees of bodies: by its child B.
struct CarriedSlide {
  Vector3 axis_in_child;  ///< unit vector, along which the child slides on its parent
  double offset = 0;      ///< present position [m]
  double damping = 0;     ///< force against the motion [N s/m]
};

/// Returns the slider of a joint whose child is one of its two bodies.
CarriedSlide SlideOf(const ExportedWorld& world, const ExportedJoint& joint, int child);

/// Returns the pose of a robot's link L in its parent P with its joint at `q` [rad or m].
RigidTransform PoseInParent(const scene::LinkSpec& link, double q);

/// Returns the present pose of each of the robot's links in the world.
std::vector<RigidTransform> LinkPosesOf(const ExportedRobot& robot);

}  // namespace smile::interchange
