#pragma once

#include <filesystem>
#include <optional>

#include "base/json.h"
#include "brain/brain_driver.h"

namespace smile::experiment {

/// Limit of an imitation [s of simulated time].
inline constexpr double kMaxImitationSeconds = 600;

/// Options of the driver that follow from the brain itself, the demonstration it is given, and the
/// robot's eye.
/// @param demonstration  recording; empty for none.
/// @param eye            nullptr for a blind brain. Must outlive the driver.
/// @throws InputError if the demonstration cannot be opened.
brain::BrainDriverOptions DriverOptionsFor(const std::filesystem::path& brain,
                                           const std::filesystem::path& demonstration,
                                           sim::Eye* eye);

/// Returns `claim` of a result: {done, reason}; null without one.
Json ClaimJson(const std::optional<brain::Claim>& claim);

}  // namespace smile::experiment
