#pragma once

#include <optional>

#include "sim/drag.h"

namespace smile::studio {

/// Returns true if a body slides on another one: it is the second member of a slider.
bool IsOnRail(physics::BodyId body, const physics::World& world);

/// Returns the body that slides on this one and has not come to the end of its rail: a drawer that
/// can be opened further. Invalid if there is none.
physics::BodyId FindSlidingOn(physics::BodyId base, const physics::World& world);

/// Returns the motion of a drag of an object that slides on another, such as a lid or a drawer: to
/// the point of its way that is nearest to the mouse ray, between the ends of the rail. What it
/// slides on is neither pulled nor pushed. In a direction within 10 degrees of the rail, a ray
/// tells nothing, and the hand keeps its goal.
/// @returns nullopt unless the hand holds the second member of a slider.
std::optional<sim::MoveTo> MoveAlongRail(const sim::Drag& drag, const sim::Simulation& simulation);

}  // namespace smile::studio
