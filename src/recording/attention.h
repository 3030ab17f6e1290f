#pragma once

#include <map>
#include <string>
#include <vector>

#include "recording/recording.h"

namespace smile::recording {

/// Returns the properties of a demonstration's objects that matter, by object id, as last
/// specified.
/// @throws InputError if the recording's trace cannot be read.
std::map<std::string, std::vector<std::string>> AttentionOf(const Recording& recording);

}  // namespace smile::recording
