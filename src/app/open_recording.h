#pragma once

#include <string>

#include "recording/recording.h"

namespace smile::app {

/// Opens a recording, and tells on stderr what had to be left out, and that another version of the
/// program made it.
/// @throws InputError as recording::OpenRecording().
recording::Recording OpenAndTell(const std::string& demo);

/// @throws InputError if a file or directory to be made would lie within a recording.
void RequireOutsideOfRecordings(const std::string& out);

}  // namespace smile::app
