#include "record/trace.h"

#include "math/angles.h"

namespace smile::record {

PoseGap GapBetween(const TracePose& from, const TracePose& to) {
  const Vector3 turn =
      RotationVectorBetween(from.pose_in_world().quaternion(), to.pose_in_world().quaternion());
  return {.distance = (to.position - from.position).norm(), .angle = turn.norm()};
}

TraceTick Observe(const sim::Simulation& simulation) {
  TraceTick now{.tick = simulation.tick(),
                .hash = simulation.state_hash(),
                .is_robot_shown = simulation.is_robot_shown(),
                .mood = simulation.mood()};
  now.objects.reserve(simulation.tabletop().objects().size());
  for (const world::Object& object : simulation.tabletop().objects()) {
    if (!simulation.tabletop().IsPresent(object)) {
      now.objects.push_back({.is_present = false});
      continue;
    }
    const physics::Body& body = simulation.physics().body(object.body);
    const RigidTransform X_WB = body.pose_in_world();
    const Quaternion q = X_WB.quaternion();
    now.objects.push_back({.is_awake = body.is_awake(),
                           .position = X_WB.translation(),
                           .rotation = {q.w(), q.x(), q.y(), q.z()}});
  }
  now.controls = simulation.tabletop().controls().states();
  for (const world::BondState& bond : simulation.tabletop().bonds().states()) {
    now.bonds.push_back(
        {.guest = bond.guest, .tightness = bond.tightness, .is_locked = bond.is_locked});
  }
  if (simulation.robot() != nullptr) now.joints = simulation.robot()->positions();
  return now;
}

bool BeginsSegment(const sim::Event& event) {
  using enum sim::EventKind;
  if (!event.hand) return false;
  switch (event.kind) {
    case kGrasped:
    case kReleased:
    case kDestroyed:
    case kPointed:
    case kTriggered:
    case kFastened:
    case kLoosened:
      return true;
    default:
      return false;
  }
}

}  // namespace smile::record
