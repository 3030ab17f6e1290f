// Actions of joints before a step that are not rows of the solver: loads of carried bodies, and
// damping and softness of sliders (docs/decisions/physics.md).

#include "physics/internal_joint_action.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "mechanics/carried_load.h"
#include "mechanics/rigid_masses.h"
#include "mechanics/slider_damping.h"
#include "physics/internal_body_dynamics.h"

namespace smile::physics {
namespace {

/// What a step can move: bodies and joints apart from dormant islands, by id.
struct Present {
  std::vector<Body*> bodies;  ///< with static ones that joints connect them with
  std::vector<Joint> joints;
};

Present PresentOf(const WorldObjects& objects, const JointSet& joints) {
  Present present;
  objects.ForEachPresent([&present](Body& body) { present.bodies.push_back(&body); });
  joints.ForEachPresent([&](const Joint& joint, const JointConstraint&) {
    present.joints.push_back(joint);
    const auto [a, b] = *BodyPairOf(joint.spec);
    for (const BodyId id : {a, b}) {
      if (objects.body(id).is_static()) present.bodies.push_back(&objects.body(id));
    }
  });
  std::ranges::sort(present.bodies, {}, &Body::id);
  present.bodies.erase(std::unique(present.bodies.begin(), present.bodies.end()),
                       present.bodies.end());
  return present;
}

mechanics::RigidMasses RigidMassesOf(const Present& present) {
  std::vector<mechanics::RigidMasses::Member> members;
  for (const Body* one : present.bodies) {
    members.push_back({one->id(), one->is_static(), one->dynamics().loaded_mass()});
  }
  return {members, present.joints};
}

/// Loads each carried body with all bodies of its group, whatever joints lie between them.
void LoadByJoints(const WorldObjects& objects, const JointSet& joints) {
  const auto [bodies, present_joints] = PresentOf(objects, joints);
  std::vector<mechanics::LoadMember> members;
  for (const Body* one : bodies) {
    const scene::MassProperties& mass = one->spec().mass;
    members.push_back({one->id(), one->is_static(), one->is_carried(), &mass,
                       one->pose_in_world() * mass.center});
  }
  const auto loads = mechanics::CarriedLoads(members, present_joints);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    // What hangs on a carried body must follow it, even if it is asleep.
    if (loads[i].is_with_carried) bodies[i]->WakeUp();
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i]->is_static()) bodies[i]->dynamics().Load(loads[i].mass, loads[i].moment);
  }
}

}  // namespace

void LoadCarriedBodies(const WorldObjects& objects, const JointSet& joints) {
  bool is_any_carried = false;
  objects.ForEachPresent(
      [&is_any_carried](const Body& one) { is_any_carried = is_any_carried || one.is_carried(); });
  if (is_any_carried && joints.has_constraints()) return LoadByJoints(objects, joints);
  // Bodies of dormant islands lost their load when they were released.
  objects.ForEachPresent([](Body& one) { one.dynamics().Load(0, 0); });
}

void DampSliders(const WorldObjects& objects, const JointSet& joints, double step_seconds) {
  std::optional<mechanics::RigidMasses> rigid;  // computed when a slider moves
  joints.ForEachPresent([&](const Joint& joint, JointConstraint& constraint) {
    const auto* slider = std::get_if<SliderJointSpec>(&joint.spec);
    if (slider == nullptr) return;
    const bool is_carried =
        objects.body(slider->a).is_carried() || objects.body(slider->b).is_carried();
    constraint.HoldUnless(is_carried);
    if (slider->damping >= 1 && !is_carried) return;
    const double speed = constraint.sliding_speed();
    if (speed == 0) return;
    const double kept =
        mechanics::FractionKept(*slider, constraint.offset(), speed, is_carried, step_seconds);
    if (kept == 1) return;
    if (!rigid) rigid = RigidMassesOf(PresentOf(objects, joints));
    // Equal and opposite impulses change the sliding speed by impulse (1/m_A + 1/m_B), where the
    // masses are those of everything rigidly fixed to either side.
    const double inverse_mass = rigid->InverseMassOf(slider->a) + rigid->InverseMassOf(slider->b);
    if (inverse_mass > 0) constraint.Push(speed * (kept - 1) / inverse_mass);
  });
}

}  // namespace smile::physics
