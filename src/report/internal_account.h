#pragma once

#include "recording/recording.h"
#include "report/markup.h"

namespace smile::report {

/// Returns what the robot's program noted about its work (sim::Note): what it understood, its plan,
/// and each action with what it expected to see and what it saw, drawn over pictures of the robot's
/// eye. Empty if it noted nothing.
/// @throws InputError if the recording's trace cannot be read; std::runtime_error if rendering is
///         unavailable.
Markup AccountOf(const recording::Recording& imitation);

}  // namespace smile::report
