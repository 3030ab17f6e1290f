#pragma once

#include "editing/edit.h"

namespace smile::editing {

// Edits of what one hand does in some segments, while other hands do as before.

/// Performs the edit.
/// @param segment  the one with the number `shift.first`.
/// @throws std::invalid_argument if it is of no hand, or there is no room.
void PerformShift(const Shift& shift, const recording::EditableSegment& segment,
                  recording::Demonstration* demonstration);
/// Same as PerformShift() for the other edit.
void PerformStretch(const Stretch& stretch, const recording::EditableSegment& segment,
                    recording::Demonstration* demonstration);

}  // namespace smile::editing
