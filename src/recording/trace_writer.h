#pragma once

#include <filesystem>
#include <optional>

#include "recording/append_file.h"
#include "recording/trace.h"

namespace smile::recording {

/// Writer of `trace.bin`, from which a recording can be shown without physics.
/// docs/recording-format.md describes every byte.
///
/// A header names objects and joints. One record per tick follows, with what changed since the one
/// before, and between them one for each event. A return leads back to an earlier place, from where
/// the trace continues: nothing is ever removed.
class TraceWriter {
 public:
  /// @throws std::runtime_error with path and reason, as all members do.
  TraceWriter(const std::filesystem::path& path, const model::Model& model);
  /// Continues a trace whose first `size` bytes are complete and end at `tick`; bytes after them
  /// are cut off.
  TraceWriter(const std::filesystem::path& path, std::uint64_t size, std::uint64_t tick);

  void Add(const TraceTick& tick);
  void Add(const sim::Event& event);
  /// Writes a return: the following records continue from the state at `place`.
  /// @param log_line  of the undo, redo or checkout in the recording's log.
  /// @param tick      of the moment there.
  void Return(TracePlace place, std::size_t log_line, std::uint64_t tick);

  TracePlace place() const { return file_.size(); }

 private:
  AppendFile file_;
  std::uint64_t tick_ = 0;         ///< of the last record
  std::optional<TraceTick> last_;  ///< to which the next record writes changes; nullopt: writes all
};

}  // namespace smile::recording
