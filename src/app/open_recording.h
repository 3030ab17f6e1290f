#pragma once

#include <optional>
#include <string>

#include "record/recording.h"
#include "sim/eye.h"

namespace smile::app {

/// Opens a recording, and tells on stderr what had to be left out, and that another version of the
/// program made it.
/// @throws InputError as record::OpenRecording().
record::Recording OpenAndTell(const std::string& demo);

/// The eye that took a recording's pictures; nullopt if it has none.
std::optional<sim::EyeSpec> EyeOf(const record::DemoInfo& info);

/// @throws InputError if a file or directory to be made would lie within a recording.
void RequireOutsideOfRecordings(const std::string& out);

}  // namespace smile::app
