#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/json.h"
#include "recording/append_file.h"

namespace smile::study {

/// Returns the time now (UTC) as `2026-05-01T12:00:00.123Z`.
std::string TimeText();

/// Events of a participant, `events.jsonl`: each line is an object with the members `at` (UTC) and
/// `event`. A line is with the operating system before the next one begins, so a killed server
/// loses nothing but a line that it was just writing.
class EventLog {
 public:
  /// Opens the log of a participant for writing; an incomplete last line is removed.
  /// @throws InputError as ReadEvents(), std::runtime_error if another server has it open.
  explicit EventLog(const std::filesystem::path& file);

  /// Appends an event that happens now.
  /// @param fields  further members.
  /// @returns the whole event.
  const Json& Add(const std::string& event, const Json& fields = Json::object());
  const std::vector<Json>& events() const { return events_; }

 private:
  recording::AppendFile file_;
  std::vector<Json> events_;
};

/// Reads all events; an incomplete last line does not count.
/// @param complete_bytes  receives the size of the complete lines, unless it is nullptr.
/// @throws InputError with the line that is no event.
std::vector<Json> ReadEvents(const std::filesystem::path& file,
                             std::size_t* complete_bytes = nullptr);

}  // namespace smile::study
