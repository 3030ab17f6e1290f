#pragma once

#include <algorithm>
#include <variant>

#include "mechanics/body_spec.h"

namespace smile::mechanics {

/// Rolling resistance of balls, rollers and rings that have none of their own [m].
inline constexpr double kRollingResistance = 0.001;

/// Returns the rolling resistance of a body [m]. Without one of its own, every body but those of
/// blocks only has the usual one. Hulls count as round: the segments of a ring are hulls, and the
/// resistance does not disturb other hulls.
inline double RollingFrictionOf(const BodySpec& spec) {
  const bool is_round = std::ranges::any_of(spec.solids, [](const scene::Solid& solid) {
    return !std::holds_alternative<scene::Block>(solid.shape);
  });
  return spec.rolling_friction.value_or(is_round ? kRollingResistance : 0.0);
}

}  // namespace smile::mechanics
