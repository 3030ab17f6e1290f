#pragma once

#include <filesystem>
#include <optional>

#include "recording/append_file.h"
#include "recording/trace.h"
#include "recording/trace_index.h"

namespace smile::recording {

class TraceReader;

/// Writer of `trace.bin`, from which a recording can be shown without physics.
/// docs/recording-format.md describes every byte.
///
/// A header names objects and joints. One record per tick follows, with what changed since the one
/// before, and between them one for each event. A return leads back to an earlier place, from where
/// the trace continues: nothing is ever removed. From time to time a record is complete: a
/// keyframe, at which a reader can begin. The index beside the trace names the places that readers
/// look for.
class TraceWriter {
 public:
  /// @throws std::runtime_error with path and reason, as all members do.
  TraceWriter(const std::filesystem::path& path, const model::Model& model);
  /// Continues a trace after its last complete record; bytes after it are cut off.
  /// @param tick  of the moment from which it continues.
  TraceWriter(const TraceReader& trace, std::uint64_t tick);

  void Add(const TraceTick& tick);
  void Add(const sim::Event& event);
  /// Writes a return: the following records continue from the state at `place`.
  /// @param log_line  of the undo, redo or checkout in the recording's log.
  /// @param tick      of the moment there.
  void Return(TracePlace place, std::size_t log_line, std::uint64_t tick);

  TracePlace place() const { return file_.size(); }

 private:
  /// Appends a record, and its entry in the index.
  void Append(const ByteWriter& record, const std::optional<TraceEntry>& entry);
  /// True if the next tick is to be a keyframe.
  bool IsKeyframeDue() const;

  AppendFile file_, index_;
  std::uint64_t tick_ = 0;         ///< of the last record
  std::optional<TraceTick> last_;  ///< to which the next record writes changes; nullopt: writes all
  TracePlace keyframe_place_ = 0;  ///< of the last keyframe
  std::uint64_t keyframe_size_ = 0;  ///< [bytes]
};

}  // namespace smile::recording
