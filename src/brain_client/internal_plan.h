#pragma once

#include <optional>

#include "brain_client/brain.h"

namespace smile::brain_client {

/// Returns the plan of INIT; nullopt if the message has none.
/// @throws std::invalid_argument naming the field if the arrays do not fit together.
std::optional<Plan> PlanOf(const Fields& init);

}  // namespace smile::brain_client
