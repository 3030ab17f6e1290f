// Actions of joints before a step that are not rows of the solver: loads of carried bodies, and
// damping and softness of sliders (docs/decisions/physics.md).

#include "physics/internal_joint_action.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "mechanics/joint_graph.h"
#include "physics/internal_body_dynamics.h"

namespace smile::physics {
namespace {

using mechanics::JointGroups;

JointGroups GroupsOf(const WorldObjects& objects, const JointSet& joints, bool only_fixed) {
  std::vector<JointGroups::Member> members;
  for (const auto& body : objects.bodies()) members.push_back({body->id(), body->is_static()});
  return {members, joints.joints(), only_fixed};
}

/// Returns the moment of inertia [kg m2] that another body adds to a carried one, as if the two
/// were one rigid body: an upper bound for all axes (parallel axis theorem).
double MomentAbout(const Body& carried, const Body& other) {
  const Vector3 arm = other.pose_in_world() * other.spec().mass.center -
                      carried.pose_in_world() * carried.spec().mass.center;
  // The moment about any axis is at most half the trace: the largest principal moment is at most
  // the sum of the other two.
  return other.spec().mass.inertia.trace() / 2 + other.spec().mass.mass * arm.squaredNorm();
}

/// Returns the fraction of the speed that a soft slider keeps in this step: in the outer part of
/// its range the speed towards the limit falls in proportion to the remaining displacement
/// (implicit Euler).
double SoftFractionKept(const SliderJointSpec& slider, double offset, double speed,
                        double seconds) {
  const double middle = (slider.lower + slider.upper) / 2;
  const double half = (slider.upper - slider.lower) / 2;
  const double from_middle = std::abs(offset - middle);
  const double approach = offset > middle ? speed : -speed;
  const double remaining = half - from_middle;
  if (from_middle <= slider.softness * half || remaining <= 0 || approach <= 0) return 1;
  return 1 / (1 + approach * seconds / remaining);
}

/// Returns the inverse mass [1/kg] of each group as loaded now; 0 for an anchored group.
std::vector<double> InverseMassesOf(const JointGroups& rigid, const WorldObjects& objects) {
  std::vector<double> masses(objects.bodies().size(), 0.0);
  for (const auto& one : objects.bodies()) {
    masses[rigid.group_of(one->id())] += one->dynamics().loaded_mass();
  }
  for (std::size_t i = 0; i < masses.size(); ++i) {
    // Infinite mass: the other side takes all of the change.
    masses[i] = rigid.is_anchored(static_cast<int>(i)) ? 0 : 1 / masses[i];
  }
  return masses;
}

/// Loads each carried body with all bodies of its group, whatever joints lie between them.
void LoadByJoints(const WorldObjects& objects, const JointSet& joints) {
  const auto& bodies = objects.bodies();
  const JointGroups groups = GroupsOf(objects, joints, /*only_fixed=*/false);
  std::vector<std::vector<std::size_t>> carried_in(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i]->is_carried()) carried_in[groups.group_of(bodies[i]->id())].push_back(i);
  }
  std::vector<std::pair<double, double>> loads(bodies.size());  // mass, moment
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body& one = *bodies[i];
    if (one.is_static()) continue;
    for (std::size_t carried : carried_in[groups.group_of(one.id())]) {
      // What hangs on a carried body must follow it, even if it is asleep.
      one.WakeUp();
      if (carried == i) continue;
      loads[carried].first += one.spec().mass.mass;
      loads[carried].second += MomentAbout(*bodies[carried], one);
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i]->is_static()) bodies[i]->dynamics().Load(loads[i].first, loads[i].second);
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
  std::optional<JointGroups> rigid;  // computed when a slider moves
  std::vector<double> inverse_masses;
  for (const Joint& joint : joints.joints()) {
    const auto* slider = std::get_if<SliderJointSpec>(&joint.spec);
    if (slider == nullptr) continue;
    const bool is_carried =
        objects.body(slider->a).is_carried() || objects.body(slider->b).is_carried();
    JointConstraint& constraint = joints.constraint(joint.id);
    constraint.HoldUnless(is_carried);
    if (slider->damping >= 1 && !is_carried) continue;
    const double speed = constraint.sliding_speed();
    if (speed == 0) continue;
    double kept = SoftFractionKept(*slider, constraint.offset(), speed, step_seconds);
    if (!is_carried) kept *= std::pow(1 - slider->damping, step_seconds);
    if (kept == 1) continue;
    if (!rigid) {
      rigid = GroupsOf(objects, joints, /*only_fixed=*/true);
      inverse_masses = InverseMassesOf(*rigid, objects);
    }
    // Equal and opposite impulses change the sliding speed by impulse (1/m_A + 1/m_B), where the
    // masses are those of everything rigidly fixed to either side.
    const double inverse_mass =
        inverse_masses[rigid->group_of(slider->a)] + inverse_masses[rigid->group_of(slider->b)];
    if (inverse_mass > 0) constraint.Push(speed * (kept - 1) / inverse_mass);
  }
}

}  // namespace smile::physics
