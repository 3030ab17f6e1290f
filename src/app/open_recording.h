#pragma once

#include <string>

#include "recording/recording.h"

namespace smile::app {

/// Opens a recording, and reports on stderr incomplete parts that were dropped, and if another
/// version of the program made it.
/// @throws InputError as recording::OpenRecording().
recording::Recording OpenAndReport(const std::string& demo);

/// Checks an output path.
/// @throws InputError if a file or directory to be made would lie within a recording.
void RequireOutsideOfRecordings(const std::string& out);

}  // namespace smile::app
