#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "recording/trace_reader.h"

namespace smile::classic {

/// Frame of the classic view, a line of `frames.csv`.
struct FrameEntry {
  std::uint64_t tick = 0;
  std::string image;  ///< PNG file, from the recording's directory; empty for a frame without one
  int segment = 0;    ///< of the image
};

/// Reads `frames.csv` of a recording. An incomplete last line is ignored.
/// @returns the frames in order, each of a later tick than the one before.
/// @throws InputError naming the line, what was found and what was expected.
/// @throws std::runtime_error with path and reason if the file cannot be read.
std::vector<FrameEntry> ReadFrameIndex(const std::filesystem::path& csv);

/// Reads the tick of a frame from a trace.
/// @throws InputError if the trace has no such moment, or cannot be read.
recording::TraceTick ReadMomentOf(const FrameEntry& frame, const std::filesystem::path& csv,
                                  recording::TraceReader* trace);

}  // namespace smile::classic
