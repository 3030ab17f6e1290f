#pragma once

#include <filesystem>

#include "report/evaluation.h"

namespace smile::report {

/// Reads an `evaluation.json`, of this version or an earlier one. The command that repeats a run is
/// not in it.
/// @param path  that file or its folder.
/// @throws InputError if it is missing or inconsistent.
Evaluation ReadEvaluation(const std::filesystem::path& path);

}  // namespace smile::report
