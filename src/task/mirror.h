#pragma once

#include "task/match.h"

namespace smile::task {

/// Returns the mirror image of a structure, left and right exchanged. Objects that are their own
/// mirror images, as blocks are, look as in a mirror.
Structure MirrorImageOf(Structure structure);

/// Returns true if a structure that fits after a turn fits as its mirror image without, or almost:
/// the letters U M were built as M U, each letter seen from behind.
/// @param turn  with which it fits [rad].
bool IsMirrored(const Structure& structure, const Episode& outcome, const Match& match,
                double turn);

}  // namespace smile::task
