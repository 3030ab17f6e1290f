#pragma once

#include <string>

#include "math/angles.h"
#include "model/test/placed_objects.h"
#include "task/course.h"
#include "task/structure.h"

namespace smile::task {

// Structures and outcomes without physics.

using model::CubeAt;
using model::ObjectAt;

inline recording::TracePose TracePoseAt(const RigidTransform& X_WB) {
  const Quaternion q = X_WB.quaternion();
  return {.position = X_WB.translation(), .rotation = {q.w(), q.x(), q.y(), q.z()}};
}

/// Nothing is touched in it.
inline Course CourseBetween(const std::vector<scene::ObjectSpec>& start,
                            const std::vector<scene::ObjectSpec>& end) {
  Course course;
  course.scene.name = "elsewhere";
  course.scene.objects = start;
  for (const auto& object : start) {
    course.begin.objects.push_back(TracePoseAt(object.pose_in_world()));
  }
  for (const auto& object : end) {
    course.end.objects.push_back(TracePoseAt(object.pose_in_world()));
  }
  return course;
}

/// A course that ends with these objects, which all began far off.
inline Course CourseTo(const std::vector<scene::ObjectSpec>& end) {
  std::vector<scene::ObjectSpec> start = end;
  double x = -0.9;
  for (scene::ObjectSpec& object : start) {
    if (object.is_static()) continue;
    object.whole.X_PE = RigidTransform(Vector3(x += 0.15, -0.5, 0.05));
  }
  return CourseBetween(start, end);
}

inline std::vector<scene::ObjectSpec> Moved(std::vector<scene::ObjectSpec> objects,
                                            double angle_deg, const Vector3& shift) {
  const RigidTransform motion(RotationFromFixedAxes({0, 0, angle_deg}), shift);
  for (scene::ObjectSpec& object : objects) {
    object.whole.X_PE = motion * object.pose_in_world();
  }
  return objects;
}

/// A gripper carries an object from there to here.
inline void Carry(const std::string& object, const RigidTransform& from, const RigidTransform& to,
                  Course* course) {
  using enum sim::EventKind;
  course->touches.push_back({{.kind = kGripperHolds, .arm = "left", .object = object}, 1, from});
  course->touches.push_back({{.kind = kGripperLetGo, .arm = "left", .object = object}, 2, to});
}

}  // namespace smile::task
