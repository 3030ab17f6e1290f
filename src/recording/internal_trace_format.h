#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "model/indices.h"
#include "recording/trace.h"
#include "sim/event.h"

namespace smile::recording {

inline constexpr std::array kTraceMagic = {'S', 'M', 'I', 'L', 'E', 'T', 'R', 'C'};
/// Version that is written; all versions from kOldestTraceVersion on can be read. Version 2 had no
/// events, no returns and no flag kIsAwake; version 3 had no face expressions; up to version 4, no
/// objects were added.
inline constexpr std::uint32_t kTraceVersion = 5, kOldestTraceVersion = 2;

// Flags of a record: its kind, and the parts it has besides tick, hash and moved objects.
inline constexpr std::uint8_t kJointsChanged = 1;
inline constexpr std::uint8_t kRobotHidden = 2;
inline constexpr std::uint8_t kControlsChanged = 4;
inline constexpr std::uint8_t kBondsChanged = 8;
inline constexpr std::uint8_t kIsReturn = 16;
inline constexpr std::uint8_t kIsEvent = 32;
inline constexpr std::uint8_t kFaceExpressionChanged = 64;
inline constexpr std::uint8_t kCountsChanged = 128;
inline constexpr std::uint8_t kTickFlags = 15 | kFaceExpressionChanged | kCountsChanged;

// Flags of an object in a record.
inline constexpr std::uint8_t kIsPresent = 1;
inline constexpr std::uint8_t kIsAwake = 2;

// Sizes in bytes.
inline constexpr std::uint64_t kRecordHead = 8 + 8 + 1;  ///< tick, hash, flags
inline constexpr std::uint64_t kSmallestTickRecord = kRecordHead + 4;
inline constexpr std::uint64_t kMovedObject = 4 + 1 + 7 * 8;
inline constexpr std::uint64_t kControlRecord = 3 * 4;
inline constexpr std::uint64_t kBondRecord = 2 * 4 + 1;
inline constexpr std::uint64_t kFaceExpressionRecord = 1;
inline constexpr std::uint64_t kCountsRecord = 3 * 4;

/// Keyframes are at least this far apart, except at the start, after a return, and when objects
/// were added [bytes]. Seeking reads about as much.
inline constexpr std::uint64_t kKeyframeBytes = 64 << 10;
/// Keyframes are also at least this many times their own size apart, so that they remain a small
/// part of the trace.
inline constexpr std::uint64_t kKeyframeSizes = 16;

/// Limit on the numbers of objects and of joints.
inline constexpr std::uint32_t kMaxNames = 1'000'000;
void PutNames(const std::vector<std::string>& names, ByteWriter* out);
/// Reads at most `max_count` names; the rest of a longer list remains unread.
std::vector<std::string> GetNames(std::uint32_t max_count, ByteReader* in);

void Put(const TraceCounts& counts, ByteWriter* out);
TraceCounts GetCounts(ByteReader* in);

/// Returns an index as traces store it; -1: none.
template <class I>
int NumberOf(const std::optional<I>& index) {
  return index ? static_cast<int>(*index) : -1;
}
/// Returns the index for a number in a trace; nullopt for negative numbers.
template <class I>
std::optional<I> IndexOf(int number) {
  return number < 0 ? std::nullopt : std::optional(I(static_cast<std::size_t>(number)));
}

void Put(const sim::Event& event, ByteWriter* out);
/// @param in  ends with the event.
/// @returns nullopt if it is cut short, or its kind or hand does not exist; texts and indices are
///          not checked.
std::optional<sim::Event> GetEvent(ByteReader* in);

}  // namespace smile::recording
