// What joints of a World do before a step.

#include <algorithm>
#include <cmath>
#include <optional>

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

}  // namespace

void World::ScaleCarriedInertia() {
  const bool is_any_carried = std::any_of(bodies_.begin(), bodies_.end(),
                                          [](const auto& one) { return one->is_carried(); });
  std::vector<double> scales(bodies_.size(), 1.0);
  if (is_any_carried && !engine_->joints.empty()) {
    const JointGroups groups(bodies_, joints_, /*only_fixed=*/false);
    std::vector<double> masses(bodies_.size(), 0.0);
    std::vector<bool> is_carried(bodies_.size(), false);
    for (const auto& one : bodies_) {
      const int group = groups.group_of(one->id());
      masses[group] += one->spec().mass.mass;
      if (one->is_carried()) is_carried[group] = true;
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      Body& one = *bodies_[i];
      const int group = groups.group_of(one.id());
      if (is_carried[group]) one.WakeUp();
      const double mass = one.spec().mass.mass;
      if (one.is_carried() && masses[group] != mass) scales[i] = masses[group] / mass;
    }
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i]->is_static()) bodies_[i]->ScaleInertia(scales[i]);
  }
}

/// Of each group, as Bullet has it now; 0 when it is anchored.
std::vector<double> World::InverseMassesOf(const JointGroups& rigid) const {
  std::vector<double> masses(bodies_.size(), 0.0);
  for (const auto& one : bodies_) {
    masses[rigid.group_of(one->id())] += one->spec().mass.mass * one->inertia_scale_;
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
