#include "mechanics/rail_state.h"

#include <algorithm>
#include <cmath>

namespace smile::mechanics {
namespace {

/// A held slider that is moved by more than this stays at its new offset [m].
constexpr double kMaxHeldError = 0.005;

}  // namespace

void RailState::HoldUnless(bool is_carried, double offset, const SliderJointSpec& rail) {
  const bool was_held = is_held;
  is_held = rail.damping >= 1 && !is_carried;
  // The number of rows changes: a pressed limit has no row while the slider is held.
  if (is_held != was_held) is_pressed = {};
  // While held, keep the offset: the solver corrects small deviations from it. Larger ones are
  // moves from outside: adopt them.
  if (!was_held || !is_held || std::abs(offset - held_offset) > kMaxHeldError) {
    held_offset = std::clamp(offset, rail.lower, rail.upper);
  }
}

void RailState::NoteImpulse(bool is_upper, double inwards, bool bounces) {
  // A limit counts as pressed only if it pushed inwards. One that had to pull is free again in the
  // next step, and a rebound must not be held.
  is_pressed[is_upper ? 1 : 0] = inwards > 0 && !bounces;
}

void RailState::Save(ByteWriter* out) const {
  out->Put(is_held);
  out->Put(held_offset);
  for (bool one : is_pressed) out->Put(one);
}

void RailState::Restore(ByteReader* in) {
  is_held = in->Get<bool>();
  held_offset = in->Get<double>();
  for (bool& one : is_pressed) one = in->Get<bool>();
}

}  // namespace smile::mechanics
