#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/file_windows.h"
#include "recording/trace.h"

namespace smile::recording {

/// Entry of `trace.index`: the place of a record of the trace that readers look for.
struct TraceEntry {
  enum class Kind : std::uint8_t {
    kKeyframe = 1,  ///< complete state at a tick; reading can begin there
    kEvent = 2,
    kReturn = 3,
  };
  TracePlace place = 0;
  std::uint64_t tick = 0, hash = 0;  ///< as in the record
  Kind kind = Kind::kKeyframe;

  bool operator==(const TraceEntry&) const = default;
};

/// Returns the index that belongs to a trace: its neighbor `trace.index`.
std::filesystem::path TraceIndexOf(const std::filesystem::path& trace);

/// Return an entry, and a whole file, as bytes.
std::vector<std::byte> BytesOf(const TraceEntry& entry);
std::vector<std::byte> BytesOf(std::span<const TraceEntry> entries);

/// Returns the entries of an index, in the order of the trace. Entries beyond the end of the trace
/// are left out.
/// @returns nothing if there is no index, or if it is not one of this trace: it only repeats what
///          the trace contains, so readers go through the trace instead.
std::vector<TraceEntry> ReadTraceIndex(const std::filesystem::path& trace_path, FileWindows* trace);

}  // namespace smile::recording
