#include "study/event_log.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <stdexcept>

#include "base/diagnostic.h"
#include "base/files.h"

namespace smile::study {
namespace {

constexpr std::size_t kMaxLogBytes = 64 << 20;

Json ParseEvent(const std::filesystem::path& file, int line, const std::string& text) {
  try {
    Json event = ParseJson(text);
    const bool is_event = event.is_object() && event.contains("event") &&
                          event["event"].is_string() && event.contains("at") &&
                          event["at"].is_string();
    if (is_event) return event;
  } catch (const std::invalid_argument&) {
    // The message below says what was expected.
  }
  throw InputError(
      Diagnostic{.file = file.string(),
                 .line = line,
                 .message = "expected an object with the members \"at\" and \"event\""});
}

}  // namespace

std::string TimeText() {
  const auto now = std::chrono::system_clock::now();
  const auto milliseconds =
      std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count();
  const auto seconds = static_cast<std::time_t>(milliseconds / 1000);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &utc);
  std::array<char, 8> fraction{};
  std::snprintf(fraction.data(), fraction.size(), ".%03dZ", static_cast<int>(milliseconds % 1000));
  return std::string(text.data()) + fraction.data();
}

EventLog::EventLog(const std::filesystem::path& file)
    : file_(file, recording::AppendFile::kExisting) {
  std::size_t complete_bytes = 0;
  events_ = ReadEvents(file, &complete_bytes);
  if (complete_bytes < file_.size()) file_.Cut(complete_bytes);
}

const Json& EventLog::Add(const std::string& event, const Json& fields) {
  Json line{{"at", TimeText()}, {"event", event}};
  line.update(fields);
  file_.Append(ToText(line) + "\n");
  return events_.emplace_back(std::move(line));
}

std::vector<Json> ReadEvents(const std::filesystem::path& file, std::size_t* complete_bytes) {
  const std::string text = ReadFile(file, kMaxLogBytes);
  std::vector<Json> events;
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    events.push_back(
        ParseEvent(file, static_cast<int>(events.size()) + 1, text.substr(begin, end - begin)));
  }
  if (complete_bytes != nullptr) *complete_bytes = begin;
  return events;
}

}  // namespace smile::study
