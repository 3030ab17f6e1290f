#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "task/episode.h"

// Contacts of an episode as bytes, for its saved state.

namespace smile::python {

std::vector<std::byte> SerializeContacts(const std::vector<task::ContactEvent>& contacts);

/// @throws std::invalid_argument if the bytes are not contacts.
std::vector<task::ContactEvent> ParseContacts(std::span<const std::byte> bytes);

}  // namespace smile::python
