#include "world/presses.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

// Presses by contact. Forces chatter from step to step, so the pushes of a tick are summed, and a
// press ends only when the force on the control has been below half of its threshold for a while.

namespace smile::world {
namespace {

/// Fraction of the threshold below which a press ends.
constexpr double kRelease = 0.5;
/// Ticks for which the force must be below it: 0.1 s.
constexpr int kReleaseTicks = 6;

}  // namespace

struct Presses::Pushed {
  double any = 0;  ///< sum of all impulses on the control [N s]
  /// Impulses along the axes of what can be pressed, by the next state [N s].
  std::map<int, double> along;
  std::map<int, double> threshold;  ///< force for each [N]
  physics::BodyId by{};             ///< the strongest
  int by_link = -1;
  double strongest = 0;
};

Presses::Presses(physics::World* world, const model::Model& model,
                 const std::vector<Object>* objects, const ObjectStates* object_states)
    : world_(world),
      model_(&model),
      objects_(objects),
      object_states_(object_states),
      states_(model.controls().size()) {
  FindPressable();
}

void Presses::FindPressable() {
  pressable_.clear();
  if (model_->scene().physics_version < kPressVersion) return;
  for (const model::ObjectIndex object : model_->objects()) {
    if (model_->controls_of(object).size() == 0) continue;
    std::vector<scene::Solid> solids = scene::SolidsOf(model_->object(object).whole);
    const bool is_pressable = std::ranges::any_of(solids, [](const scene::Solid& solid) {
      return solid.trigger && solid.trigger->rule.cause == scene::TriggerCause::kPress;
    });
    if (is_pressable) pressable_.push_back({object, std::move(solids)});
  }
}

void Presses::Grow(const model::Model& model) {
  model_ = &model;
  states_.resize(model.controls().size());
  FindPressable();
}

void Presses::Restore(std::vector<PressState> states, const model::Model& model) {
  states_ = std::move(states);
  if (model_ == &model) return;
  model_ = &model;
  FindPressable();
}

void Presses::AfterStep() {
  if (pressable_.empty()) return;
  // In scene order, which is that of the bodies.
  std::vector<physics::BodyId> bodies;
  for (const Pressable& one : pressable_) {
    const Object& object = (*objects_)[one.object];
    if (world_->Has(object.body) && !(*object_states_)[one.object].has_fallen) {
      bodies.push_back(object.body);
    }
  }
  for (physics::Push& push : world_->PushesOn(bodies)) pushes_.push_back(push);
}

const scene::Solid* Presses::SolidOf(const Pressable& pressable, const physics::Push& push,
                                     const std::vector<int>& variants) {
  // The body has only the solids that are present, in the same order.
  std::size_t present = 0;
  for (const scene::Solid& solid : pressable.solids) {
    const bool is_present = solid.control < 0 || variants[solid.control] == solid.variant;
    if (is_present && present++ == push.solid) return &solid;
  }
  return nullptr;
}

Presses::Pushed Presses::Sum(const Pressable& pressable, int control,
                             const std::vector<int>& variants) const {
  Pushed pushed;
  std::map<std::pair<physics::BodyId, int>, double> by;
  for (const physics::Push& push : pushes_) {
    const physics::BodyId body = (*objects_)[pressable.object].body;
    if (push.body != body) continue;
    const scene::Solid* solid = SolidOf(pressable, push, variants);
    if (solid == nullptr || solid->control != control) continue;
    const double impulse = push.impulse_in_world.norm();
    pushed.any += impulse;
    double& of_one = by[{push.by_body, push.by_link}];
    of_one += impulse;
    if (of_one > pushed.strongest) {
      pushed.strongest = of_one;
      pushed.by = push.by_body;
      pushed.by_link = push.by_link;
    }
    if (!solid->trigger || solid->trigger->rule.cause != scene::TriggerCause::kPress) continue;
    const Vector3 inward =
        world_->body(body).pose_in_world().rotation() * solid->trigger->inward_in_body;
    const double along = push.impulse_in_world.dot(inward);
    if (along < impulse * std::cos(solid->trigger->rule.press_angle)) continue;
    pushed.along[solid->trigger->next_state] += along;
    pushed.threshold[solid->trigger->next_state] = solid->trigger->rule.press_force;
  }
  return pushed;
}

bool Presses::IsAsleep(const Pressable& pressable, const PressState& state) const {
  const auto sleeps = [this](physics::BodyId id) {
    if (!world_->Has(id)) return false;
    const physics::Body& body = world_->body(id);
    return !body.is_static() && !body.is_awake();
  };
  return sleeps((*objects_)[pressable.object].body) || sleeps(state.by);
}

std::vector<Press> Presses::AfterTick(double tick_seconds, Controls* controls) {
  std::vector<Press> presses;
  // The solids that were pushed are those of the states before: a press may change others, too.
  const std::vector<ControlState> before = controls->states();
  for (const Pressable& one : pressable_) {
    if (!world_->Has((*objects_)[one.object].body)) continue;
    const std::vector<int> variants = model_->VariantsOf(one.object, before);
    int number = 0;
    for (const model::ControlIndex control : model_->controls_of(one.object)) {
      PressState& state = states_[control];
      const Pushed pushed = Sum(one, number++, variants);
      if (state.is_pressed()) {
        // Once per press: it must be released before it can be pressed again.
        const bool is_quiet = pushed.any / tick_seconds < state.release_force;
        if (is_quiet && IsAsleep(one, state)) continue;
        state.quiet_ticks = is_quiet ? state.quiet_ticks + 1 : 0;
        if (state.quiet_ticks >= kReleaseTicks) state = {};
        continue;
      }
      for (const auto& [next_state, impulse] : pushed.along) {
        const double threshold = pushed.threshold.at(next_state);
        if (impulse / tick_seconds < threshold || !controls->Press(control, next_state)) continue;
        state = {.release_force = kRelease * threshold, .by = pushed.by};
        presses.push_back({.control = control, .by = pushed.by, .by_link = pushed.by_link});
        break;
      }
    }
  }
  pushes_.clear();
  return presses;
}

void Presses::AddToHash(StateHash* hash) const {
  // What is not pressed adds nothing, as in scenes of older versions.
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const PressState& state = states_[i];
    if (state == PressState()) continue;
    hash->Add(std::uint64_t{i});
    hash->Add(state.release_force);
    hash->Add(std::uint64_t{state.by.value});
    hash->Add(static_cast<std::uint64_t>(state.quiet_ticks));
  }
}

}  // namespace smile::world
