#pragma once

#include <string>
#include <string_view>

#include "classic/classic_reader.h"

namespace smile::fuzz {

/// What is wrong with how we take this text as the segments of a classic recording, one after the
/// other with a form feed between, in words; empty when all is well.
///
/// What is refused has a reason and a place. What is read can be shown: its placeholder objects
/// come back from their own scene file the same.
std::string FaultWithClassic(std::string_view text);

/// @throws InputError as classic::ReadClassicTexts() does.
classic::ClassicRecording ReadSegments(std::string_view text);

}  // namespace smile::fuzz
