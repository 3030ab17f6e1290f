#include "recording/internal_trace_records.h"

namespace smile::recording {
namespace {

/// The longest beginning of a record: that of a return, or of a tick with counts.
constexpr std::size_t kLongestHead = kRecordHead + 2 * 8;
static_assert(kLongestHead >= kRecordHead + kCountsRecord + 4);

}  // namespace

bool RecordHead::is_keyframe() const {
  constexpr std::uint8_t kAll =
      kCountsChanged | kJointsChanged | kControlsChanged | kBondsChanged | kFaceExpressionChanged;
  return is_tick() && (flags & kAll) == kAll && num_moved == counts.objects;
}

// Records carry no length, except events: the size follows from flags and counts. The number of
// joints never changes.
std::optional<RecordHead> HeadAt(TracePlace place, const TraceCounts& counts,
                                 std::size_t num_joints, FileWindows* trace) {
  ByteReader in(trace->At(place, kLongestHead));
  RecordHead head{.tick = in.Get<std::uint64_t>(),
                  .hash = in.Get<std::uint64_t>(),
                  .flags = in.Get<std::uint8_t>(),
                  .size = kRecordHead,
                  .counts = counts};
  if (head.flags == kIsReturn) {
    head.past = in.Get<TracePlace>();
    head.log_line = in.Get<std::uint64_t>();
    head.size += 2 * 8;
  } else if (head.flags == kIsEvent) {
    head.size += 4 + std::uint64_t{in.Get<std::uint32_t>()};
  } else {
    if (head.has(kCountsChanged)) {
      head.counts = GetCounts(&in);
      head.size += kCountsRecord;
    }
    head.num_moved = in.Get<std::uint32_t>();
    head.size += 4 + kMovedObject * head.num_moved;
    if (head.has(kJointsChanged)) head.size += 8 * num_joints;
    if (head.has(kControlsChanged)) head.size += kControlRecord * head.counts.controls;
    if (head.has(kBondsChanged)) head.size += kBondRecord * head.counts.bonds;
    if (head.has(kFaceExpressionChanged)) head.size += kFaceExpressionRecord;
  }
  if (!in.ok() || head.size > trace->size() - place) return std::nullopt;
  return head;
}

}  // namespace smile::recording
