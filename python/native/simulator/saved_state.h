#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "handle.h"

// Saved states as bytes, which a process of the same build reads.

namespace smile::python {

std::vector<std::byte> Serialize(const SavedState& state);

/// @throws std::invalid_argument if the bytes are not a state of a simulation of this model.
SavedState ParseSavedState(std::span<const std::byte> bytes,
                           const std::shared_ptr<const model::Model>& start_model);

}  // namespace smile::python
