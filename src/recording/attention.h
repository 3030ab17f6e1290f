#pragma once

#include <map>
#include <string>
#include <vector>

#include "recording/recording.h"

namespace smile::recording {

/// Of the objects of a demonstration, by id: which properties matter in the end, as was told last.
/// @throws InputError if the recording's trace cannot be read.
std::map<std::string, std::vector<std::string>> AttentionOf(const Recording& recording);

}  // namespace smile::recording
