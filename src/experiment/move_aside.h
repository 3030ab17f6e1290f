#pragma once

#include <filesystem>

#include "experiment/callbacks.h"

namespace smile::experiment {

/// Renames earlier results, which are never overwritten, to `NAME.1`, `NAME.2`, …, and reports the
/// new name as a message. Does nothing if there are none.
/// @throws std::runtime_error if they cannot be renamed.
void MoveAside(const std::filesystem::path& path, const Callbacks& callbacks);

}  // namespace smile::experiment
