// What joints of a World do before a step.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "physics/internal_engine.h"
#include "physics/internal_joint_groups.h"
#include "physics/world.h"

namespace smile::physics {
namespace {

/// Share of the speed that a soft slider keeps in this step: in the outer part of its way the speed
/// towards the limit falls in proportion to the way that remains.
double SoftShareKept(const SliderJointSpec& slider, double offset, double speed, double seconds) {
  const double middle = (slider.lower + slider.upper) / 2;
  const double half = (slider.upper - slider.lower) / 2;
  const double from_middle = std::abs(offset - middle);
  const double approach = offset > middle ? speed : -speed;
  const double remaining = half - from_middle;
  if (from_middle <= slider.softness * half || remaining <= 0 || approach <= 0) return 1;
  return 1 / (1 + approach * seconds / remaining);
}

/// What a carried body has to bear of another that hangs on it, as if the two were one.
double MomentAbout(const Body& carried, const Body& other) {
  const Vector3 arm = other.pose_in_world() * other.spec().mass.center -
                      carried.pose_in_world() * carried.spec().mass.center;
  // No axis has more than half the trace.
  return other.spec().mass.inertia.trace() / 2 + other.spec().mass.mass * arm.squaredNorm();
}

}  // namespace

void World::LoadCarriedBodies() {
  const bool is_any_carried = std::any_of(bodies_.begin(), bodies_.end(),
                                          [](const auto& one) { return one->is_carried(); });
  std::vector<std::pair<double, double>> loads(bodies_.size());  // mass, moment
  if (is_any_carried && !engine_->joints.empty()) {
    const JointGroups groups(bodies_, joints_, /*only_fixed=*/false);
    std::vector<std::vector<std::size_t>> carried_in(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (bodies_[i]->is_carried()) carried_in[groups.group_of(bodies_[i]->id())].push_back(i);
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      Body& one = *bodies_[i];
      if (one.is_static()) continue;
      for (std::size_t carried : carried_in[groups.group_of(one.id())]) {
        one.WakeUp();
        if (carried == i) continue;
        loads[carried].first += one.spec().mass.mass;
        loads[carried].second += MomentAbout(*bodies_[carried], one);
      }
    }
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i]->is_static()) bodies_[i]->Load(loads[i].first, loads[i].second);
  }
}

/// Of each group, as Bullet has it now; 0 when it is anchored.
std::vector<double> World::InverseMassesOf(const JointGroups& rigid) const {
  std::vector<double> masses(bodies_.size(), 0.0);
  for (const auto& one : bodies_) {
    masses[rigid.group_of(one->id())] += one->loaded_mass();
  }
  for (std::size_t i = 0; i < masses.size(); ++i) {
    masses[i] = rigid.is_anchored(static_cast<int>(i)) ? 0 : 1 / masses[i];
  }
  return masses;
}

void World::DampSliders() {
  std::optional<JointGroups> rigid;  // worked out when a slider moves
  std::vector<double> inverse_masses;
  for (const Joint& joint : joints_) {
    const auto* slider = std::get_if<SliderJointSpec>(&joint.spec);
    if (slider == nullptr) continue;
    const Body &a = body(slider->a), &b = body(slider->b);
    const bool is_carried = a.is_carried() || b.is_carried();
    JointConstraint& bullet = *engine_->joints.at(joint.id);
    bullet.HoldUnless(is_carried);
    if (slider->damping >= 1 && !is_carried) continue;
    const double speed = bullet.sliding_speed();
    if (speed == 0) continue;
    double kept = SoftShareKept(*slider, bullet.offset(), speed, config_.step_seconds);
    if (!is_carried) kept *= std::pow(1 - slider->damping, config_.step_seconds);
    if (kept == 1) continue;
    if (!rigid) {
      rigid.emplace(bodies_, joints_, /*only_fixed=*/true);
      inverse_masses = InverseMassesOf(*rigid);
    }
    const double inverse_mass =
        inverse_masses[rigid->group_of(slider->a)] + inverse_masses[rigid->group_of(slider->b)];
    if (inverse_mass > 0) bullet.Push(speed * (kept - 1) / inverse_mass);
  }
}

}  // namespace smile::physics
