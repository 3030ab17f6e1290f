#include "recording/trace.h"

#include <algorithm>

#include "math/angles.h"

// Moments of a trace: made from a simulation, from the start of a model, or completed for a larger
// model. Everything that a view shows is in them, so views need no physics.

namespace smile::recording {

PoseGap GapBetween(const TracePose& from, const TracePose& to) {
  // The rotation vector between both orientations; its length is the angle [rad].
  const Vector3 turn =
      RotationVectorBetween(from.pose_in_world().quaternion(), to.pose_in_world().quaternion());
  return {.distance = (to.position - from.position).norm(), .angle = turn.norm()};
}

TracePose TracePose::At(const RigidTransform& X_WB, bool is_awake) {
  const Quaternion q = X_WB.quaternion();
  return {.is_awake = is_awake,
          .position = X_WB.translation(),
          // Not normalized again: these bits must read back as they are.
          .rotation = {q.w(), q.x(), q.y(), q.z()}};
}

TraceCounts CountsOf(const TraceTick& moment) {
  return {.objects = static_cast<std::uint32_t>(moment.objects.size()),
          .controls = static_cast<std::uint32_t>(moment.controls.size()),
          .bonds = static_cast<std::uint32_t>(moment.bonds.size())};
}

TraceTick Observe(const sim::Simulation& simulation) {
  TraceTick now{.tick = simulation.tick(),
                .hash = simulation.state_hash(),
                .is_robot_shown = simulation.is_robot_shown(),
                .face_expression = simulation.face_expression()};
  // A destroyed object keeps its index, so that indices are stable within a recording.
  now.objects.reserve(simulation.tabletop().objects().size());
  for (const world::Object& object : simulation.tabletop().objects()) {
    if (!simulation.tabletop().IsPresent(object)) {
      now.objects.push_back({.is_present = false});
      continue;
    }
    const physics::Body& body = simulation.physics().body(object.body);
    now.objects.push_back(TracePose::At(body.pose_in_world(), body.is_awake()));
  }
  now.controls = simulation.tabletop().controls().states();
  const auto& bonds = simulation.tabletop().bonds().states();
  now.bonds.assign(bonds.begin(), bonds.end());
  if (simulation.robot() != nullptr) now.joints = simulation.robot()->positions();
  return now;
}

// Objects that are added later have no entry in earlier ticks. All are added at the end.
TraceTick WithAbsent(TraceTick moment, const model::Model& model) {
  moment.objects.resize(model.objects().size(), TracePose{.is_present = false});
  moment.controls.resize(model.controls().size());
  moment.bonds.resize(model.hosts().size());
  return moment;
}

TraceTick StartOf(const model::Model& model) {
  const model::SceneState& start = model.initial_state();
  // Nothing is awake before the first step.
  TraceTick moment{.objects = {}, .controls = start.controls, .bonds = start.hosts};
  for (const auto& X_WB : start.X_WB) {
    moment.objects.push_back(TracePose::At(*X_WB, /*is_awake=*/false));
  }
  if (model.robot() != nullptr) moment.joints = model.robot()->q_start;
  return moment;
}

std::optional<model::Support> SupportAt(const TraceTick& moment, const std::string& id,
                                        const scene::SceneSpec& scene) {
  const auto object = std::ranges::find(scene.objects, id, &scene::ObjectSpec::id);
  std::vector<std::optional<RigidTransform>> X_WBs;
  for (const TracePose& pose : moment.objects) {
    X_WBs.push_back(pose.is_present ? std::optional(pose.pose_in_world()) : std::nullopt);
  }
  const auto index = static_cast<std::size_t>(object - scene.objects.begin());
  return model::SupportOf(scene, X_WBs, model::ObjectIndex(index));
}

}  // namespace smile::recording
