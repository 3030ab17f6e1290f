#pragma once

#include <filesystem>

#include "brain/brain_driver.h"

namespace smile::experiment {

/// Limit of an imitation [s of simulated time].
inline constexpr double kMaxImitationSeconds = 600;

/// Options of the driver that follow from the brain itself and from the demonstration it is given.
/// @param demonstration  recording; empty for none.
/// @throws InputError if the demonstration cannot be opened.
brain::BrainDriverOptions DriverOptionsFor(const std::filesystem::path& brain,
                                           const std::filesystem::path& demonstration);

}  // namespace smile::experiment
