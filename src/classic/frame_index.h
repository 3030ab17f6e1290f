#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "recording/trace_reader.h"

namespace smile::classic {

/// A frame of the classic view, as `frames.csv` lists it.
struct FrameEntry {
  std::uint64_t tick = 0;
  std::string image;  ///< PNG file, from the recording's directory; empty for a frame without one
  int segment = 0;    ///< of the image
};

/// Reads `frames.csv` of a recording. A last line without its end is left out.
/// @returns the frames in order, each of a later tick than the one before.
/// @throws InputError naming the line, what was found and what was expected.
/// @throws std::runtime_error with path and reason if the file cannot be read.
std::vector<FrameEntry> ReadFrameIndex(const std::filesystem::path& csv);

/// Reads a trace on to the moment of a frame; frames are to be asked for in their order.
/// @throws InputError if the trace has no such moment, or cannot be read.
recording::TraceTick ReadMomentOf(const FrameEntry& frame, const std::filesystem::path& csv,
                                  recording::TraceReader* trace);

}  // namespace smile::classic
