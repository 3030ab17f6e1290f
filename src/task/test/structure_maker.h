#pragma once

#include <string>

#include "math/angles.h"
#include "model/test/placed_objects.h"
#include "task/episode.h"
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
inline Episode EpisodeBetween(const std::vector<scene::ObjectSpec>& start,
                              const std::vector<scene::ObjectSpec>& end) {
  Episode episode;
  episode.scene.name = "elsewhere";
  episode.scene.objects = start;
  for (const auto& object : start) {
    episode.begin.objects.push_back(TracePoseAt(object.pose_in_world()));
  }
  for (const auto& object : end) {
    episode.end.objects.push_back(TracePoseAt(object.pose_in_world()));
  }
  return episode;
}

/// Returns an episode that ends with these objects, which all began far away.
inline Episode EpisodeTo(const std::vector<scene::ObjectSpec>& end) {
  std::vector<scene::ObjectSpec> start = end;
  double x = -0.9;
  for (scene::ObjectSpec& object : start) {
    if (object.is_static()) continue;
    object.whole.X_PE = RigidTransform(Vector3(x += 0.15, -0.5, 0.05));
  }
  return EpisodeBetween(start, end);
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
                  Episode* episode) {
  using enum sim::EventKind;
  episode->contacts.push_back({{.kind = kGripperHolds, .arm = "left", .object = object}, 1, from});
  episode->contacts.push_back({{.kind = kGripperReleased, .arm = "left", .object = object}, 2, to});
}

}  // namespace smile::task
