#pragma once

#include <vector>

#include "recording/recording_history.h"

namespace smile::recording {

/// Returns the history of an imported recording, which has no commands: the actions of its trace,
/// one after another, after the start.
/// @throws InputError if the recording's trace cannot be read.
std::vector<Segment> ImportedHistoryOf(const Recording& recording);

}  // namespace smile::recording
