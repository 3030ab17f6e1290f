#pragma once

#include <cstdint>
#include <optional>

#include "base/file_windows.h"
#include "recording/internal_trace_format.h"
#include "recording/trace.h"

namespace smile::recording {

/// Beginning of a record of a trace, and what follows from it.
struct RecordHead {
  std::uint64_t tick = 0, hash = 0;
  std::uint8_t flags = 0;
  std::uint64_t size = 0;       ///< of the whole record [bytes]
  TraceCounts counts;           ///< from this record on
  std::uint32_t num_moved = 0;  ///< objects in the record of a tick
  TracePlace past = 0;          ///< of a return: end of the records that precede it on its path
  std::uint64_t log_line = 0;   ///< of a return

  bool has(std::uint8_t flag) const { return (flags & flag) != 0; }
  bool is_tick() const { return flags != kIsReturn && flags != kIsEvent; }
  /// True if it contains the whole state, so that reading can begin with it.
  bool is_keyframe() const;
};

/// Reads the beginning of the record at a place.
/// @param counts  those of the record before; those of a keyframe are in itself.
/// @returns nullopt if the record is incomplete, as at the end of a recording that was interrupted.
std::optional<RecordHead> HeadAt(TracePlace place, const TraceCounts& counts,
                                 std::size_t num_joints, FileWindows* trace);

}  // namespace smile::recording
