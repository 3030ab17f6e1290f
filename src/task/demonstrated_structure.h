#pragma once

#include "task/structure.h"

namespace smile::task {

/// Returns the structure that a demonstration achieved.
/// @throws InputError if the recording's trace cannot be read, or nothing was achieved.
Structure StructureOf(const recording::Recording& demonstration);

}  // namespace smile::task
