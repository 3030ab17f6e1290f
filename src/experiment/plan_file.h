#pragma once

#include <filesystem>

#include "brain/brain_values.h"
#include "recording/recording.h"

namespace smile::experiment {

/// Reads what `smile analyze` found out about a demonstration, for a brain.
/// @param file  `analysis.json`
/// @throws InputError if it is damaged, of another format, or about another demonstration.
brain::TaskPlan ReadPlan(const std::filesystem::path& file,
                         const recording::Recording& demonstration);

}  // namespace smile::experiment
