#pragma once

#include <filesystem>

namespace smile::app {

/// Results are never overwritten: what is there moves aside, to `NAME.1`, `NAME.2`, …, as is told
/// on stderr.
/// @throws std::runtime_error if it cannot.
void MoveAside(const std::filesystem::path& path);

}  // namespace smile::app
