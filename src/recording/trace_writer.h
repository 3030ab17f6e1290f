#pragma once

#include <filesystem>
#include <optional>

#include "recording/append_file.h"
#include "recording/trace.h"

namespace smile::recording {

/// Writes `trace.bin`: look and render without physics. docs/recording-format.md describes every
/// byte.
///
/// A header names objects and joints. One record per tick follows, with what changed since the one
/// before, and between them one for each event. A return leads back to an earlier place, from where
/// the trace goes on: nothing is ever taken out.
class TraceWriter {
 public:
  /// @throws std::runtime_error with path and reason, as all members do.
  TraceWriter(const std::filesystem::path& path, const model::Model& model);
  /// Goes on with a trace whose first `size` bytes are whole, at some tick; what is behind them is
  /// cut off.
  TraceWriter(const std::filesystem::path& path, std::uint64_t size, std::uint64_t tick);

  void Add(const TraceTick& tick);
  void Add(const sim::Event& event);
  /// From here on the past is what was written before `place`.
  /// @param log_line  of the undo, redo or checkout in the recording's log.
  /// @param tick      of the moment there.
  void Return(TracePlace place, std::size_t log_line, std::uint64_t tick);

  TracePlace place() const { return file_.size(); }

 private:
  AppendFile file_;
  std::uint64_t tick_ = 0;         ///< of the last record
  std::optional<TraceTick> last_;  ///< what the next record tells the changes since; none: all
};

}  // namespace smile::recording
